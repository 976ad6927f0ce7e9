// M96, M97 and the interrupt macro (manual 23.4). The signal comes where the settings say so: at the end of
// blocks of the main program.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/program/control.h"
#include "core/nc/iso/system_variables/modal_bank.h"

namespace proveout::nc {

/// Takes the program of M96 out of the block. False: it was not found, reported.
bool IsoControl::takeInterruptWords() {
  IsoContext& c = context_;
  interrupt_switch_ = InterruptSwitch::kNone;
  if (!c.block.present.has('M') || c.dialect.rules.local_call >= 0) return true;
  c.m_index.update(c.parameters);
  const bool off = !c.parameters.flag(MacroParam::kInterrupts);
  for (const Word& w : c.block.words) {
    if (w.address != 'M') continue;
    if (off && (w.value == mcode::kInterruptOn || w.value == mcode::kInterruptOff)) {
      c.warnOnce(
          "interrupts-off", "interrupt",
          fmt::format("M96 and M97 are functions of the machine builder: interrupt macros are off ({})",
                      c.parameters.nameWith(MacroParam::kInterrupts, 0)),
          w.columns);
    }
    const InterruptSwitch wanted = c.m_index.find(mNumber(w)).interrupt;
    const bool ends = wanted == InterruptSwitch::kOff || (off && w.value == mcode::kInterruptOff);
    if (const Word* p = c.word('P'); ends && p != nullptr && !c.block.present.has('G')) {
      return c.alarm(SharedAlarm::kIllegalAddress, *p,
                     "M97 switches the interrupt macro off here; other controls call the part of this "
                     "program from block "
                     "N of that number on with it: make a file of it and call that with M98 P");
    }
    if (wanted != InterruptSwitch::kNone) interrupt_switch_ = wanted;
  }
  if (interrupt_switch_ != InterruptSwitch::kOn) return true;
  // The program lies beside the main program, wherever M96 stands, or among the system macros.
  CallFrame& frame = interrupt_frame_;
  frame = CallFrame();
  frame.interrupt = true;
  frame.kind =
      c.parameters.flag(MacroParam::kInterruptAsSubprogram) ? CallKind::kSubprogram : CallKind::kInterrupt;
  std::int64_t number = 0;
  const Word* p = c.word('P');
  if (c.parameters.flag(MacroParam::kInterruptFromSystem) && p != nullptr && !c.block.has_file) {
    if (!integerWord(c, *p, 1, 9999, number) ||
        !takeProgram(c, c.programs.system(number, c.channel()), frame))
      return false;
  } else if (!loadCalled(frame, "M96", c.calls.main().file)) {
    return false;
  }
  std::erase_if(c.block.words, [](const Word& w) { return w.address == 'P'; });
  c.block.present = c.block.present.without("P");
  c.block.has_file = false;
  return true;
}

void IsoControl::switchInterrupt() {
  InterruptMacro& interrupt = context_.interrupt;
  if (interrupt_switch_ == InterruptSwitch::kNone) return;
  interrupt.enabled = interrupt_switch_ == InterruptSwitch::kOn;
  if (interrupt.enabled) interrupt.frame = interrupt_frame_;
}

/// Behind a block without program flow: M96 and M97 take effect, and the signal may come.
Go IsoControl::followInterrupts() {
  IsoContext& c = context_;
  switchInterrupt();
  if (interrupt_switch_ == InterruptSwitch::kOff && c.interrupt.resumed) return breakInterruptOff();
  const std::vector<std::int64_t>& signals = c.settings.interrupt_blocks;
  const bool signal = !signals.empty() && c.calls.depth() == 1 && c.block.number >= 0 &&
                      std::find(signals.begin(), signals.end(), c.block.number) != signals.end();
  if (!signal || c.interrupt.resumed) return Go::kOn;
  if (!c.interrupt.enabled) {
    c.warn("interrupt", "the interrupt signal comes here, but M96 has enabled no interrupt macro");
    return Go::kOn;
  }
  if (!c.parameters.flag(MacroParam::kInterruptAtBlockEnd)) {
    c.warnOnce(
        "interrupt-at-once", "interrupt",
        fmt::format("the interrupt macro would start inside the block ({}): it starts at the block's end",
                    c.parameters.nameWith(MacroParam::kInterruptAtBlockEnd, 0)));
  }
  c.interrupt.resumed = c.state;
  c.interrupt.words = c.origins.slots();
  c.interrupt.cycle_start = c.cycle_start;
  c.interrupt.data = c.origins.data();
  c.interrupted = InterruptedBlock{c.state, programNumber(c.calls.top().text->name())};
  return open(c.interrupt.frame);
}

/// M97 inside the interrupt macro.
Go IsoControl::breakInterruptOff() {
  IsoContext& c = context_;
  while (c.calls.depth() > 2 && !c.calls.top().interrupt) c.closeCall();
  return c.calls.top().interrupt ? returnFrom(FlowRequest{.code = mcode::kReturn}) : Go::kOn;
}

namespace {

/// The words of the interrupted program are in force again; axes and tool stay where the macro has left them.
void restoreWords(IsoContext& c) {
  const KindSet stay = kAxisKinds | KindSet::of(OriginKind::kTool, OriginKind::kSpindleDirection);
  c.origins.restore(c.interrupt.words, stay);
  c.word_patterns.last = nullptr;
  c.cycle_start = c.interrupt.cycle_start;
  DataInForce data = c.interrupt.data;
  data.tool = c.state.tool;
  c.origins.setData(data);
  recordFrames(c, c.state);
}

}  // namespace

/// The interrupt macro is over; with `restore` the modals of the interrupted program are in force again.
bool IsoControl::endInterrupt(bool restore) {
  IsoContext& c = context_;
  const IsoState resumed = *std::exchange(c.interrupt.resumed, std::nullopt);
  c.interrupted.reset();
  if (!restore) return true;
  if (!c.flushPipe()) return false;
  const IsoState now = std::exchange(c.state, resumed);
  c.state.spindle_direction = now.spindle_direction;  // what the machine does is no modal
  c.state.tool = now.tool;
  c.state.tool_row = now.tool_row;
  restoreWords(c);
  c.map = programMap(c.state.transforms, c.axes);
  c.chain = c.chainOf(c.state);
  c.position = c.chain.programOf(c.machine);
  c.rebasePipe();
  return true;
}

}  // namespace proveout::nc
