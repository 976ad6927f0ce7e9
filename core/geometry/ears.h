// Area of a polygon, and corners that can be cut off it.
#pragma once

#include <vector>

#include "core/geometry/plane.h"

namespace proveout {

/// Twice the area of a polygon, above 0 counter-clockwise.
inline double signedArea2(const std::vector<Vec2>& points) {
  double area2 = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) area2 += cross2(points[i], points[(i + 1) % points.size()]);
  return area2;
}

/// Whether the polygon, counter-clockwise, turns left at point i and no other point lies in or on the
/// triangle there; points that are equal to its corners are allowed.
inline bool isEar(const std::vector<Vec2>& points, std::size_t i) {
  const std::size_t n = points.size(), before = (i + n - 1) % n, after = (i + 1) % n;
  const Vec2 &a = points[before], &b = points[i], &c = points[after];
  if (cross2(b - a, c - b) <= 0.0) return false;
  for (std::size_t j = 0; j < n; ++j) {
    if (j == before || j == i || j == after) continue;
    const Vec2& p = points[j];
    if (p == a || p == b || p == c) continue;
    const bool inside =
        cross2(b - a, p - a) >= 0.0 && cross2(c - b, p - b) >= 0.0 && cross2(a - c, p - c) >= 0.0;
    if (inside) return false;
  }
  return true;
}

}  // namespace proveout
