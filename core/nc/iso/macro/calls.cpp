// Calls of macros: G65, G66, G66.1, G67 and the codes that parameters turn into calls (manual 23.3).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/cycles/pocket.h"
#include "core/nc/iso/macro/arguments.h"
#include "core/nc/iso/macro/subprogram_words.h"
#include "core/nc/iso/program/control.h"

namespace proveout::nc {
namespace {

/// Is it a block that runs as itself while G66.1 is active: M98, M99, or G67, which ends the mode?
bool runsItself(const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const Word& w) {
    return (w.address == 'M' && (w.value == mcode::kCall || w.value == mcode::kReturn)) ||
           (w.address == 'G' && code10Of(w) == gcode::kMacroCancel);
  });
}

/// Is it a motion, behind which modal macros are called?
bool moves(const BlockPlan& plan) {
  if (plan.perform == nullptr || plan.governor == nullptr) return false;
  if (plan.governor->group != kOneShot) return true;
  constexpr std::array<std::int32_t, 6> kMoving{gcode::kReference,     gcode::kNumberedReference,
                                                gcode::kSkip,          gcode::kThread,
                                                gcode::kMeasureLength, gcode::kMachineMove};
  return std::find(kMoving.begin(), kMoving.end(), plan.governor->code10) != kMoving.end();
}

}  // namespace

/// What the block in hand calls instead of being executed; kNone: nothing. `statement` tells that it stands
/// behind IF.
bool IsoControl::findCall(bool statement, MacroCall& call) {
  IsoContext& c = context_;
  const Block& block = c.block;
  if (block.kind != LineKind::kBlock || c.data_input != nullptr) return false;
  c.systems.update(c.parameters);
  call = MacroCall();
  const bool any_g = c.systems.anyG();
  for (const Word& w : block.words) {
    if (w.address != 'G') continue;
    const std::int32_t code10 = code10Of(w);
    const bool explicit_call =
        code10 == gcode::kMacroCall || code10 == gcode::kMacroAfterMotions || code10 == gcode::kMacroOfBlocks;
    if (!explicit_call && !(any_g && c.systems.g(code10, call.system) && mayCall(c, call.system.code)))
      continue;
    call.word = &w;
    call.code10 = explicit_call ? code10 : MacroCall::kSystem;
    return true;
  }
  if (c.systems.anyMMacro() && !block.words.empty() && findMMacro(call)) return true;
  if (c.modals.none() || statement || block.empty() || runsItself(block)) return false;
  call.modal = c.modals.find(CallKind::kBlockMacro, c.calls);
  return call.modal != nullptr && !SubprogramWords::any(c);
}

bool IsoControl::findMMacro(MacroCall& call) {
  IsoContext& c = context_;
  const Word& first = c.block.words.front();
  if (first.address != 'M' || !c.systems.mMacro(mNumber(first), call.system) || !mayCall(c, call.system.code))
    return false;
  call.word = &first;
  call.code10 = MacroCall::kSystem;
  return true;
}

Go IsoControl::callMacro(const MacroCall& call) {
  IsoContext& c = context_;
  run_.blockDone();
  if (!c.systems.fault().empty()) {
    c.fail("parameter", c.systems.fault());
    return alarm();
  }
  if (call.modal != nullptr) return callFromBlock(*call.modal);
  CallFrame frame;
  const bool good = call.code10 == MacroCall::kSystem ? systemFrame(call, frame) : explicitFrame(call, frame);
  if (!good) return alarm();
  if (frame.kind == CallKind::kMacro || frame.kind == CallKind::kSystem) return open(frame);
  if (!c.modals.activate(frame)) {
    c.fail(SharedAlarm::kModalNesting, fmt::format("more than {} modal macros are active", kMaxNesting));
    return alarm();
  }
  c.state.active[kGroupMacro] =
      frame.kind == CallKind::kModalMacro ? gcode::kMacroAfterMotions : gcode::kMacroOfBlocks;
  return frame.kind == CallKind::kModalMacro ? Go::kOn : open(c.modals.last());
}

bool IsoControl::mayNest(const CallFrame& frame) {
  IsoContext& c = context_;
  const bool macro = opensLocals(frame.kind);
  const MacroParam key = macro ? MacroParam::kMacroNesting : MacroParam::kSubNesting;
  const double most = c.parameters[key];
  if (most == 0.0) return true;
  double open = 0.0;
  for (std::size_t level = c.calls.depth(); level-- > 1;)
    open += opensLocals(c.calls.at(level).kind) == macro;
  if (open < most) return true;
  return c.fail(SharedAlarm::kNesting,
                fmt::format("{} are nested deeper than {} ({})", macro ? "macro calls" : "subprogram calls",
                            most, c.parameters.name(key)));
}

