#include "removal/sweep/kinds/line_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// Elements of the profile of a flat end.
enum FlatElement { kBottom, kFlank, kTop, kFlatElements };

/// The sphere, below its centre, or below the lowest place of that going upright; the flank above it is left
/// to others.
std::optional<SweptSurface> ballSurface(const LineSweep& c, int first, const Vec3& p) {
  const Vec3 way = sweepWay(c);
  const Vec3 q = p - sweepStart(c) - Vec3(0, 0, c.solid->radius);
  const bool whole = c.solid->sphere;  // no flank above it
  if (!whole && way.head<2>().squaredNorm() == 0.0 && q.z() > std::min(0.0, way.z())) return std::nullopt;
  const double length2 = way.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(q.dot(way) / length2, 0.0, 1.0) : 0.0;
  const Vec3 normal = q - t * way;
  if (!whole && normal.z() > 0.0) return std::nullopt;
  return SweptSurface{normal.normalized(), first};
}

/// A cylinder on a line, as seen from one point in plan view.
class FlatSweep {
 public:
  FlatSweep(const LineSweep& columns, int first, const Vec3& p) : c_(columns), first_(first), z_(p.z()) {
    const double qx = p.x() - c_.x, qy = p.y() - c_.y;
    along_ = qx * c_.ux + qy * c_.uy;
    across_ = qx * c_.uy - qy * c_.ux;
    half_ = std::sqrt(std::max(0.0, c_.solid->radius * c_.solid->radius - across_ * across_));
    beyond_ = along_ - std::clamp(along_, 0.0, c_.length);
  }

  /// The end face, or the surface that its rim sweeps; `side` -1: the lower, +1: the upper.
  SweptSurface end(int side) const {
    const bool at_start = startsOver(side);
    const bool rim = c_.slope != 0.0 && (at_start ? half_ < along_ : half_ < c_.length - along_);
    if (!rim) return {Vec3(0, 0, side), first_ + (side < 0 ? kBottom : kTop)};
    // At right angles to the rim and to the motion.
    const double radius = c_.solid->radius, steep = std::abs(c_.slope) / radius;
    const Vec2 out = level(at_start ? half_ : -half_, across_);
    const Vec3 normal(steep * out.x(), steep * out.y(), side * half_ / radius);
    return {normal.normalized(), ConvexProfile::kEdgeIds + first_ + (side < 0 ? kBottom : kFlank)};
  }

  SweptSurface flank() const {
    const Vec2 out = level(beyond_, across_).normalized();
    return {Vec3(out.x(), out.y(), 0), first_ + kFlank};
  }

  double missesFlank() const { return std::abs(std::hypot(beyond_, across_) - c_.solid->radius); }
  double missesEnd(int side) const {
    const double from = std::max(-along_, -half_), to = std::min(c_.length - along_, half_);
    if (from > to) return std::numeric_limits<double>::infinity();
    const double at = along_ + (startsOver(side) ? from : to);
    return std::abs(c_.z + c_.slope * at + (side < 0 ? c_.solid->z_min : c_.solid->z_max) - z_);
  }

 private:
  /// Whether the end bounds the sweep where the tool comes to be over the point, not where it leaves it.
  bool startsOver(int side) const { return c_.slope * side < 0.0; }
  Vec2 level(double along, double across) const {
    return {along * c_.ux + across * c_.uy, along * c_.uy - across * c_.ux};
  }

  const LineSweep& c_;
  int first_;
  double z_, along_, across_, half_, beyond_;  ///< half_: of the chord on which the tool is over the point
};

SweptSurface flatSurface(const LineSweep& c, int first, const Vec3& p, int axis, bool below) {
  const FlatSweep sweep(c, first, p);
  if (axis == 2) return sweep.end(below ? -1 : 1);
  if (c.slope == 0.0) return sweep.flank();
  const double flank = sweep.missesFlank(), lower = sweep.missesEnd(-1), upper = sweep.missesEnd(1);
  if (flank <= std::min(lower, upper)) return sweep.flank();
  return sweep.end(lower <= upper ? -1 : 1);
}

}  // namespace

std::optional<SweptSurface> LineBody::closedSurface(const BodyContext& of, const Vec3& p, int axis,
                                                    bool below) const {
  const int first = of.profile->firstElementId();
  if (solid().ball) return ballSurface(way, first, p);
  if (solid().flat && of.profile->elementCount() == kFlatElements)
    return flatSurface(way, first, p, axis, below);
  return std::nullopt;
}

double LineBody::mostDepth(double x, double y) const {
  const double qx = x - way.x, qy = y - way.y;
  const double along = qx * way.ux + qy * way.uy, across = qx * way.uy - qy * way.ux;
  const double beyond = along - std::clamp(along, 0.0, way.length);
  return depthBeside(std::sqrt(across * across + beyond * beyond));
}

std::optional<double> LineBody::simpleBend(const ConvexProfile::Element& e) const {
  if (e.arc) return e.cr == 0.0 ? std::optional(1.0 / e.radius) : std::nullopt;
  if (e.dz == 0.0) return 0.0;
  if (e.dr != 0.0) return std::nullopt;
  return wallBend(e.ar, e.ar);
}

Vec3 LineBody::directionAt(const Vec3&) const {
  return way.length > 0.0 ? Vec3(way.ux, way.uy, way.slope).normalized() : Vec3::Zero();
}

SweptField LineBody::field(const BodyContext& of) const {
  const Vec3 from = sweepStart(way);
  return SweptField(*of.profile, from, from + sweepWay(way), nullptr);
}

}  // namespace proveout
