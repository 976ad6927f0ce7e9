// Looks after a run: how many blocks, how far, whether it was cancelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/progress.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/limits/block_budget.h"

namespace proveout::nc {

/// Counts the blocks of a run against their limit, tells progress and looks at the wish to stop now and then.
class BlockWatch {
 public:
  enum class Over {
    kNo,
    kCancelled,
    kLimit  ///< the message is to be reported
  };
  /// Where the run is.
  struct Place {
    double done = 0.0;      ///< of the main program, 0 to 1
    std::size_t depth = 0;  ///< programs that are open
    std::size_t line = 0;   ///< index, in the innermost of them
  };

  static constexpr std::uint64_t kAllFree = UINT64_MAX;

  /// Both must outlive the watch; without `progress` the run cannot be cancelled. `free_motions`: so many of
  /// a block do not count.
  BlockWatch(InterpretSummary& summary, Progress* progress, std::uint64_t block_limit,
             std::uint64_t free_motions)
      : summary_(summary), progress_(progress), free_motions_(free_motions), budget_(block_limit) {}

  /// Counts a block, and of the motions since the last call those that are not free. The end of a run that is
  /// over goes into the summary.
  Over count(const Place& at);
  /// Of the limit.
  std::string message() const {
    return budget_.message(free_motions_ == kAllFree ? "" : ", chords of curves included");
  }

 private:
  InterpretSummary& summary_;
  Progress* progress_;
  std::uint64_t free_motions_;
  std::uint64_t next_look_ = 0;  ///< work spent by then
  BlockBudget budget_;
};

}  // namespace proveout::nc
