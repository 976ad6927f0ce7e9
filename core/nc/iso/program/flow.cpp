// Program flow: M98, M99, M2, M30, jumps (manual 14.4).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/output.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/macro/subprogram_words.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/iso/program/reset.h"
#include "core/nc/iso/system_variables/status_bank.h"
#include "core/nc/text/program_heads.h"
#include "core/nc/text/program_likeness.h"

namespace proveout::nc {
namespace {

/// "\sub\part.nc" or "..\x.nc" as the program writes it -> with '/', without a leading one (manual 14.4.2:
/// a leading separator is relative to the caller's folder as well).
std::string callPath(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::string path(text);
  std::replace(path.begin(), path.end(), '\\', '/');
  const auto first = path.find_first_not_of('/');
  return first == std::string::npos ? std::string() : path.substr(first);
}

/// File name argument of M98 (manual 14.4.2).
constexpr std::size_t kMaxFileArgument = 60;

}  // namespace

Go IsoControl::flow(const BlockPlan& plan) {
  IsoContext& c = context_;
  if (plan.flow->code == c.dialect.rules.local_call) return callLocal();
  if (plan.flow->phase == MPhase::kCall && plan.flow->code != mcode::kReturn) return call(plan.flow->code);
  FlowRequest request;
  request.code = plan.flow->code;
  // A jump that fails leaves nowhere to go on: it always stops the run.
  if (request.code == mcode::kReturn && !returnWords(request)) return stopAtAlarm();
  if (!c.calls.hasDeferred()) return flow(request);
  request.line = c.calls.lineIndex();
  request.number = c.block.number;
  c.calls.top().waiting = request;
  return Go::kOn;
}

Go IsoControl::flow(const FlowRequest& request) {
  const SourceText& text = *context_.calls.top().text;
  const bool returns = request.code == mcode::kReturn;
  // Behind M99 the text goes on wherever something jumps to; it may be asked very often.
  const bool open_ended = !language_ && !context_.dialect.lexing.comments_end_in_line;
  if (open_ended && (!returns || lexer_.inComment())) {
    if (const auto open = commentOpenAtEnd(text.lines(), context_.calls.lineIndex()))
      return commentLeftOpen(open);
  }
  if (returns) return returnFrom(request);
  countPart(context_, request.code);
  return run_.finish(fmt::format("M{}", request.code), ProgramEnd::kEndOfProgram);
}

bool IsoControl::flush(ProgramEnd /*end*/) {
  IsoContext& c = context_;
  if (!c.pipe.flush(FlushReason::kEnd) || !endOutput(c)) return false;
  c.state.automatic = {};
  return true;
}

void IsoControl::sendEnd(const std::string& code) {
  IsoContext& c = context_;
  c.emitter.event(event::End{code}, 0.0, c.here());
  if (summary_.end == ProgramEnd::kEndOfProgram && code != "M99") resetAtEnd(c);
}

Go IsoControl::stopAtAlarm() {
  summary_.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

Go IsoControl::alarm() { return run_.failed(); }

namespace {

/// The line, from 1, on which the program of that number begins inside a text; 0: on none.
std::size_t lineOfProgram(const SourceText& text, std::int64_t number) {
  for (const ProgramHead& head : programHeads(text.lines())) {
    if (head.number == number) return head.line + 1;
  }
  return 0;
}

/// What other controls would find: programs behind the main one in its file, repeats in front of the number.
std::string whereItIs(const SourceText& text, std::int64_t number) {
  constexpr std::int64_t kFourDigits = 10000;
  if (const std::size_t line = lineOfProgram(text, number); line > 0) {
    return fmt::format("; O{} is in this file, on line {}: this control wants it as a file of its own",
                       number, line);
  }
  if (number < kFourDigits || number % kFourDigits == 0) return {};
  return fmt::format("; for O{} {} times, as other controls read it, write P{} L{}", number % kFourDigits,
                     number / kFourDigits, number % kFourDigits, number / kFourDigits);
}

}  // namespace

bool IsoControl::loadCalled(CallFrame& frame, std::string_view code, std::uint32_t caller) {
  IsoContext& c = context_;
  const Word* p = c.word('P');
  if (c.block.has_file) {
    if (p) return c.alarm(SharedAlarm::kIllegalAddress, *p, fmt::format("{} takes P or a file name", code));
    const std::string path = callPath(c.block.file_arg);
    if (path.empty() || c.block.file_arg.size() > kMaxFileArgument) {
      return c.fail(SharedAlarm::kOutOfRange,
                    fmt::format("file name data out of range: {} takes 1 to 60 characters", code),
                    c.block.file_columns);
    }
    return takeProgram(c, c.programs.byPath(caller, path), frame);
  }
  std::int64_t number = 0;
  if (p == nullptr) {
    const bool by_file = code[0] == 'M' || code == "G65";
    return c.alarm(SharedAlarm::kMissingData, "P",
                   fmt::format("{} needs a program number{}", code, by_file ? " or a file name" : ""));
  }
  if (!integerWord(c, *p, 1, 99999999, number)) return false;
  ProgramStore::Loaded loaded = c.programs.byNumber(caller, number);
  if (loaded.failure == ProgramStore::Failure::kNotFound)
    loaded.message += whereItIs(*c.calls.top().text, number);
  return takeProgram(c, loaded, frame);
}

bool IsoControl::subprogramFrame(int code, CallFrame& frame) {
  IsoContext& c = context_;
  SubprogramCall call;
  if (!c.dialect.subprogram(c, code, call)) return false;
  frame.total = call.count;
  const CallFrame& caller = c.calls.top();
  if (call.local) {
    frame.setProgram(*caller.text, caller.file);
  } else if (call.number < 0) {
    if (!loadCalled(frame, fmt::format("M{}", code), caller.file)) return false;
  } else if (!takeProgram(c, c.programs.byNumber(caller.file, call.number, call.folders_first), frame)) {
    return false;
  }
  if (call.block < 0) return true;
  const SourceText::Label label = frame.text->label(call.block);
  if (label.line_index == SourceText::kNoLabel) {
    return c.fail(SharedAlarm::kBlockNotFound, fmt::format("number not found: there is no block N{} in {}",
                                                           call.block, frame.text->name()));
  }
  frame.first = static_cast<std::size_t>(label.line_index);
  return true;
}

Go IsoControl::call(int code) {
  IsoContext& c = context_;
  CallFrame frame;
  frame.kind = CallKind::kSubprogram;
  if (c.dialect.subprogram != nullptr) {
    if (!subprogramFrame(code, frame)) return alarm();
    if (frame.total == 0) return Go::kOn;
  } else {
    const Word* l = c.word('L');
    if (l && !integerWord(c, *l, 1, 99999999, frame.total)) return alarm();
    if (!loadCalled(frame, "M98", c.calls.top().file)) return alarm();
  }
  if (!c.calls.hasDeferred()) return open(frame);
  c.calls.defer(frame);
  return Go::kOn;
}

Go IsoControl::callLocal() {
  IsoContext& c = context_;
  CallFrame frame;
  frame.kind = CallKind::kSubprogram;
  const std::string name = fmt::format("M{}", c.dialect.rules.local_call);
  const Word* p = c.word('P');
  const Word* l = c.word('L');
  std::int64_t block = 0;
  if (p == nullptr) {
    c.alarm(SharedAlarm::kMissingData, "P", name + " needs the number of a block of this program");
    return alarm();
  }
  if (!integerWord(c, *p, 1, 99999999, block)) return alarm();
  if (l && !integerWord(c, *l, 0, 99999999, frame.total)) return alarm();
  const CallFrame& caller = c.calls.top();
  frame.setProgram(*caller.text, caller.file);
  const SourceText::Label label = frame.text->label(block, 0);
  if (label.line_index == SourceText::kNoLabel) {
    c.fail(SharedAlarm::kBlockNotFound,
           fmt::format("block N{} not found: {} calls a part of {}", block, name, frame.text->name()),
           p->columns);
    return alarm();
  }
  if (label.repeated) warnRepeated(caller, block, 0);
  if (frame.total == 0) {
    c.warnOnce("call-none", "call-none", name + " L0 calls nothing");
    return Go::kOn;
  }
  frame.first = static_cast<std::size_t>(label.line_index);
  if (!c.calls.hasDeferred()) return open(frame);
  c.calls.defer(frame);
  return Go::kOn;
}

bool IsoControl::jump(CallFrame& frame, std::int64_t block, std::size_t from, SharedAlarm missing) {
  IsoContext& c = context_;
  const SourceText::Label label = frame.text->label(block, from);
  if (label.line_index == SourceText::kNoLabel) {
    return c.fail(missing, fmt::format("block N{} not found: {}", block, frame.text->name()));
  }
  if (label.repeated) warnRepeated(frame, block, from);
  frame.next = static_cast<std::size_t>(label.line_index);
  frame.more_from = 0;
  if (frame.next == 0) tape_.skipLeader(c, frame);
  lexer_.setInComment(false);
  return true;
}

void IsoControl::warnRepeated(const CallFrame& frame, std::int64_t block, std::size_t from) {
  IsoContext& c = context_;
  if (!repeated_told_.insert({frame.file, block}).second) return;
  c.warn("repeated-n", fmt::format("block number N{} occurs more than once: the {} one is taken", block,
                                   from == 0 ? "first" : "next"));
}

/// P and L of M99.
bool IsoControl::returnWords(FlowRequest& request) {
  IsoContext& c = context_;
  const Word* p = c.word('P');
  const Word* l = c.word('L');
  if (p && !integerWord(c, *p, 1, 99999999, request.block)) return false;
  if (l && !integerWord(c, *l, 0, 99999999, request.count)) return false;
  if (l && c.calls.depth() == 1)
    return c.alarm(SharedAlarm::kIllegalAddress, *l, "M99 of a main program takes P only");
  return true;
}

Go IsoControl::returnFrom(const FlowRequest& request) {
  IsoContext& c = context_;
  CallFrame& frame = c.calls.top();
  if (c.calls.depth() == 1) {
    if (request.block >= 0) return jump(frame, request.block) ? Go::kOn : stopAtAlarm();
    const double passes = std::max(1.0, c.parameters[MacroParam::kMainPasses]);
    if (++main_passes_ < passes) {
      frame.next = frame.first;
      tape_.skipLeader(c, frame);
      lexer_.setInComment(false);
      return Go::kOn;
    }
    c.warn("main-m99",
           passes > 1.0 ? fmt::format("M99 in the main program starts it again: {} passes are simulated ({})",
                                      passes, c.parameters.name(MacroParam::kMainPasses))
                        : "M99 in the main program starts it again: one pass is simulated",
           {}, Severity::kNote);
    return run_.finish("M99", ProgramEnd::kEndOfProgram);
  }
  if (request.count >= 0) frame.call.repetitions = static_cast<int>(request.count) + 1;
  if (request.block >= 0) frame.return_block = request.block;
  if (frame.call.again()) return Go::kReturn;
  const std::int64_t back = frame.return_block;
  if (frame.interrupt && !endInterrupt(back < 0)) return stopAtAlarm();
  if (back >= 0 && !jump(c.calls.at(c.calls.depth() - 2), back)) return stopAtAlarm();
  return Go::kReturn;
}

}  // namespace proveout::nc
