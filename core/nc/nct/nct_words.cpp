#include "core/nc/nct/nct_words.h"

#include <fmt/core.h>

namespace proveout::nc {

std::string gName(int code10) {
  return code10 % 10 ? fmt::format("G{}.{}", code10 / 10, code10 % 10) : fmt::format("G{}", code10 / 10);
}

bool integerWord(NctContext& c, const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out) {
  if (!w.is_integer || w.value < static_cast<double>(min) || w.value > static_cast<double>(max)) {
    return c.failWord("nct-2002",
                      fmt::format("{} data out of range: an integer from {} to {} is expected",
                                  addressText(w.address), min, max),
                      w);
  }
  out = static_cast<std::int64_t>(w.value);
  return true;
}

bool axisTarget(NctContext& c, BlockPlan& plan, Vec3& target) {
  target = plan.start;
  const AddressSet present = c.block.present & AddressSet("XYZUVW");
  if (present.empty()) return true;
  const double scale = plan.next.unitScale();
  for (const Word& w : c.block.words) {
    if (!present.has(w.address)) continue;
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    const int axis = w.address - (secondary ? 'U' : 'X');
    auto& named = plan.motion.named[static_cast<std::size_t>(axis)];
    if (named) {
      return c.failWord(
          "nct-2017",
          fmt::format("illegal address {}: the axis is given twice in this block", addressText(w.address)),
          w);
    }
    named = true;
    const bool step = secondary || w.incremental || plan.next.incremental();
    target[axis] = step ? plan.start[axis] + w.value * scale : w.value * scale;
  }
  return true;
}

double turnsPerMinute(NctContext& c, const BlockPlan& plan) {
  const double rpm = plan.next.spindle_rpm;
  bool turning = plan.next.spindle_direction != 0 && rpm > 0.0;
  for (int i = 0; i < plan.m_count; ++i)
    turning = turning || ((plan.m_value[i] == 3 || plan.m_value[i] == 4) && rpm > 0.0);
  if (turning) return rpm;
  if (c.firstTime("spindle-stopped")) {
    c.warn("nct-spindle-stopped",
           fmt::format("feed or dwell per turn while the spindle stands still: {} rpm is taken for the time",
                       c.settings.default_spindle_rpm));
  }
  return c.settings.default_spindle_rpm;
}

bool feedStyle(NctContext& c, BlockPlan& plan, FeedStyle& style) {
  if (plan.next.feed <= 0.0) return c.fail("nct-feed", "no feed is programmed: a feed motion needs F");
  style.feed = plan.next.feed * plan.next.unitScale();
  if (plan.next.perTurn()) style.feed *= turnsPerMinute(c, plan);
  return true;
}

bool axisWord(const BlockPlan& plan, const Word& w, int& axis, bool& step) {
  const bool secondary = w.address >= 'U' && w.address <= 'W';
  if (!secondary && (w.address < 'X' || w.address > 'Z')) return false;
  axis = w.address - (secondary ? 'U' : 'X');
  step = secondary || w.incremental || plan.next.incremental();
  return true;
}

}  // namespace proveout::nc
