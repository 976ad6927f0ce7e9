// How much a program of the WL4 control may run.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "core/base/progress.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/limits/block_watch.h"
#include "core/nc/limits/loop_budget.h"
#include "core/nc/limits/loop_watch.h"
#include "core/nc/wl4/wl4_levels.h"
#include "core/nc/wl4/wl4_report.h"

namespace proveout::nc {

/// Sets the end of the run in the summary where it says that it is over.
class Wl4Watch {
 public:
  /// All must outlive the watch; without `progress` the run cannot be cancelled.
  Wl4Watch(Wl4Report& report, InterpretSummary& summary, const Wl4Levels& levels, Progress* progress,
           std::uint64_t block_limit, LoopBudget::State state)
      : report_(report),
        summary_(summary),
        levels_(levels),
        blocks_(summary, progress, block_limit),
        budget_(block_limit, std::move(state)) {}

  /// Counts a block, or a move of a cycle. True: the run was cancelled, or the limit of blocks, reported.
  bool workOver();
  /// Whether the program is in a loop without an end: reported then. `state`: what the next blocks depend on.
  bool goesRound(std::uint64_t variables, std::initializer_list<LoopWatch::Bytes> state);
  /// Whether the program is in a loop that comes no nearer to its end: reported then.
  bool goesOn();
  LoopBudget& budget() { return budget_; }

 private:
  bool endless(const std::string& message);

  Wl4Report& report_;
  InterpretSummary& summary_;
  const Wl4Levels& levels_;
  BlockWatch blocks_;
  LoopWatch loops_;
  LoopBudget budget_;
};

}  // namespace proveout::nc
