#include "core/nc/services/contour/contour_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/box_tree.h"
#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/plane_curves.h"

namespace proveout {

namespace {

constexpr double kOnElement = 1e-7;  ///< mm; points nearer than this are on an element
constexpr double kPointLike = 1e-12;

PlaneCurve wholeCurve(const ContourElement& e) {
  PlaneCurve curve;
  curve.circle = e.arc;
  curve.point = e.arc ? e.center : e.from;
  curve.direction = (e.to - e.from).normalized();
  curve.radius = e.arc ? (e.from - e.center).norm() : 0.0;
  return curve;
}

bool isPoint(const ContourElement& e) { return !e.arc && (e.to - e.from).norm() < kPointLike; }

double awayFrom(const ContourElement& e, const Vec2& p) {
  return isPoint(e) ? (p - e.from).norm() : distanceFrom(e, p);
}

/// Distance of `b` from the points of the arc `a` in that direction from its centre, both ways.
double fromArcAlong(const ContourElement& a, const Vec2& direction, const ContourElement& b) {
  const double length = direction.norm();
  double least = INFINITY;
  if (length < kPointLike) return least;
  for (const double side : {-1.0, 1.0}) {
    const Vec2 p = a.center + side * (a.from - a.center).norm() / length * direction;
    if (awayFrom(a, p) < kOnElement) least = std::min(least, awayFrom(b, p));
  }
  return least;
}

/// From the points of `a` that may be nearest to `b`: its ends and where its way is parallel to that of `b`.
double fromPointsOf(const ContourElement& a, const ContourElement& b) {
  double least = std::min(awayFrom(b, a.from), awayFrom(b, a.to));
  if (a.arc) {
    const Vec2 toward = b.arc ? Vec2(b.center - a.center) : leftOf(b.to - b.from);
    least = std::min(least, fromArcAlong(a, toward, b));
  } else if (b.arc) {
    least = std::min(least, awayFrom(b, nearestOnSegment(b.center, a.from, a.to)));
  }
  return least;
}

bool crosses(const ContourElement& a, const ContourElement& b) {
  if (isPoint(a) || isPoint(b)) return false;
  const Meeting common = meet(wholeCurve(a), wholeCurve(b));
  for (std::size_t k = 0; k < common.count; ++k) {
    const Vec2& p = common.points[k];
    if (awayFrom(a, p) < kOnElement && awayFrom(b, p) < kOnElement) return true;
  }
  return false;
}

Box3 boxOf(const ContourElement& e) {
  Box3 box;
  const auto add = [&](const Vec2& p) { box.extend(Vec3(p.x(), p.y(), 0.0)); };
  add(e.from);
  add(e.to);
  if (e.arc) {
    const double radius = (e.from - e.center).norm();
    add(e.center - Vec2::Constant(radius));
    add(e.center + Vec2::Constant(radius));
  }
  return box;
}

/// A circle about an element.
struct Surrounding {
  Vec2 at;
  double radius;
};

Surrounding surroundingOf(const ContourElement& e) {
  if (e.arc) return {e.from, std::abs(e.sweep) * (e.from - e.center).norm()};
  return {0.5 * (e.from + e.to), 0.5 * (e.to - e.from).norm()};
}

/// Whether circles about both say that they are no nearer than `least`: so it is with most of the short
/// elements of a long contour.
bool areFar(const Surrounding& a, const Surrounding& b, double least) {
  const double reach = least + a.radius + b.radius;
  return (a.at - b.at).squaredNorm() > reach * reach;
}

/// Lines that cross have an end that is no farther from the other than half of their length.
bool mayCross(const ContourElement& a, const ContourElement& b, double between_ends) {
  if (a.arc || b.arc) return true;
  return between_ends <= 0.5 * std::min((a.to - a.from).norm(), (b.to - b.from).norm()) + kOnElement;
}

}  // namespace

double distanceBetween(const ContourElement& a, const ContourElement& b) {
  const double between = std::min(fromPointsOf(a, b), fromPointsOf(b, a));
  return mayCross(a, b, between) && crosses(a, b) ? 0.0 : between;
}

std::optional<NearPass> firstNearPass(const std::vector<ContourElement>& path,
                                      const std::vector<ContourElement>& contour, double least) {
  if (contour.empty()) return std::nullopt;
  std::vector<Box3> boxes;
  std::vector<Surrounding> surroundings;
  for (const ContourElement& e : contour) {
    boxes.push_back(boxOf(e));
    surroundings.push_back(surroundingOf(e));
  }
  const BoxTree tree(boxes);
  for (std::size_t k = 0; k < path.size(); ++k) {
    std::optional<NearPass> pass;
    const Surrounding own = surroundingOf(path[k]);
    tree.forEachPlace(boxOf(path[k]).inflated(least), [&](std::uint32_t place) {
      const std::size_t other = tree.order()[place];
      if (areFar(own, surroundings[other], least)) return;
      const double distance = distanceBetween(path[k], contour[other]);
      if (distance < least && (!pass || distance < pass->distance)) pass = NearPass{k, other, distance};
    });
    if (pass) return pass;
  }
  return std::nullopt;
}

}  // namespace proveout
