#include "core/nc/wl4/wl4_watch.h"

namespace proveout::nc {

bool Wl4Watch::workOver() {
  const Wl4Level& main = levels_.front();
  const double done = static_cast<double>(main.line - main.program->first) /
                      static_cast<double>(main.program->last - main.program->first);
  const BlockWatch::Over over = blocks_.count({done, levels_.size(), levels_.back().line});
  if (over == BlockWatch::Over::kLimit) report_.fail("wl4-block-limit", blocks_.message());
  return over != BlockWatch::Over::kNo;
}

bool Wl4Watch::goesRound(std::uint64_t variables, std::initializer_list<LoopWatch::Bytes> state) {
  const Wl4Level& level = levels_.back();
  if (!loops_.comesBack(level.run, levels_.size(), level.line, variables, state)) return false;
  return endless(loops_.message());
}

bool Wl4Watch::goesOn() {
  const Wl4Level& level = levels_.back();
  const bool over =
      budget_.arrives({levels_.size(), level.line, level.line, level.call.number, level.call.repetition,
                       level.call.repetitions},
                      {static_cast<double>(summary_.blocks), static_cast<double>(summary_.motions)});
  return over && endless(budget_.message());
}

bool Wl4Watch::endless(const std::string& message) {
  report_.fail("wl4-endless-loop", message);
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
