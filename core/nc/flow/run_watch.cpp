#include "core/nc/flow/run_watch.h"

#include <utility>

namespace proveout::nc {

RunWatch::RunWatch(InterpretSummary& summary, Progress* progress, std::uint64_t block_limit,
                   LoopBudget::State state, Fail fail)
    : summary_(summary),
      fail_(std::move(fail)),
      blocks_(summary, progress, block_limit),
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
  const FlowFrame::Call& call = at.top.call;
  const double motions = static_cast<double>(summary_.motions) + static_cast<double>(kept_back);
  const bool over =
      budget_.arrives({at.depth, at.top.block, at.line, call.number, call.repetition, call.repetitions},
                      {static_cast<double>(summary_.blocks), motions});
  return over && endless(budget_.message());
}

bool RunWatch::endless(const std::string& message) {
  fail_("endless-loop", message);
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
