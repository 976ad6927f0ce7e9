#include "core/nc/services/arcs.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {
namespace arcs_detail {

constexpr double kTurn = 2.0 * kPi;
/// mm; a radius below it has no direction. Far below any increment, above rounding noise.
constexpr double kTinyRadius = 1e-9;

bool allFinite(const ArcRequest& r) {
  return r.start.allFinite() && r.end.allFinite() && std::isfinite(r.center_u.value_or(0.0)) &&
         std::isfinite(r.center_v.value_or(0.0)) && std::isfinite(r.radius.value_or(0.0));
}

/// Centre from a radius word; a radius below half the chord is the start radius of a half turn (7.2 rule 7).
Vec2 centerFromRadius(const Vec2& start, const Vec2& end, double radius, bool ccw) {
  const Vec2 chord = end - start;
  const double length = chord.norm();
  const double magnitude = std::abs(radius);
  if (magnitude < 0.5 * length) return start + chord * (magnitude / length);
  const double height = std::sqrt(std::max(0.0, magnitude * magnitude - 0.25 * length * length));
  const double side = ccw == (radius > 0.0) ? 1.0 : -1.0;
  return 0.5 * (start + end) + Vec2(-chord.y(), chord.x()) * (side * height / length);
}

/// Angle from start to end in the arc's direction, in (0, 2 pi] up to the tolerance.
double partialTurn(const PlaneArc& arc, bool ccw, double tolerance) {
  if (arc.startRadius() < kTinyRadius || arc.endRadius() < kTinyRadius) return kTurn;
  const Vec2 a = arc.start.head<2>() - arc.center;
  const Vec2 b = arc.end.head<2>() - arc.center;
  double part = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (!ccw) part = -part;
  if (part <= tolerance && part >= -tolerance) return kTurn + part;
  return part < 0.0 ? part + kTurn : part;
}

ArcError checkWords(const ArcRequest& r, const ArcPolicy& policy) {
  if (!allFinite(r)) return ArcError::kNotFinite;
  if (r.center_word_outside_plane) return ArcError::kCenterOutsidePlane;
  if (!r.radius && !r.center_u && !r.center_v) return ArcError::kNoDefinition;
  if (r.turns && (*r.turns < 1 || *r.turns > policy.max_turns)) return ArcError::kBadTurns;
  if (r.radius && *r.radius == 0.0) return ArcError::kZeroRadius;
  return ArcError::kNone;
}

}  // namespace arcs_detail

ArcResolution resolveArc(const ArcRequest& request, const ArcPolicy& policy) {
  using namespace arcs_detail;
  ArcResolution result;
  result.error = checkWords(request, policy);
  if (!result.ok()) return result;
  PlaneArc& arc = result.arc;
  arc.start = request.start;
  arc.end = request.end;
  if (request.radius) {
    result.center_ignored = request.center_u || request.center_v;
    const bool moves_in_plane = (arc.end - arc.start).head<2>().norm() > kTinyRadius;
    if (!request.has_plane_end || !moves_in_plane) {
      if (request.has_other_axis) result.error = ArcError::kRadiusWithoutEnd;
      result.no_motion = !request.has_other_axis;
      return result;
    }
    const double missing = 0.5 * (arc.end - arc.start).head<2>().norm() - std::abs(*request.radius);
    if (policy.short_radius_is_half && missing > 0.0) {
      result.radius_difference = missing;
      result.error = missing > policy.radius_tolerance ? ArcError::kRadiusDifference : ArcError::kNone;
      arc.center = 0.5 * (arc.start + arc.end).head<2>();
      arc.sweep_rad = request.counter_clockwise ? kPi : -kPi;
      return result;
    }
    arc.center =
        centerFromRadius(arc.start.head<2>(), arc.end.head<2>(), *request.radius, request.counter_clockwise);
  } else {
    arc.center = arc.start.head<2>() + Vec2(request.center_u.value_or(0.0), request.center_v.value_or(0.0));
  }
  const double r0 = arc.startRadius(), r1 = arc.endRadius();
  result.radius_difference = std::abs(r0 - r1);
  if (r0 < kTinyRadius && r1 < kTinyRadius) {
    result.error = ArcError::kZeroRadius;
  } else if (!request.turns && result.radius_difference > policy.radius_tolerance) {
    result.error = ArcError::kRadiusDifference;
  }
  const double sweep = partialTurn(arc, request.counter_clockwise, policy.angle_tolerance_rad) +
                       kTurn * static_cast<double>(request.turns.value_or(1) - 1);
  PROVEOUT_ASSERT(!(sweep < 0.0));
  arc.sweep_rad = request.counter_clockwise ? sweep : -sweep;
  return result;
}

ArcGeometry toArcGeometry(const PlaneArc& arc, const PlaneFrame& frame) {
  return {frame.fromPlane({arc.center.x(), arc.center.y(), arc.start.z()}), frame.normal(), arc.sweep_rad};
}

PlaneArc reversed(const PlaneArc& arc) { return {arc.end, arc.start, arc.center, -arc.sweep_rad}; }

double farthestFromStart(const PlaneArc& arc) {
  const double radius = std::min(arc.startRadius(), arc.endRadius());
  return 2.0 * radius * std::sin(0.5 * std::min(std::abs(arc.sweep_rad), kPi));
}

double planeLength(const PlaneArc& arc) {
  const double r0 = arc.startRadius(), r1 = arc.endRadius();
  const double theta = std::abs(arc.sweep_rad);
  const double change = std::abs(r1 - r0);
  // Below this the mean radius is exact to 1e-14 and the closed form would lose digits.
  if (theta == 0.0 || change <= 1e-7 * std::max(r0, r1)) return 0.5 * (r0 + r1) * theta;
  const double k = change / theta;
  const auto primitive = [k](double r) {
    return 0.5 * (r * std::sqrt(r * r + k * k) + k * k * std::asinh(r / k));
  };
  return std::abs(primitive(r1) - primitive(r0)) / k;
}

}  // namespace proveout
