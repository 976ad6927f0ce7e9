// Vectors, segments and points of a plane.
#pragma once

#include <algorithm>

#include "core/geometry/types.h"

namespace proveout {

/// A quarter turn to the left.
inline Vec2 leftOf(const Vec2& t) { return {-t.y(), t.x()}; }
/// Above 0 where `b` points to the left of `a`.
inline double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The point of the segment from a to b (which may be one point) that is nearest to p.
inline Vec2 nearestOnSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  return a + (length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0) * d;
}
inline double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (p - nearestOnSegment(p, a, b)).norm();
}

}  // namespace proveout
