#include "core/nc/services/plane_curves.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

constexpr double kTouchTolerance = 1e-6;  ///< mm; curves that miss each other by less touch
constexpr double kOneCenter = 1e-9;       ///< mm

Meeting meetLineLine(const PlaneCurve& a, const PlaneCurve& b) {
  Meeting m;
  const double sine = cross2(a.direction, b.direction);
  if (std::abs(sine) < 1e-9) return m;  // parallel: would meet farther than 1e6 offsets away
  m.add(a.point + a.direction * (cross2(b.point - a.point, b.direction) / sine));
  return m;
}

Meeting meetLineCircle(const PlaneCurve& line, const PlaneCurve& circle) {
  Meeting m;
  const Vec2 foot = line.point + line.direction * line.direction.dot(circle.point - line.point);
  const double distance = (foot - circle.point).norm();
  if (distance > circle.radius + kTouchTolerance) return m;
  const double half = std::sqrt(std::max(0.0, circle.radius * circle.radius - distance * distance));
  m.add(foot + half * line.direction);
  m.add(foot - half * line.direction);
  return m;
}

Meeting meetCircles(const PlaneCurve& a, const PlaneCurve& b) {
  Meeting m;
  const Vec2 between = b.point - a.point;
  const double d = between.norm();
  if (d < kOneCenter || d > a.radius + b.radius + kTouchTolerance ||
      d < std::abs(a.radius - b.radius) - kTouchTolerance) {
    return m;
  }
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2.0 * d);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vec2 unit = between / d;
  m.add(a.point + along * unit + half * leftOf(unit));
  m.add(a.point + along * unit - half * leftOf(unit));
  return m;
}

}  // namespace

Meeting meet(const PlaneCurve& a, const PlaneCurve& b) {
  if (a.circle) return b.circle ? meetCircles(a, b) : meetLineCircle(b, a);
  return b.circle ? meetLineCircle(a, b) : meetLineLine(a, b);
}

}  // namespace proveout
