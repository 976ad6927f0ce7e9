// Where a straight line of any direction goes through convex solids of revolution that move along a line: the
// columns of tools that lean, seen from the tool.
//
// All of it is in the tool's frame: its axis is +z, its tip at the start of its way at the origin. mm.
#pragma once

#include "core/geometry/types.h"
#include "core/tool/profile.h"
#include "removal/sweep/kinds/scalar_body.h"

namespace proveout {

/// The points from + t * along.
struct SpaceLine {
  Vec3 from, along;  ///< along: unit
  Vec3 at(double t) const { return from + t * along; }
};

/// The real roots of a t^2 + 2 b t + c, lower one first; none: both are NaN.
struct QuadraticRoots {
  double low, high;
};
QuadraticRoots quadraticRoots(double a, double b, double c);

/// Collects where a line meets faces of a solid that goes from the origin to `way`. Every face adds points
/// that the solid holds at some place of its way, within 1e-9 mm; those of all of its faces include the ends
/// of the interval in which the line lies in the swept volume.
///
/// The ends of that interval lie where the solid stands at an end of its way, or where the normal of its face
/// is at right angles to the way. There the volume's boundary is that of a rim, which sweeps a slanted
/// cylinder; of a cylinder or cone, which leaves planes; of a sphere, which leaves a cylinder; or of a round
/// corner. The latter is what is within a radius of a swept disc, whose distance is convex along the line:
/// Newton's method from outside never leaps over its ends.
class LineMeeting {
 public:
  LineMeeting(const SpaceLine& line, const Vec3& way) : line_(line), way_(way) {}

  /// All faces of a solid.
  void meet(const ConvexProfile& profile);
  /// A cylinder from height `low` to `high`.
  void meetCylinder(double radius, double low, double high);

  /// Of t; empty where nothing was met.
  const ColumnSpan& span() const { return span_; }

 private:
  using Element = ConvexProfile::Element;
  void take(double t) {
    if (t < span_.lo) span_.lo = t;
    if (t > span_.hi) span_.hi = t;
  }
  void meetDisc(double radius, double height);
  void meetStraight(const Element& e);
  void meetPlanes(const Element& e);
  void meetStanding(const Element& e, double s);
  void meetBall(const Element& e);
  void meetCorner(const Element& e);
  /// The interval in which the line is within `radius` of the way of a point; NaN: none.
  QuadraticRoots capsule(double height, double radius) const;

  SpaceLine line_;
  Vec3 way_;
  ColumnSpan span_;
};

}  // namespace proveout
