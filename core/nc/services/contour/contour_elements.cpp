#include "core/nc/services/contour/contour_elements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/plane.h"

namespace proveout {

ContourElement lineElement(const Vec2& from, const Vec2& to) {
  ContourElement e;
  e.from = from;
  e.to = to;
  return e;
}

ContourElement arcElement(const Vec2& center, const Vec2& from, const Vec2& to, double sweep) {
  ContourElement e = lineElement(from, to);
  e.arc = true;
  e.center = center;
  e.sweep = sweep;
  return e;
}

Vec2 pointOn(const ContourElement& e, double t) {
  if (t <= 0.0) return e.from;
  if (t >= 1.0) return e.to;
  if (!e.arc) return e.from + t * (e.to - e.from);
  const Vec2 arm = e.from - e.center;
  const double angle = std::atan2(arm.y(), arm.x()) + t * e.sweep;
  return e.center + arm.norm() * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 directionOn(const ContourElement& e, bool end) {
  if (!e.arc) return (e.to - e.from).normalized();
  const Vec2 arm = ((end ? e.to : e.from) - e.center).normalized();
  return e.sweep > 0.0 ? leftOf(arm) : Vec2(-leftOf(arm));
}

ContourElement partOf(const ContourElement& e, double t0, double t1) {
  ContourElement out = e;
  out.from = pointOn(e, t0);
  out.to = pointOn(e, t1);
  out.sweep = e.sweep * (t1 - t0);
  return out;
}

double distanceFrom(const ContourElement& e, const Vec2& p) {
  const double ends = std::min((p - e.from).norm(), (p - e.to).norm());
  if (!e.arc) {
    const Vec2 way = e.to - e.from;
    const double t = std::clamp((p - e.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (p - e.from - t * way).norm();
  }
  const double inside = sweepUntil(e, p);
  return inside <= std::abs(e.sweep)
             ? std::min(ends, std::abs((p - e.center).norm() - (e.from - e.center).norm()))
             : ends;
}

bool goesOneWay(const PlaneContour& contour, int axis) {
  constexpr double kSame = 1e-6;
  const double way = contour.back().to[axis] - contour.front().from[axis];
  for (const ContourElement& e : contour) {
    Vec2 last = e.from;
    for (int k = 1; k <= 16; ++k) {
      const Vec2 next = pointOn(e, k / 16.0);
      if ((next[axis] - last[axis]) * way < -kSame * std::abs(way)) return false;
      last = next;
    }
  }
  return true;
}

CornerError cutChamfers(PlaneContour& contour, const std::vector<double>& lengths) {
  PlaneContour cut;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    if (lengths[k] <= 0.0 || k + 1 == contour.size()) {
      cut.push_back(contour[k]);
      continue;
    }
    CornerJoin join;
    const CornerError error = chamferCorner(contour[k], contour[k + 1], lengths[k], join);
    if (error != CornerError::kNone) return error;
    ContourElement first = contour[k], &second = contour[k + 1];
    if (join.none) {
      cut.push_back(first);
      continue;
    }
    if (first.arc) first.sweep -= std::copysign(sweepFrom(first, join.leave), first.sweep);
    if (second.arc) second.sweep -= std::copysign(sweepUntil(second, join.enter), second.sweep);
    first.to = join.leave;
    second.from = join.enter;
    ContourElement between = lineElement(join.leave, join.enter);
    between.source = first.source;
    cut.push_back(first);
    cut.push_back(between);
  }
  contour = std::move(cut);
  return CornerError::kNone;
}

}  // namespace proveout
