#include "core/nc/iso/five_axis/shank_track.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/five_axis/tip_way.h"

namespace proveout::nc {

namespace {

/// Angles nearer than this are one, deg.
constexpr double kSameDeg = 1e-4;
/// Directions this near to opposite ones span no plane, rad.
constexpr double kOpposite = 1e-4;

/// The same angle whole turns away, nearest to `to`.
double nearTo(double angle, double to) { return angle + 360.0 * std::round((to - angle) / 360.0); }

RotaryAngles between(const RotaryAngles& a, const RotaryAngles& b, double t) {
  return {a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)};
}

}  // namespace

std::optional<RotaryAngles> ShankTrack::nearest(double share, const RotaryAngles& to) const {
  const FiveAxisModel::Positions positions = model_.positionsFor(directionAt(share), to);
  std::optional<RotaryAngles> best;
  double least = 0.0;
  for (int i = 0; i < positions.count; ++i) {
    RotaryAngles a = positions.at[static_cast<std::size_t>(i)];
    a = {nearTo(a.first, to.first), nearTo(a.second, to.second)};
    const double away = std::abs(a.first - to.first) + std::abs(a.second - to.second);
    if (best && away >= least) continue;
    best = a;
    least = away;
  }
  return best;
}

bool ShankTrack::followFromStart(const RotaryAngles& start) {
  angles_[0] = start;
  for (std::size_t i = 1; i <= kNodes; ++i) {
    const auto found = nearest(static_cast<double>(i) / kNodes, angles_[i - 1]);
    if (!found) return false;
    angles_[i] = *found;
  }
  return true;
}

bool ShankTrack::followFromEnd(const RotaryAngles& end) {
  angles_[kNodes] = end;
  for (std::size_t i = kNodes; i-- > 0;) {
    const auto found = nearest(static_cast<double>(i) / kNodes, angles_[i + 1]);
    if (!found) return false;
    angles_[i] = *found;
  }
  return true;
}

bool ShankTrack::startsAt(const RotaryAngles& start) {
  // What is free there may be anywhere: a position asked for from elsewhere shows it.
  const auto here = nearest(0.0, start);
  if (!here) return false;
  const bool alike =
      std::abs(here->first - start.first) < kSameDeg && std::abs(here->second - start.second) < kSameDeg;
  const FiveAxisModel::Positions one = model_.positionsFor(directionAt(0.0), start),
                                 other = model_.positionsFor(directionAt(0.0),
                                                             {start.first + 50.0, start.second + 70.0});
  const bool first_free = std::abs(one.at[0].first - other.at[0].first) > kSameDeg,
             second_free = std::abs(one.at[0].second - other.at[0].second) > kSameDeg;
  const bool comes = (first_free || std::abs(angles_[0].first - start.first) < kSameDeg) &&
                     (second_free || std::abs(angles_[0].second - start.second) < kSameDeg);
  angles_[0] = start;
  return alike && comes;
}

RotaryAngles ShankTrack::at(double share) const {
  const double place = share * static_cast<double>(kNodes);
  const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), kNodes);
  const double rest = place - static_cast<double>(i);
  if (i == kNodes || rest <= 0.0) return angles_[i];
  const RotaryAngles about = between(angles_[i], angles_[i + 1], rest);
  return nearest(share, about).value_or(about);
}

std::optional<ShankTrack> trackShank(IsoContext& c, const BlockPlan& plan) {
  const TipWay way(c, plan);
  const RotaryAngles now = c.five_axes.at(c.machine),
                     end = c.five_axes.at(c.chain.machineOf(plan.motion.target));
  Motion motion;
  AxisSweep sweep;
  ArcGeometry arc;
  motion.from = way.machineOf(way.from(), kTablesAtZero).xyz;
  motion.to = way.machineOf(plan.motion.target, kTablesAtZero).xyz;
  sweep.from = c.five_axes.toolVector(now);
  sweep.to = c.five_axes.toolVector(end);
  if (plan.motion.is_arc) {
    const PoseTrack::Arc seen = way.arc(kTablesAtZero);
    arc = {seen.center.xyz, seen.above.xyz - seen.center.xyz, seen.sweep_rad};
    sweep.law = PoseLaw::kCone;
  }
  const bool by_vector = plan.next.five.tip == TipControl::kVector;
  const auto refuse = [&](double angle) {
    c.alarm(SharedAlarm::kInclination, fmt::format("{:g}", angle),
            by_vector
                ? "the directions at start and end of the block span no plane that the tool can turn in"
                : "the programmed angles are not where the tool comes to by turning in the plane of its "
                  "directions");
    return std::nullopt;
  };
  const double angle = std::atan2(sweep.from.cross(sweep.to).norm(), sweep.from.dot(sweep.to));
  if (!plan.motion.is_arc && angle > kPi - kOpposite) return refuse(radToDeg(angle));
  ShankTrack track(c.five_axes, PosedWay(motion, plan.motion.is_arc ? &arc : nullptr, sweep));
  if (by_vector) {
    if (!track.followFromStart(now)) return refuse(radToDeg(angle));
  } else if (!track.followFromEnd(end) || !track.startsAt(now)) {
    const bool first = std::abs(track.at(0.0).first - now.first) > kSameDeg;
    return refuse(first ? end.first : end.second);
  }
  return track;
}

}  // namespace proveout::nc
