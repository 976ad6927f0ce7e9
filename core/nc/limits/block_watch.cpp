#include "core/nc/limits/block_watch.h"

namespace proveout::nc {

namespace {

/// How often cancellation is looked at and progress told, in blocks.
constexpr std::uint64_t kBlocksPerLook = 1024;

}  // namespace

BlockWatch::Over BlockWatch::count(const Place& at) {
  const std::uint64_t made = budget_.newMotions(summary_.motions);
  budget_.spend(1 + (made > free_motions_ ? made - free_motions_ : 0), made > 0);
  if (budget_.work() >= next_look_ && progress_ != nullptr) {
    next_look_ = budget_.work() + kBlocksPerLook;
    progress_->report("interpreting", at.done);
    if (progress_->cancelled()) {
      summary_.end = ProgramEnd::kCancelled;
      return Over::kCancelled;
    }
  }
  if (!budget_.over(at.depth, at.line)) return Over::kNo;
  summary_.end = ProgramEnd::kBlockLimit;
  return Over::kLimit;
}

}  // namespace proveout::nc
