#include "core/nc/flexnc/flexnc_watch.h"

namespace proveout::nc {

namespace {

bool endless(FlexContext& c, const std::string& message) {
  c.report.fail("fnc-endless-loop", message);
  c.summary.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace

bool flexWorkOver(FlexContext& c) {
  const double done = static_cast<double>(c.levels.front().line) / static_cast<double>(c.program.count());
  const BlockWatch::Over over = c.watch.count({done, c.levels.size(), c.levels.back().line});
  if (over == BlockWatch::Over::kLimit) c.report.fail("fnc-block-limit", c.watch.message());
  return over != BlockWatch::Over::kNo;
}

bool flexGoesRound(FlexContext& c, std::uint64_t counters) {
  const FlexLevel& level = c.levels.back();
  if (!c.loops.comesBack(level.run, c.levels.size(), level.line, c.variables.fingerprint() + counters,
                         {LoopWatch::bytesOf(c.state), LoopWatch::bytesOf(c.machine)}))
    return false;
  return endless(c, c.loops.message());
}

bool flexGoesOn(FlexContext& c) {
  const FlexLevel& level = c.levels.back();
  const bool over =
      c.loop_budget.arrives({c.levels.size(), level.line, level.line, level.run, 0, 1},
                            {static_cast<double>(c.summary.blocks), static_cast<double>(c.summary.motions)});
  return over && endless(c, c.loop_budget.message());
}

}  // namespace proveout::nc
