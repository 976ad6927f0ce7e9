#include "core/nc/services/contour/contour_corner.h"

#include <cmath>
#include <optional>

#include "core/nc/services/plane_curves.h"

namespace proveout {
namespace {

constexpr double kTinyLength = 1e-9;                   ///< mm; displacements below it are none
constexpr double kTangentTolerance = degToRad(0.001);  ///< corners straighter than this are none
constexpr double kFit = 1e-7;  ///< mm; what exactly fills an element fits, whatever rounding makes of it

double sense(const ContourElement& e) { return e.sweep >= 0.0 ? 1.0 : -1.0; }

bool sound(const ContourElement& e) {
  if (!e.from.allFinite() || !e.to.allFinite()) return false;
  if (!e.arc) return (e.to - e.from).norm() > kTinyLength;
  if (!e.center.allFinite() || !std::isfinite(e.sweep)) return false;
  return e.sweep != 0.0 && (e.from - e.center).norm() > kTinyLength && (e.to - e.center).norm() > kTinyLength;
}

Vec2 tangentAt(const ContourElement& e, const Vec2& p) {
  if (!e.arc) return (e.to - e.from).normalized();
  return sense(e) * leftOf((p - e.center).normalized());
}

/// Angle from a to b about `center` in the direction of `sign`, 0 to a full turn.
double turn(const Vec2& center, const Vec2& from, const Vec2& to, double sign) {
  const Vec2 a = from - center, b = to - center;
  const double angle = sign * std::atan2(cross2(a, b), a.dot(b));
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

/// The point at the chord or distance `length` from the corner on `e`; `back`: before its end, else behind
/// its start. None: the element is too short.
std::optional<Vec2> pointAt(const ContourElement& e, double length, bool back) {
  const Vec2 corner = back ? e.to : e.from;
  if (!e.arc) {
    if (length > (e.to - e.from).norm() + kFit) return std::nullopt;
    return corner + (back ? -length : length) * tangentAt(e, corner);
  }
  const Vec2 arm = corner - e.center;
  const double half = 0.5 * length / arm.norm();
  if (half > 1.0) return std::nullopt;
  const double angle = 2.0 * std::asin(half);
  if (angle > std::abs(e.sweep) + kFit / arm.norm()) return std::nullopt;
  const double a = (back ? -angle : angle) * sense(e);
  return e.center + std::cos(a) * arm + std::sin(a) * leftOf(arm);
}

/// The element shifted by `offset` to the left, at its end (`back`) or start.
std::optional<PlaneCurve> shifted(const ContourElement& e, double offset, bool back) {
  if (!e.arc) {
    const Vec2 t = tangentAt(e, e.from);
    return PlaneCurve{false, e.from + offset * leftOf(t), t, 0.0};
  }
  const double radius = ((back ? e.to : e.from) - e.center).norm() - sense(e) * offset;
  if (radius < kTinyLength) return std::nullopt;
  return PlaneCurve{true, e.center, Vec2::UnitX(), radius};
}

/// Where the circle about `center` touches `e`. None: beyond its far end or the corner.
std::optional<Vec2> touch(const ContourElement& e, const Vec2& center, bool back) {
  if (!e.arc) {
    const Vec2 t = tangentAt(e, e.from);
    const double along = t.dot(center - e.from), length = (e.to - e.from).norm();
    if (along < -kFit || along > length + kFit) return std::nullopt;
    return e.from + along * t;
  }
  const double radius = ((back ? e.to : e.from) - e.center).norm();
  const Vec2 p = e.center + radius * (center - e.center).normalized();
  const double angle = back ? sweepFrom(e, p) : sweepUntil(e, p);
  const double slack = kFit / radius;
  if (angle > std::abs(e.sweep) + slack && angle < 2.0 * kPi - slack) return std::nullopt;
  return p;
}

}  // namespace

double sweepUntil(const ContourElement& arc, const Vec2& p) {
  return turn(arc.center, arc.from, p, sense(arc));
}
double sweepFrom(const ContourElement& arc, const Vec2& p) { return turn(arc.center, p, arc.to, sense(arc)); }

CornerError chamferCorner(const ContourElement& first, const ContourElement& second, double length,
                          CornerJoin& join) {
  join = {};
  if (!sound(first) || !sound(second) || !std::isfinite(length)) return CornerError::kNoDirection;
  const Vec2 t1 = tangentAt(first, first.to), t2 = tangentAt(second, second.from);
  join.none = std::abs(cross2(t1, t2)) < kTangentTolerance && t1.dot(t2) > 0.0;
  if (join.none) return CornerError::kNone;
  const auto leave = pointAt(first, length, true), enter = pointAt(second, length, false);
  if (!leave || !enter) return CornerError::kTooLarge;
  join.leave = *leave;
  join.enter = *enter;
  return CornerError::kNone;
}

CornerError roundCorner(const ContourElement& first, const ContourElement& second, double radius,
                        CornerJoin& join) {
  join = {};
  if (!sound(first) || !sound(second) || !std::isfinite(radius)) return CornerError::kNoDirection;
  const Vec2 t1 = tangentAt(first, first.to), t2 = tangentAt(second, second.from);
  const double sine = cross2(t1, t2);
  join.none = std::abs(sine) < kTangentTolerance && t1.dot(t2) > 0.0;
  if (join.none) return CornerError::kNone;
  const double side = sine > 0.0 ? 1.0 : -1.0;
  const auto a = shifted(first, side * radius, true), b = shifted(second, side * radius, false);
  if (!a || !b) return CornerError::kTooLarge;
  const Meeting m = meet(*a, *b);
  bool found = false;
  for (std::size_t k = 0; k < m.count; ++k) {
    const Vec2 center = m.points[k];
    if (found && (center - first.to).norm() >= (join.center - first.to).norm()) continue;
    const auto leave = touch(first, center, true), enter = touch(second, center, false);
    if (!leave || !enter) continue;
    join.leave = *leave;
    join.enter = *enter;
    join.center = center;
    found = true;
  }
  if (!found) return CornerError::kTooLarge;
  join.arc = true;
  join.sweep = side * turn(join.center, join.leave, join.enter, side);
  return CornerError::kNone;
}

}  // namespace proveout
