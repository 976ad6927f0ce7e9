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
  report_.fail("wl4-endless-loop", loops_.message());
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
