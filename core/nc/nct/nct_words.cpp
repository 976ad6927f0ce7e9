#include "core/nc/nct/nct_words.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/nct/nct_feed.h"
#include "core/nc/nct/nct_spindle.h"

namespace proveout::nc {

std::string gName(int code10) {
  return code10 % 10 ? fmt::format("G{}.{}", code10 / 10, code10 % 10) : fmt::format("G{}", code10 / 10);
}

std::int32_t code10Of(const Word& w) {
  const double tenfold = std::round(w.value * 10.0);
  if (!(tenfold >= 0.0 && tenfold <= 1e8)) return -1;
  if (!w.from_expression && std::abs(tenfold - w.value * 10.0) > 1e-6) return -1;
  return static_cast<std::int32_t>(tenfold);
}

std::int32_t mNumber(const Word& w) {
  const double whole = std::round(w.value);
  const bool integer = w.is_integer || w.from_expression;
  return integer && whole >= 0.0 && whole <= 99999999.0 ? static_cast<std::int32_t>(whole) : -1;
}

bool integerWord(NctContext& c, const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out) {
  // A computed value is rounded to the digits of the address (manual 23.1.1).
  const double value = w.from_expression ? std::round(w.value) : w.value;
  const bool whole = w.is_integer || w.from_expression;
  if (!whole || value < static_cast<double>(min) || value > static_cast<double>(max)) {
    return c.failWord("nct-2002",
                      fmt::format("{} data out of range: an integer from {} to {} is expected",
                                  addressText(w.address), min, max),
                      w);
  }
  out = static_cast<std::int64_t>(value);
  return true;
}

double turnsPerMinute(NctContext& c, const BlockPlan& plan) {
  if (surfaceSpeedRuns(c, plan)) return surfaceMeanRpm(c, plan);
  const double rpm = plan.next.spindle_rpm;
  bool turning = plan.next.spindle_direction != 0 && rpm > 0.0;
  for (int i = 0; i < plan.m_count; ++i)
    turning = turning || ((plan.m_value[i] == 3 || plan.m_value[i] == 4) && rpm > 0.0);
  // A rigid tap turns the spindle itself, with S, however it stands before.
  const int cycle = plan.next.active[kGroupCycle];
  turning = turning || (rpm > 0.0 && (cycle == 842 || cycle == 843) && plan.governor != nullptr &&
                        plan.governor->code10 == cycle);
  if (turning) return rpm;
  if (c.firstTime("spindle-stopped")) {
    c.warn("nct-spindle-stopped",
           fmt::format("feed or dwell per turn while the spindle stands still: {} rpm is taken for the time",
                       c.settings.default_spindle_rpm));
  }
  return c.settings.default_spindle_rpm;
}

namespace {

/// Direction of the main spindle behind M3 and M4 of the block.
int directionOf(const NctContext& c, const BlockPlan& plan) {
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    if (m == 3 || m == 4) return m == 3 ? 1 : -1;
  }
  return c.state.spindle_direction;
}

}  // namespace

bool feedStyle(NctContext& c, BlockPlan& plan, FeedStyle& style) {
  if (plan.next.feed <= 0.0) return c.fail("nct-feed", "no feed is programmed: a feed motion needs F");
  style.feed = plan.next.feed * plan.next.unitScale();
  if (plan.next.perTurn()) style.feed *= turnsPerMinute(c, plan);
  style.join = joinOf(plan);
  style.spindle = surfaceSpeedRuns(c, plan) ? directionOf(c, plan) * surfaceMeanRpm(c, plan) : 0.0;
  return true;
}

}  // namespace proveout::nc
