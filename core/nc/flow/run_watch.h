// How much a program may run: its limits of blocks, and loops without an end.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>

#include "core/base/progress.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/flow/flow_frame.h"
#include "core/nc/limits/block_watch.h"
#include "core/nc/limits/loop_budget.h"
#include "core/nc/limits/loop_watch.h"

namespace proveout::nc {

/// Sets the end of the run in the summary where it says that it is over.
class RunWatch {
 public:
  /// Reports an error of the control: "block-limit" or "endless-loop", and its message.
  using Fail = std::function<void(const char* what, const std::string& message)>;

  /// All must outlive the watch; without `progress` the run cannot be cancelled. `free_motions`: the motions
  /// of a block that go beyond so many count as blocks do, where a block can make many of them.
  RunWatch(InterpretSummary& summary, Progress* progress, std::uint64_t block_limit, LoopBudget::State state,
           Fail fail, std::uint64_t free_motions = BlockWatch::kAllFree);

  /// Counts a block, or a move of a cycle. True: the run was cancelled, or the limit of blocks, reported.
  bool workOver(const FlowPlace& at);
  /// Whether the program is in a loop without an end at the block in hand: reported then. `variables`,
  /// `state`: what the next blocks depend on.
  bool goesRound(const FlowPlace& at, std::uint64_t variables, std::initializer_list<LoopWatch::Bytes> state);
  /// Whether the program is in a loop that comes no nearer to its end: reported then. `kept_back`: motions
  /// that are still to be sent.
  bool goesOn(const FlowPlace& at, std::size_t kept_back = 0);
  /// The same of a program that asks for other channels: it goes round until they answer, so that only its
  /// motions count.
  bool movesOn(const FlowPlace& at);
  /// The conditions of the program are told to it.
  LoopBudget& budget() { return budget_; }

 private:
  bool comesNoNearer(const FlowPlace& at, const LoopBudget::Work& done);
  double motions() const { return static_cast<double>(summary_.motions); }
  bool endless(const std::string& message);

  InterpretSummary& summary_;
  Fail fail_;
  BlockWatch blocks_;
  LoopWatch loops_;
  LoopBudget budget_;
};

}  // namespace proveout::nc
