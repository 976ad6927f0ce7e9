#include "core/nc/iso/motion/feed.h"

#include <fmt/core.h>

#include "core/nc/iso/spindle/spindle.h"

namespace proveout::nc {
namespace {

/// A corner without a limit of its own may change the speed of an axis by what it accelerates in this time:
/// about an interpolation step.
constexpr double kCornerTime = 0.010;

AxisMotionLimits axisLimits(const IsoContext& c, int axis) {
  const int number = c.axes.at(axis).number;
  AxisMotionLimits limits;
  limits.acceleration = c.axes.at(axis).acceleration;
  limits.max_feed = c.parameters.value(FeedParam::kMaxFeed, number);
  limits.normal = c.parameters.value(FeedParam::kNormalAcceleration, number);
  limits.jump = c.parameters.value(FeedParam::kAccelerationJump, number);
  limits.jump_arc = c.parameters.value(FeedParam::kAccelerationJumpArc, number);
  limits.speed_change = c.parameters.value(FeedParam::kFeedJump, number);
  if (limits.speed_change == 0.0) limits.speed_change = 60.0 * kCornerTime * limits.acceleration;
  return limits;
}

void configureRapids(IsoContext& c, const MotionLimits& limits) {
  const IsoParameters& p = c.parameters;
  RapidOverlapStage& stage = c.stages.rapid;
  stage.flush(FlushReason::kBuffer);
  c.pipe.unlink(stage);
  if (!p.flag(FeedParam::kRapidOverlap)) return;
  if (!limits.accelerations) {
    return c.warnOnce("overlap", "rapid-overlap",
                      p.nameWith(FeedParam::kRapidOverlap, 1) +
                          " rounds the corners between rapids, but the machine has no acceleration: "
                          "the path keeps them sharp");
  }
  stage.configure(limits, p[FeedParam::kRapidOverlapRatio] / 100.0, p.flag(FeedParam::kPositionCheck));
  c.pipe.link(stage);
}

}  // namespace

void configureFeeds(IsoContext& c) {
  const IsoParameters& p = c.parameters;
  MotionLimits limits;
  for (int k = 0; k < c.axes.count(); ++k) {
    const AxisMotionLimits axis = axisLimits(c, k);
    limits.axes[static_cast<std::size_t>(k)] = axis;
    limits.accelerations = limits.accelerations || axis.acceleration > 0.0;
    limits.feeds = limits.feeds || axis.max_feed > 0.0 || axis.normal > 0.0;
  }
  limits.corner_by_angle = !p.flag(FeedParam::kCornerByJump);
  limits.corner_angle_deg = p[FeedParam::kCornerAngle];
  limits.corner_feed = p[FeedParam::kCornerFeed];
  limits.least_arc_feed = p[FeedParam::kLeastArcFeed];
  limits.bell_time_s = c.settings.bell_time_s;
  c.emitter.time().configure(limits, c.axes.count());
  c.emitter.time().setCornerSlowdown({p[FeedParam::kInsideCornerBefore], p[FeedParam::kInsideCornerAfter],
                                      p[FeedParam::kInsideCornerFactor], p[FeedParam::kInsideCornerAngle]});
  configureRapids(c, limits);
}

MotionJoin joinOf(const BlockPlan& plan) {
  MotionJoin join;
  const int mode = plan.next.active[kGroupCutting];
  join.stops = (plan.exact_stop || mode == gcode::kExactStopMode) && !plan.next.automatic.no_exact_stop;
  join.unbroken = mode == gcode::kNoOverride;
  if (mode == gcode::kSlowInsideCorners && plan.next.compOn())
    join.inside = plan.next.compOffset() < 0.0 ? -1 : 1;
  return join;
}

double turnsPerMinute(IsoContext& c, const BlockPlan& plan) {
  if (surfaceSpeedRuns(c, plan)) return surfaceMeanRpm(c, plan);
  const double rpm = plan.next.spindle_rpm;
  bool turning = plan.next.spindle_direction != 0 && rpm > 0.0;
  for (int i = 0; i < plan.m_count; ++i) turning = turning || (mcode::turns(plan.m_value[i]) && rpm > 0.0);
  // A rigid tap turns the spindle itself, with S, however it stands before.
  const int cycle = plan.next.active[kGroupCycle];
  turning = turning || (rpm > 0.0 && plan.next.rigid_tap != RigidTap::kOff);
  turning = turning || (rpm > 0.0 && (cycle == gcode::kRigidTap || cycle == gcode::kRigidTapLeft) &&
                        plan.governor != nullptr && plan.governor->code10 == cycle);
  if (turning) return rpm;
  if (c.firstTime("spindle-stopped")) {
    c.warn("spindle-stopped",
           fmt::format("feed or dwell per turn while the spindle stands still: {} rpm is taken for the time",
                       c.settings.default_spindle_rpm));
  }
  return c.settings.default_spindle_rpm;
}

namespace {

/// Direction of the main spindle behind M3 and M4 of the block.
int directionOf(const IsoContext& c, const BlockPlan& plan) {
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    if (mcode::turns(m)) return m == mcode::kClockwise ? 1 : -1;
  }
  return c.state.spindle_direction;
}

}  // namespace

namespace {

/// What the feed of the planned motion is the speed of, mm or degrees: G93 tells how long it takes.
double wayOf(const IsoContext& c, const BlockPlan& plan, FeedStyle& style) {
  const PlannedMotion& motion = plan.motion;
  double sum = 0.0;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const double d = motion.target[axis] - plan.start[axis];
    sum += d * d;
  }
  if (motion.is_arc) {
    const double rise = motion.arc.end.z() - motion.arc.start.z();
    style.along = FeedStyle::Along::kSpace;
    return std::hypot(planeLength(motion.arc), rise);
  }
  style.paced_mm = std::sqrt(sum);
  return style.paced_mm;
}

}  // namespace

bool feedStyle(IsoContext& c, BlockPlan& plan, FeedStyle& style) {
  const bool inverse = plan.next.active[kGroupFeedMode] == gcode::kInverseTime;
  if (inverse && !c.block.present.has('F'))
    return c.fail("feed", "no feed is programmed: under G93 every block that moves needs F");
  if (plan.next.feed <= 0.0) return c.fail("feed", "no feed is programmed: a feed motion needs F");
  style.feed = plan.next.feed * plan.next.unitScale();
  if (inverse) {
    style.feed = plan.next.feed * wayOf(c, plan, style);
  } else if (plan.next.perTurn())
    style.feed *= turnsPerMinute(c, plan);
  style.join = joinOf(plan);
  style.spindle = surfaceSpeedRuns(c, plan) ? directionOf(c, plan) * surfaceMeanRpm(c, plan) : 0.0;
  return true;
}

}  // namespace proveout::nc
