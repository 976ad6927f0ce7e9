#include "core/nc/services/contour/contour_crossing.h"

#include <cmath>

namespace proveout {
namespace {

/// Angle that is passed on the circle going clockwise from `start` to `p`, 0 to a full turn.
double clockwise(const PlaneCurve& circle, const Vec2& start, const Vec2& p) {
  const Vec2 a = start - circle.point, b = p - circle.point;
  const double angle = -std::atan2(cross2(a, b), a.dot(b));
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

}  // namespace

std::optional<Vec2> crossingPoint(const PlaneCurve& first, const PlaneCurve& second, const Vec2& start,
                                  CrossingChoice choice) {
  const Meeting m = meet(first, second);
  if (m.count == 0) return std::nullopt;
  if (m.count == 1) return m.points[0];
  bool in_order = false;
  if (first.circle && second.circle) {
    in_order = clockwise(first, start, m.points[0]) <= clockwise(first, start, m.points[1]);
  } else {
    const Vec2& along = first.circle ? second.direction : first.direction;
    in_order = along.dot(m.points[0]) <= along.dot(m.points[1]);
  }
  return m.points[in_order == (choice == CrossingChoice::kFirst) ? 0 : 1];
}

}  // namespace proveout
