#include "core/nc/wl4/cycles/wl4_thread.h"

#include <fmt/core.h>

#include <cmath>

#include "core/geometry/to_float.h"
#include "core/nc/wl4/wl4_functions.h"
#include "core/nc/wl4/wl4_output.h"
#include "core/nc/wl4/wl4_speeds.h"

namespace proveout::nc {

namespace {

/// An angle in 0 <= angle < 360, degrees.
float turnedTo(double degrees) {
  const double rest = std::fmod(degrees, 360.0);
  const auto angle = toFloat(rest < 0.0 ? rest + 360.0 : rest);
  return angle < 360.0F ? angle : 0.0F;
}

/// Speed that the thread is timed at, 1/min; `spindle` is signed, and 0 where what cuts then cuts no thread.
double threadRpm(Wl4Context& c, const Wl4State& s, double& spindle) {
  const double n = c.state.turns() ? rpmAt(c.setup, s, 2.0 * (c.machine[0] - s.acting[0])) : 0.0;
  spindle = c.state.spindle == 4 ? -n : n;
  if (n > 0.0) return n;
  const double assumed = c.setup.settings.default_spindle_rpm;
  c.report.warnOnce("thread without spindle", "wl4-spindle-off",
                    fmt::format("a thread while the spindle stands: timed at {} 1/min", assumed));
  return assumed;
}

/// Revolutions n with F n + I n (n - 1) / 2 = `along` (mm). False: there are none, reported.
bool countRevolutions(Wl4Context& c, const Wl4State& s, double along, double& revolutions) {
  const double pitch = s.pitch;
  if (!(pitch > 0.0)) return c.report.fail("wl4-thread", "the pitch F of the thread is zero");
  revolutions = along / pitch;
  if (s.i == 0.0) return true;
  const double b = pitch - 0.5 * s.i, root = b * b + 2.0 * s.i * along;
  if (root < 0.0) return c.report.fail("wl4-thread", "the pitch falls to zero before the end of the thread");
  revolutions = (std::sqrt(root) - b) / s.i;
  return true;
}

/// The way there from an angle of the spindle; `angle` becomes that at its end, degrees, turns counted.
bool threadItem(Wl4Context& c, const Wl4BlockPlan& p, PathItem& item, double& angle) {
  const Wl4State& s = p.next;
  double spindle = 0.0, revolutions = 0.0;
  const double n = threadRpm(c, s, spindle);
  const Vec3 way = p.target.xyz - c.machine.xyz;
  if (!countRevolutions(c, s, way.cwiseAbs().maxCoeff(), revolutions)) return false;
  item = motionItem(c, p, PathItem::Kind::kLine);
  item.feed.kind = MotionKind::kThread;
  item.feed.feed = revolutions > 0.0 ? way.norm() / revolutions * n : s.pitch * n;
  item.feed.join.stops = p.exact_stop;
  item.feed.join.unbroken = !p.exact_stop;
  item.feed.spindle = spindle;
  item.feed.thread_pitch_change = toFloat(s.i);
  item.feed.thread_start_deg = turnedTo(angle);
  angle += 360.0 * revolutions;
  return true;
}

/// The same thread counted the other way round, from where the way there has ended (degrees), the lead
/// falling as it has grown.
bool sendWayBack(Wl4Context& c, const Wl4BlockPlan& there, const AxisPoint& from, const FeedStyle& feed,
                 double end) {
  Wl4BlockPlan back = there;
  back.target = from;
  back.chamfer = 0.0;
  PathItem item = motionItem(c, back, PathItem::Kind::kLine);
  item.feed = feed;
  item.feed.spindle = -feed.spindle;
  item.feed.thread_start_deg = turnedTo(-end);
  item.feed.thread_pitch_change = -feed.thread_pitch_change;
  return sendMotion(c, back, item);
}

}  // namespace

bool performThread(Wl4Context& c, Wl4BlockPlan& p) {
  PathItem item;
  double angle = c.thread_angle.value_or(p.next.p);
  if (!threadItem(c, p, item, angle)) return false;
  c.thread_angle.reset();
  if (!p.exact_stop) c.thread_angle = std::fmod(angle, 360.0);  // a stop ends the sequence
  return sendMotion(c, p, item);
}

bool performThreadAndBack(Wl4Context& c, Wl4BlockPlan& p) {
  const AxisPoint from = c.machine;
  const int direction = c.state.spindle;
  const bool turns = c.state.turns();
  PathItem item;
  double angle = p.next.p;
  if (!threadItem(c, p, item, angle)) return false;
  const FeedStyle feed = item.feed;
  if (!sendMotion(c, p, item)) return false;
  Wl4State reversed = p.next;
  reversed.spindle = direction == 3 ? 4 : direction == 4 ? 3 : direction;
  if (turns && !turnSpindle(c, reversed)) return false;
  if (!sendWayBack(c, p, from, feed, angle)) return false;
  reversed.spindle = direction;
  return !turns || turnSpindle(c, reversed);
}

}  // namespace proveout::nc
