// A convex outline made ready for many questions: distance to it and where vertical lines meet it.
#pragma once

#include <vector>

#include "core/tool/convex_outline.h"

namespace proveout {

/// Points are (r, z), mm, seen from the control point.
class ThreadOutline {
 public:
  explicit ThreadOutline(const ConvexOutline& outline);

  /// Signed distance, negative inside, with its gradient and the nearest side.
  struct Near {
    double value;
    Vec2 gradient;
    int side;
  };
  Near near(const Vec2& p) const;

  /// The heights of the region at a radius: none where low >= high.
  struct Span {
    double low = 0.0, high = 0.0;
    int low_side = 0, high_side = 0;
  };
  Span spanAt(double r) const;
  /// The outward normal of a side at a point on it.
  Vec2 normalAt(int side, const Vec2& p) const;

  /// Sides that go over into each other smoothly are one face.
  int faceOf(int side) const { return sides_[static_cast<std::size_t>(side)].face; }
  /// The side of a face that is nearest to `p`, as the whole line or circle: signed distance and gradient,
  /// and how far the side itself is.
  struct Face {
    double value;
    Vec2 gradient;
    double distance;
  };
  Face nearFace(int face, const Vec2& p) const;

  Vec2 min() const { return min_; }  ///< of the bounds
  Vec2 max() const { return max_; }

 private:
  struct Side {
    bool arc;
    Vec2 from, to;
    Vec2 along, normal;  ///< of the line or the chord, unit; the normal points outwards
    double length;       ///< of the line or the chord
    Vec2 center;         ///< arc
    double radius;
    Vec2 middle;      ///< direction from the centre to the middle of the arc
    double cos_half;  ///< of half the angle of the arc
    int face;

    bool holds(const Vec2& arm, double size) const { return arm.dot(middle) >= (cos_half - 1e-12) * size; }
  };

  void numberFaces();
  static double distanceTo(const Side& side, const Vec2& p);

  std::vector<Side> sides_;
  Vec2 min_, max_;
};

}  // namespace proveout
