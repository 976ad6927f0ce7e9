#include "core/nc/wl4/wl4_speeds.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/services/surface_speed.h"

namespace proveout::nc {

namespace {

constexpr double kLeastDiameter = 1e-3;  ///< mm; at the axis the speed would be infinite

/// The highest speed that the program or the machine allows, 1/min; 0: none is known.
double topSpeed(const Wl4Setup& setup, const Wl4State& s) {
  double top = 0.0;
  for (const double limit : {s.speed_limit, setup.parameters.max_speed}) {
    if (limit > 0.0) top = top > 0.0 ? std::min(top, limit) : limit;
  }
  return top;
}

/// Speed with which feed per revolution takes as long as along a line between two signed diameters, mm.
double meanRpm(const Wl4Setup& setup, const Wl4State& s, double from, double to) {
  if (s.speed_mode != 96 || !(s.speed > 0.0)) return rpmAt(setup, s, to);
  const double product = 1000.0 * s.speed / kPi;  // 1/min times mm of diameter
  const double top = topSpeed(setup, s);
  return meanSurfaceRpm(product, from, to, {0.0, top > 0.0 ? top : product / kLeastDiameter});
}

/// Feed per revolution becomes mm/min.
void feedPerRevolution(Wl4Context& c, const Wl4BlockPlan& p, FeedStyle& feed) {
  const Wl4State& s = p.next;
  const double from = 2.0 * (c.machine[0] - c.state.acting[0]), to = 2.0 * (p.target[0] - s.acting[0]);
  double n = c.state.turns() ? meanRpm(c.setup, s, from, to) : 0.0;
  if (c.state.turns()) warnOfUnlimitedSpeed(c, s, from, to);
  if (s.speed_mode == 96) feed.spindle = c.state.spindle == 4 ? -n : n;
  if (!(n > 0.0)) {
    c.report.warnOnce("feed without spindle", "wl4-spindle-off",
                      fmt::format("feed per revolution while the spindle stands: timed at {} 1/min",
                                  c.setup.settings.default_spindle_rpm));
    n = c.setup.settings.default_spindle_rpm;
  }
  feed.feed *= n;
}

}  // namespace

double rpmAt(const Wl4Setup& setup, const Wl4State& s, double diameter) {
  double n = s.speed;
  if (s.speed_mode == 96) n = 1000.0 * s.speed / (kPi * std::max(std::abs(diameter), kLeastDiameter));
  const double top = topSpeed(setup, s);
  return top > 0.0 ? std::min(n, top) : n;
}

void warnOfUnlimitedSpeed(Wl4Context& c, const Wl4State& s, double from, double to) {
  const bool axis = from * to <= 0.0 || std::min(std::abs(from), std::abs(to)) < kLeastDiameter;
  if (s.speed_mode != 96 || !axis || topSpeed(c.setup, s) > 0.0) return;
  c.report.warnOnce(
      "surface speed without limit", "wl4-surface-speed",
      "G96 to the axis without a limit of the spindle's speed: speed and time there are those of no real "
      "machine; give G51 S in the program or MAX_SPEED in [control.wl4-mill] or [control.wl4-lathe]");
}

bool planFeed(Wl4Context& c, const Wl4BlockPlan& p, FeedStyle& feed) {
  const Wl4State& s = p.next;
  feed.join.stops = p.exact_stop || s.stop != 64;
  if (!(s.feed > 0.0)) return c.report.fail("wl4-feed", "the feed is zero: F is missing");
  feed.feed = s.feed;
  if (s.feed_mode == 95) feedPerRevolution(c, p, feed);
  const double most = c.setup.parameters.max_feed;
  if (feed.feed > most) {
    c.report.warnOnce("max feed", "wl4-max-feed",
                      fmt::format("the feed is limited to {} mm/min (MAX_FEED)", most));
    feed.feed = most;
  }
  return true;
}

}  // namespace proveout::nc
