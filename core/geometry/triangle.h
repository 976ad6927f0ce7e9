// Triangles in space.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/geometry/types.h"

namespace proveout {

/// Squared distance of `p` to the triangle, which may be flat (a segment or a point).
inline double squaredDistance(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  const auto toEdge = [&](const Vec3& a, const Vec3& e) {
    const double length2 = e.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(e) / length2, 0.0, 1.0) : 0.0;
    return (p - a - s * e).squaredNorm();
  };
  const double aa = ab.squaredNorm(), bb = ac.squaredNorm(), c = ab.dot(ac), det = aa * bb - c * c;
  if (det > 1e-14 * aa * bb) {
    const double u = bb * d1 - c * d2, v = aa * d2 - c * d1;
    if (u >= 0.0 && v >= 0.0 && u + v <= det) {
      const Vec3 n = ab.cross(ac);
      const double up = n.dot(ap);
      return up * up / n.squaredNorm();
    }
  }
  return std::min({toEdge(t[0], ab), toEdge(t[0], ac), toEdge(t[1], t[2] - t[1])});
}

}  // namespace proveout
