#include "core/nc/nct/nct_feed.h"

#include <algorithm>

namespace proveout::nc {
namespace {

/// A corner without a limit of its own may change the speed of an axis by what it accelerates in this time:
/// about an interpolation step.
constexpr double kCornerTime = 0.010;

AxisMotionLimits axisLimits(const NctContext& c, int axis) {
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

void configureRapids(NctContext& c, const MotionLimits& limits) {
  const NctParameters& p = c.parameters;
  RapidOverlapStage& stage = c.rapid_stage;
  stage.flush(FlushReason::kBuffer);
  c.pipe.unlink(stage);
  if (!p.flag(FeedParam::kRapidOverlap)) return;
  if (!limits.accelerations) {
    return c.warnOnce("overlap", "nct-rapid-overlap",
                      "N0421.ROL = 1 rounds the corners between rapids, but the machine has no acceleration: "
                      "the path keeps them sharp");
  }
  stage.configure(limits, p[FeedParam::kRapidOverlapRatio] / 100.0, p.flag(FeedParam::kPositionCheck));
  c.pipe.link(stage);
}

}  // namespace

void configureFeeds(NctContext& c) {
  const NctParameters& p = c.parameters;
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
  join.stops = (plan.exact_stop || mode == 610) && !plan.next.automatic.no_exact_stop;
  join.unbroken = mode == 630;
  if (mode == 620 && plan.next.compOn()) join.inside = plan.next.compOffset() < 0.0 ? -1 : 1;
  return join;
}

double insideArcFactor(const NctParameters& parameters, double programmed_radius, double radius) {
  if (!(radius < programmed_radius)) return 1.0;
  return std::max(radius / programmed_radius, parameters[FeedParam::kInsideArcLeast]);
}

}  // namespace proveout::nc
