// The run loop of a control that reads its lines itself.
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/program/control.h"

namespace proveout::nc {

Reading IsoControl::readLanguage() {
  IsoContext& c = context_;
  CallFrame& frame = run_.top();
  Block& block = c.block;
  LexError error;
  const bool read = language_->read(*frame.text, frame.block, block, error);
  frame.number = block.number;
  c.setBlock(frame.block, block.number);
  if (block.skip > 0 && c.settings.skip_switches[static_cast<std::size_t>(block.skip - 1)])
    return Reading::kSkipped;
  if (!read) {
    c.fail(error);
    return Reading::kBad;
  }
  if (block.percent) {
    frame.next = frame.end;
    return Reading::kSkipped;
  }
  return block.empty() ? Reading::kEmpty : Reading::kBlock;
}

Go IsoControl::carryOutLanguage() {
  const std::optional<Go> go = language_->statement(*this);
  return go ? *go : execute();
}

bool IsoControl::carryOutWords() {
  IsoContext& c = context_;
  BlockPlan plan(c.state);
  return (c.dialect.plan ? c.dialect.plan : planBlock)(c, plan) && perform(c, plan);
}

Go IsoControl::openCall(const CallFrame& frame, int times) { return run_.call(frame, times); }

Go IsoControl::endRun(const std::string& code) { return run_.finish(code, ProgramEnd::kEndOfProgram); }

Go IsoControl::failed(bool nowhere) { return nowhere ? stopAtAlarm() : alarm(); }

}  // namespace proveout::nc
