#include "core/nc/flow/run_watch.h"

#include <utility>

namespace proveout::nc {

RunWatch::RunWatch(InterpretSummary& summary, Progress* progress, std::uint64_t block_limit,
                   LoopBudget::State state, Fail fail, std::uint64_t free_motions)
    : summary_(summary),
      fail_(std::move(fail)),
      blocks_(summary, progress, block_limit, free_motions),
      budget_(block_limit, std::move(state)) {}

bool RunWatch::workOver(const FlowPlace& at) {
  const double done =
      static_cast<double>(at.main.block - at.main.first) / static_cast<double>(at.main.end - at.main.first);
  const BlockWatch::Over over = blocks_.count({done, at.depth, at.line});
  if (over == BlockWatch::Over::kLimit) fail_("block-limit", blocks_.message());
  return over != BlockWatch::Over::kNo;
}

bool RunWatch::goesRound(const FlowPlace& at, std::uint64_t variables,
                         std::initializer_list<LoopWatch::Bytes> state) {
  return loops_.comesBack(at.top.run, at.depth, at.line, variables, state) && endless(loops_.message());
}

bool RunWatch::goesOn(const FlowPlace& at, std::size_t kept_back) {
  return comesNoNearer(at,
                       {static_cast<double>(summary_.blocks), motions() + static_cast<double>(kept_back)});
}

bool RunWatch::movesOn(const FlowPlace& at) { return comesNoNearer(at, {0.0, motions()}); }

bool RunWatch::comesNoNearer(const FlowPlace& at, const LoopBudget::Work& done) {
  const FlowFrame::Call& call = at.top.call;
  const LoopBudget::Place place = {at.depth,    at.top.block,    at.line,
                                   call.number, call.repetition, call.repetitions};
  return budget_.arrives(place, done) && endless(budget_.message());
}

bool RunWatch::endless(const std::string& message) {
  fail_("endless-loop", message);
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
