// End points, integers and feeds of LinuxCNC's words.
#include <fmt/core.h>

#include "core/geometry/degrees.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

/// Beyond these no machine goes, and paths of rotary axes would not fit any memory.
constexpr double kLcnFarthestMm = 1e7, kLcnMostTurnDeg = 36000.0;
constexpr double kLcnIntegerTolerance = 1e-4;

/// `@` and `^`: the point by radius and angle about the frame's zero, in the plane.
bool lcnPolar(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  const Word* radius = c.word(kNamedWord);
  const Word* angle = c.word('^');
  if (radius == nullptr && angle == nullptr) return true;
  const WorkPlane plane = plan.next.workPlane();
  if (plan.motion.named[static_cast<std::size_t>(plane.u)] ||
      plan.motion.named[static_cast<std::size_t>(plane.v)])
    return lcnFail(c, "polar", "Cannot specify polar coordinates and words of the plane's axes",
                   radius != nullptr ? radius : angle);
  if (plan.next.active[kGroupPlane] != gcode::kPlaneXY)
    return lcnFail(c, "polar", "Cannot use polar coordinates except in G17 plane", radius ? radius : angle);
  const double r = std::hypot(plan.start[plane.u], plan.start[plane.v]);
  if ((radius == nullptr || angle == nullptr) && r == 0.0)
    return lcnFail(c, "polar", "Must specify both polar coordinates when the current point is the origin",
                   radius != nullptr ? radius : angle);
  lcnPolarFrom(c, plan, plan.start, target);
  plan.motion.named.set(static_cast<std::size_t>(plane.u)).set(static_cast<std::size_t>(plane.v));
  return true;
}

/// G53: axis words in machine coordinates.
bool lcnMachineTarget(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  if (c.word(kNamedWord) != nullptr || c.word('^') != nullptr)
    return lcnFail(c, "polar", "Cannot use polar coordinates with G53");
  AxisPoint machine = plan.chain->machineOf(plan.start);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    plan.motion.named.set(static_cast<std::size_t>(word.axis));
    machine[word.axis] = axisValue(c, plan, word, w);
  }
  target = plan.chain->programOf(machine);
  return true;
}

bool lcnInReach(IsoContext& c, const BlockPlan& plan, const AxisPoint& target) {
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const bool rotary = axis >= kMainAxes && c.axes.at(axis).rotary();
    const double most = rotary ? kLcnMostTurnDeg : kLcnFarthestMm;
    const double way = rotary ? target[axis] - plan.start[axis] : target[axis];
    if (std::abs(way) <= most) continue;  // false for what is no number too
    return c.alarm(
        SharedAlarm::kOutOfRange, c.axes.at(axis).name,
        rotary ? "more than 100 turns in one line are not simulated" : "farther than 10 km no machine goes");
  }
  return true;
}

}  // namespace

void lcnPolarFrom(IsoContext& c, const BlockPlan& plan, const AxisPoint& from, AxisPoint& target) {
  lcnPolarPoint(plan, c.word(kNamedWord), c.word('^'), from, target);
}

void lcnPolarPoint(const BlockPlan& plan, const Word* radius, const Word* angle, const AxisPoint& from,
                   AxisPoint& target) {
  const WorkPlane plane = plan.next.workPlane();
  const double u = from[plane.u], v = from[plane.v];
  double r = std::hypot(u, v), theta = radToDeg(std::atan2(v, u));
  const bool step = plan.next.incremental();
  if (radius != nullptr) r = (step ? r : 0.0) + lengthOf(plan, *radius);
  if (angle != nullptr) theta = (step ? theta : 0.0) + angle->value;
  target[plane.u] = r * cosDegrees(theta);
  target[plane.v] = r * sinDegrees(theta);
}

bool lcnAnyAxis(const IsoContext& c) {
  return c.anyAxisWord() || c.block.present.has(kNamedWord) || c.block.present.has('^');
}

