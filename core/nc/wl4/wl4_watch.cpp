#include "core/nc/wl4/wl4_watch.h"

namespace proveout::nc {

namespace {

constexpr std::uint64_t kWorkPerCheck = 4096;

}  // namespace

bool Wl4Watch::workOver() {
  budget_.spend(1, budget_.newMotions(summary_.motions) > 0);
  if ((budget_.work() - 1) % kWorkPerCheck == 0 && progress_ != nullptr) {
    const Wl4Level& main = levels_.front();
    progress_->report("interpreting", static_cast<double>(main.line - main.program->first) /
                                          static_cast<double>(main.program->last - main.program->first));
    if (progress_->cancelled()) {
      summary_.end = ProgramEnd::kCancelled;
      return true;
    }
  }
  if (!budget_.over(levels_.size(), levels_.back().line)) return false;
  report_.fail("wl4-block-limit", budget_.message());
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

bool Wl4Watch::goesRound(std::uint64_t variables, std::initializer_list<LoopWatch::Bytes> state) {
  const Wl4Level& level = levels_.back();
  if (!loops_.comesBack(level.run, levels_.size(), level.line, variables, state)) return false;
  report_.fail("wl4-endless-loop", loops_.message());
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