Go IsoControl::open(const CallFrame& frame) {
  IsoContext& c = context_;
  if (c.calls.depth() > kMaxNesting) {
    c.fail(SharedAlarm::kNesting, fmt::format("subprogram calls are nested deeper than {}", kMaxNesting));
    return alarm();
  }
  if (!mayNest(frame)) return alarm();
  return run_.call(frame, static_cast<int>(frame.total));
}

/// The frame of G65, G66 and G66.1.
bool IsoControl::explicitFrame(const MacroCall& call, CallFrame& frame) {
  IsoContext& c = context_;
  const Word* l = c.word('L');
  if (l && !integerWord(c, *l, 1, 99999999, frame.total)) return false;
  if (c.block.has_file && call.code10 != gcode::kMacroCall) {
    return c.alarm(SharedAlarm::kIllegalAddress, "<>", gName(call.code10) + " calls by number only",
                   c.block.file_columns);
  }
  ArgumentRules rules;
  rules.call = call.word;
  rules.weak = "GPL";
  if (!collectArguments(c, rules, frame.args)) return false;
  frame.kind = call.code10 == gcode::kMacroCall           ? CallKind::kMacro
               : call.code10 == gcode::kMacroAfterMotions ? CallKind::kModalMacro
                                                          : CallKind::kBlockMacro;
  const Word* p = c.word('P');
  if (call.code10 == gcode::kMacroCall && p != nullptr && p->value == kPocketProgram && !c.block.has_file &&
      c.programs.byNumber(c.calls.top().file, kPocketProgram).text == nullptr) {
    return pocketFrame(c, frame);
  }
  return loadCalled(frame, gName(call.code10), c.calls.top().file);
}

/// The frame of a G or M code that parameters turn into a call.
bool IsoControl::systemFrame(const MacroCall& call, CallFrame& frame) {
  IsoContext& c = context_;
  ArgumentRules rules;
  rules.call = call.word;
  const bool is_g = isSystemG(call.system.code);
  if (is_g) rules.weak = "G";
  const Word* l = c.dialect.arguments != nullptr ? c.word('L') : nullptr;
  if (l && !integerWord(c, *l, 1, 99999999, frame.total)) return false;
  if (c.block.has_file)
    return c.alarm(SharedAlarm::kIllegalAddress, "<>", "a file name belongs to M98 and G65",
                   c.block.file_columns);
  if (!collectArguments(c, rules, frame.args)) return false;
  frame.system_code = call.system.code;
  frame.kind = !call.system.modal                                   ? CallKind::kSystem
               : c.parameters.flag(MacroParam::kModalFromEachBlock) ? CallKind::kBlockMacro
                                                                    : CallKind::kModalMacro;
  return takeProgram(c, c.programs.system(call.system.program, c.channel()), frame);
}

/// G66.1 is active: the block is a list of arguments.
Go IsoControl::callFromBlock(const CallFrame& modal) {
  IsoContext& c = context_;
  CallFrame frame = modal;
  frame.args = Arguments();
  if (c.block.has_file) {
    c.alarm(SharedAlarm::kIllegalAddress, "<>", "a file name is no argument", c.block.file_columns);
    return alarm();
  }
  ArgumentRules rules;
  rules.of_block = true;
  return collectArguments(c, rules, frame.args) ? open(frame) : alarm();
}

/// Puts off the calls that the block brings along: the modal macro after a motion, then the subprograms that
/// stand in it as M codes or letters.
void IsoControl::deferCalls(const BlockPlan& plan) {
  IsoContext& c = context_;
  if (plan.by_group[kGroupMacro] != nullptr) {  // G67
    c.modals.cancel();
    const bool any = !c.modals.none();
    c.state.active[kGroupMacro] = !any                                            ? gcode::kMacroCancel
                                  : c.modals.last().kind == CallKind::kModalMacro ? gcode::kMacroAfterMotions
                                                                                  : gcode::kMacroOfBlocks;
  }
  if (!c.modals.none() && moves(plan)) {
    if (const CallFrame* modal = c.modals.find(CallKind::kModalMacro, c.calls)) c.calls.defer(*modal);
  }
  subprograms_.defer(c);
}

}  // namespace proveout::nc
