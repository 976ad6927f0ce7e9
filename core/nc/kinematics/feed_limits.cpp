#include "core/nc/kinematics/feed_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout::nc {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
/// Axes with a smaller part in a motion do not limit it: rounding noise of the coordinate chain.
constexpr double kNoPart = 1e-9;
/// Smallest radius that the acceleration across a spiral is taken at, mm; at radius 0 it would stop.
constexpr double kLeastRadius = 1e-3;

/// The smallest of limit / part over the axes that have a limit.
template <class Limit, class Part>
double tightest(int axes, const Limit& limit, const Part& part) {
  double least = kNone;
  for (int k = 0; k < axes; ++k) {
    const double bound = limit(k);
    const double share = std::abs(part(k));
    if (bound > 0.0 && share > kNoPart) least = std::min(least, bound / share);
  }
  return least;
}

const AxisMotionLimits& of(const MotionLimits& limits, int axis) {
  return limits.axes[static_cast<std::size_t>(axis)];
}

/// The largest part of a main axis in any direction of the arc: in the plane and along its normal.
double arcPart(const ArcPace& pace, double rise, int axis) {
  const double n = std::abs(pace.arc.normal[axis]);
  const double climb = pace.length > 0.0 ? std::min(1.0, std::abs(rise) / pace.length) : 0.0;
  return std::sqrt(std::max(0.0, 1.0 - n * n)) * std::sqrt(1.0 - climb * climb) + n * climb;
}

/// Curvature of a helix or spiral: that of its circle, less what its climb stretches.
double curvature(double radius, double climb_per_rad) {
  return radius / (radius * radius + climb_per_rad * climb_per_rad);
}

}  // namespace

double allowedFeed(const MotionLimits& limits, const AxisPoint& direction, int axes, double feed) {
  const double most = tightest(
      axes, [&](int k) { return of(limits, k).max_feed; }, [&](int k) { return direction[k]; });
  return std::min(feed, most);
}

double allowedArcFeed(const MotionLimits& limits, const ArcPace& pace, double feed) {
  const ArcFrame frame = arcFrame(pace.from, pace.to, pace.arc);
  const double most = tightest(
      kMainAxes, [&](int k) { return of(limits, k).max_feed; },
      [&](int k) { return arcPart(pace, frame.rise, k); });
  const double across = tightest(
      kMainAxes, [&](int k) { return of(limits, k).normal; },
      [&](int k) { return std::sqrt(std::max(0.0, 1.0 - pace.arc.normal[k] * pace.arc.normal[k])); });
  const double radius = std::max(kLeastRadius, std::min(frame.radius_start, frame.radius_end));
  const double turning = std::max(60.0 * std::sqrt(across * radius), limits.least_arc_feed);
  return std::min({feed, most, turning});
}

double lineAcceleration(const MotionLimits& limits, const AxisPoint& direction, int axes) {
  return tightest(
      axes, [&](int k) { return of(limits, k).acceleration; }, [&](int k) { return direction[k]; });
}

void setArcPace(const MotionLimits& limits, const ArcPace& arc, MotionPace& pace) {
  const ArcFrame frame = arcFrame(arc.from, arc.to, arc.arc);
  const double sweep = arc.arc.sweep_rad;
  const double climb = frame.rise / sweep;  // per radian, signed
  const double growth = (frame.radius_end - frame.radius_start) / sweep;
  const auto tangent = [&](double angle, double radius) {
    const Vec3 out = std::cos(angle) * frame.u + std::sin(angle) * frame.v;
    const Vec3 along = -std::sin(angle) * frame.u + std::cos(angle) * frame.v;
    const Vec3 step = radius * along + growth * out + climb * frame.n;
    return Vec3(std::copysign(1.0, sweep) * step.normalized());
  };
  const auto towardsCentre = [&](double angle, double radius) {
    return Vec3(-curvature(radius, climb) * (std::cos(angle) * frame.u + std::sin(angle) * frame.v));
  };
  pace.arc = true;
  pace.begin = tangent(0.0, frame.radius_start);
  pace.end = tangent(sweep, frame.radius_end);
  pace.begin_curve = towardsCentre(0.0, std::max(kLeastRadius, frame.radius_start));
  pace.end_curve = towardsCentre(sweep, std::max(kLeastRadius, frame.radius_end));
  pace.acceleration = tightest(
      kMainAxes, [&](int k) { return of(limits, k).acceleration; },
      [&](int k) { return arcPart(arc, frame.rise, k); });
}

Vec3 cornerCurve(const MotionPace& before, const MotionPace& after) {
  if (before.arc || after.arc) return Vec3::Zero();
  return 2.0 / (before.length + after.length) * (after.begin.xyz - before.end.xyz);
}

double cornerSpeed(const MotionLimits& limits, const MotionPace& before, const MotionPace& after, int axes) {
  double speed = kNone;
  if (limits.corner_by_angle) {
    double dot = 0.0, a = 0.0, b = 0.0;
    for (int k = 0; k < axes; ++k) {
      dot += before.end[k] * after.begin[k];
      a += before.end[k] * before.end[k];
      b += after.begin[k] * after.begin[k];
    }
    const double turn = radToDeg(std::acos(std::clamp(dot / std::sqrt(a * b), -1.0, 1.0)));
    // Tangents of arcs carry rounding; a corner of a micro-degree is none.
    constexpr double kSlackDeg = 1e-6;
    if (limits.corner_angle_deg > 0.0 && turn > limits.corner_angle_deg + kSlackDeg) {
      speed = limits.corner_feed / 60.0;
    }
  } else {
    speed = tightest(
                axes, [&](int k) { return of(limits, k).speed_change; },
                [&](int k) { return after.begin[k] - before.end[k]; }) /
            60.0;
  }
  const bool arc = before.arc || after.arc;
  const Vec3 bend = arc ? Vec3(after.begin_curve - before.end_curve) : after.corner_curve;
  const Vec3 change = arc ? bend : Vec3(after.corner_curve - before.corner_curve);
  const double across = tightest(
      kMainAxes, [&](int k) { return arc ? 0.0 : of(limits, k).normal; }, [&](int k) { return bend[k]; });
  const double jump = tightest(
      kMainAxes, [&](int k) { return arc ? of(limits, k).jump_arc : of(limits, k).jump; },
      [&](int k) { return change[k]; });
  return std::min(speed, std::sqrt(std::min(across, jump)));
}

}  // namespace proveout::nc