bool lcnTarget(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot != nullptr && one_shot->code10 == gcode::kMachineMove) {
    if (!lcnMachineTarget(c, plan, target)) return false;
  } else {
    target = plan.start;
    for (const Word& w : c.block.words) {
      AxisWord word;
      if (!axisWord(plan, w, word)) continue;
      plan.motion.named.set(static_cast<std::size_t>(word.axis));
      const double value = axisValue(c, plan, word, w);
      target[word.axis] = plan.next.incremental() ? plan.start[word.axis] + value : value;
    }
    if (!lcnPolar(c, plan, target)) return false;
    if (plan.next.active[kGroupPolarData] == gcode::kPolarData && !mach3Polar(c, plan, target)) return false;
  }
  return lcnInReach(c, plan, target);
}

bool lcnInteger(IsoContext& c, const Word& w, std::int64_t& out) {
  const double nearest = std::round(w.value);
  if (!(std::abs(w.value - nearest) <= kLcnIntegerTolerance && std::abs(nearest) < 1e9))
    return lcnFail(c, "integer",
                   fmt::format("Non integer value for integer: {} word", addressText(w.address)), &w);
  out = static_cast<std::int64_t>(nearest);
  return true;
}

double lcnRpm(const IsoContext& c, const BlockPlan& plan) {
  (void)c;
  return plan.next.spindle_rpm;
}

bool lcnSpindleTurns(const IsoContext& c, const BlockPlan& plan) {
  int direction = c.state.spindle_direction;
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    if (mcode::turns(m)) direction = 1;
    if (m == mcode::kSpindleStop) direction = 0;
  }
  return direction != 0;
}

double lcnTurnOf(const IsoContext& c, const AxisPoint& a, const AxisPoint& b) {
  double sum = 0.0;
  for (int axis = kMainAxes; axis < c.axes.count(); ++axis) {
    if (c.axes.at(axis).rotary()) sum += (b[axis] - a[axis]) * (b[axis] - a[axis]);
  }
  return std::sqrt(sum);
}

bool lcnFeed(IsoContext& c, BlockPlan& plan, double length, double turn, const char* code, FeedStyle& style) {
  LinuxCncModal& next = linuxCncChannel(c).next;
  style.join = joinOf(plan);
  const bool only_turns = !(length > 0.0) && turn > 0.0;
  if (turn > 0.0 && !only_turns) style.paced_mm = length;
  const int mode = plan.next.active[kGroupFeedMode];
  if (mode == lcn::kInverseTime) {
    if (!c.block.present.has('F'))
      return lcnFail(c, "feed", fmt::format("F word missing with inverse time {} move", code));
    if (next.feed_number <= 0.0)
      return lcnFail(c, "feed", fmt::format("Cannot do {} with zero feed rate", code), c.word('F'));
    style.feed = next.feed_number * (only_turns ? turn : length);
    if (!(style.feed > 0.0)) style.feed = 1.0;  // nothing moves
    return true;
  }
  if (next.feed <= 0.0) return lcnFail(c, "feed", fmt::format("Cannot do {} with zero feed rate", code));
  style.feed = only_turns ? next.feed_number : next.feed;
  if (mode == gcode::kFeedPerTurn) {
    const double rpm = surfaceSpeedRuns(c, plan) ? surfaceMeanRpm(c, plan) : lcnRpm(c, plan);
    if (!(rpm > 0.0)) return lcnFail(c, "feed", "Cannot feed with zero spindle speed in feed per rev mode");
    style.feed *= rpm;
  }
  if (surfaceSpeedRuns(c, plan))
    style.spindle = (c.state.spindle_direction < 0 ? -1.0 : 1.0) * surfaceMeanRpm(c, plan);
  return true;
}

bool lcnLineFeed(IsoContext& c, BlockPlan& plan, const AxisPoint& to, const char* code, FeedStyle& style) {
  const double length = (to.xyz - plan.start.xyz).norm();
  return lcnFeed(c, plan, length, lcnTurnOf(c, plan.start, to), code, style);
}

}  // namespace proveout::nc
