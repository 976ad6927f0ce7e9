#include "core/nc/services/contour/contour_shift.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

namespace {

constexpr double kPointRadius = 1e-9;  ///< mm; smaller arcs are points
constexpr double kNothing = 1e-9;      ///< mm on lines, radians on arcs

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

double angleAt(const ContourElement& arc, const Vec2& p) {
  return std::atan2(p.y() - arc.center.y(), p.x() - arc.center.x());
}

}  // namespace

double turnOf(const Vec2& t1, const Vec2& t2) { return std::atan2(cross2(t1, t2), t1.dot(t2)); }

std::optional<PlaneCurve> shiftedCurve(const ContourElement& element, double offset) {
  PlaneCurve curve;
  if (!element.arc) {
    curve.direction = directionOn(element, false);
    curve.point = element.from + offset * leftOf(curve.direction);
    return curve;
  }
  curve.circle = true;
  curve.point = element.center;
  curve.radius = (element.from - element.center).norm() - std::copysign(offset, element.sweep * offset);
  if (curve.radius < -kPointRadius) return std::nullopt;
  curve.radius = std::max(curve.radius, 0.0);
  return curve;
}

ContourElement cutTo(const ContourElement& element, const Vec2& from, const Vec2& to) {
  ContourElement cut = element;
  cut.from = from;
  cut.to = to;
  if (!element.arc) return cut;
  const double shrunk = wrapped(angleAt(element, from) - angleAt(element, element.from)) -
                        wrapped(angleAt(element, to) - angleAt(element, element.to));
  cut.sweep = element.sweep - shrunk;
  // An arc of no radius turns on the spot.
  if ((from - element.center).norm() < kPointRadius) {
    cut = lineElement(from, to);
    cut.source = element.source;
  }
  return cut;
}

bool runsBack(const ContourElement& element, const ContourElement& cut) {
  if (cut.arc) return (element.sweep > 0.0 ? cut.sweep : -cut.sweep) < -kNothing;
  return (cut.to - cut.from).dot(directionOn(element, true)) < -kNothing;
}

CornerError roundBetween(ContourElement& a, ContourElement& b, double radius,
                         std::optional<ContourElement>& arc) {
  arc.reset();
  CornerJoin join;
  const CornerError error = roundCorner(a, b, radius, join);
  if (error != CornerError::kNone || join.none) return error;
  a = cutTo(a, a.from, join.leave);
  b = cutTo(b, join.enter, b.to);
  arc = arcElement(join.center, join.leave, join.enter, join.sweep);
  return CornerError::kNone;
}

std::optional<Vec2> nearestMeeting(const PlaneCurve& a, const PlaneCurve& b, const Vec2& near) {
  const Meeting common = meet(a, b);
  if (common.count == 0) return std::nullopt;
  if (common.count == 1) return common.points[0];
  const bool first = (common.points[0] - near).norm() <= (common.points[1] - near).norm();
  return common.points[first ? 0 : 1];
}

}  // namespace proveout
