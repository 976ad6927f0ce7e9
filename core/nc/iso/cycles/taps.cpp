#include "core/nc/iso/cycles/taps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/spindle/spindle.h"

namespace proveout::nc {
namespace {

/// Along a rigid tap as the main spindle accelerates, mm/s^2; 0: at once. Parameters of the range go before
/// what the spindle does otherwise.
double tapAcceleration(const IsoContext& c, const BlockPlan& plan, bool extraction) {
  if (plan.next.spindle_rpm <= 0.0) return 0.0;
  const auto main = static_cast<std::size_t>(c.registers.spindles.main);
  const int range = std::max(1, c.registers.spindles.record[main].gear);
  const auto of = [&](SpindleParam first) {
    return c.parameters.value(ofRange(first, range), mainNumber(c));
  };
  double acceleration = 0.0;
  if (extraction && c.parameters.flag(CycleParam::kTapExtractAcceleration)) {
    acceleration = of(SpindleParam::kExtractAcceleration);
  }
  if (acceleration <= 0.0) acceleration = of(SpindleParam::kTapAcceleration);
  if (acceleration <= 0.0) acceleration = mainAcceleration(c);
  const double pitch = plan.motion.feed.feed / plan.next.spindle_rpm;
  return pitch * acceleration / 60.0;
}

}  // namespace

void checkTapStart(IsoContext& c, const BlockPlan& plan, const Tap& tap) {
  if (tap.hand == 0 || tap.rigid || c.state.spindle_direction == tap.hand) return;
  const std::string code = gName(plan.next.active[kGroupCycle]);
  const char* const start = tap.hand > 0 ? "M3" : "M4";
  c.warnOnce(fmt::format("{}{}", code, c.state.spindle_direction), "tap-start",
             fmt::format("{} taps with the spindle {}: program {} before the cycle", code,
                         c.state.spindle_direction == 0 ? "standing" : "turning backwards", start));
}

void takeTapSpindle(const IsoContext& c, const BlockPlan& plan, const Tap& tap, bool inwards, bool extraction,
                    FeedStyle& style) {
  style.join.stops = true;  // the spindle turns round, or comes to a stand
  const double programmed = style.spindle != 0.0 ? std::abs(style.spindle) : plan.next.spindle_rpm;
  if (!tap.rigid) {  // as M3 and M4 of the cycle have left it
    if (style.spindle != 0.0) style.spindle = c.state.spindle_direction * programmed;
    return;
  }
  // Feed over speed is the pitch on every way, the faster ones too.
  style.spindle = (inwards ? tap.hand : -tap.hand) * programmed * style.feed / plan.motion.feed.feed;
  style.acceleration = tapAcceleration(c, plan, extraction);
}

}  // namespace proveout::nc
