#include "removal/compare/self_crossing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/intersections.h"

namespace proveout {
namespace {

using Corners = std::array<Vec3, 3>;

Vec3 normalOf(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

/// How far a triangle reaches to both sides of a plane: the less of both.
double reachThrough(const Corners& t, const Vec3& on_plane, const Vec3& normal) {
  double above = 0.0, below = 0.0;
  for (const Vec3& p : t) {
    const double side = (p - on_plane).dot(normal);
    above = std::max(above, side);
    below = std::max(below, -side);
  }
  return std::min(above, below);
}

/// Where a triangle meets a plane: from and to along the plane's line `way`.
struct Stretch {
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  void extend(double t) {
    begin = std::min(begin, t);
    end = std::max(end, t);
  }
};

Stretch stretchIn(const Corners& t, const Vec3& on_plane, const Vec3& normal, const Vec3& way) {
  Stretch out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    const double of_a = (a - on_plane).dot(normal), of_b = (b - on_plane).dot(normal);
    if (of_a * of_b > 0.0 || of_a == of_b) continue;
    out.extend(way.dot(a + of_a / (of_a - of_b) * (b - a)));
  }
  return out;
}

/// One pair of triangles.
struct Crossing {
  double depth = 0.0;
  Vec3 where = Vec3::Zero();
};

Crossing crossingOf(const Corners& p, const Corners& q) {
  const Vec3 n = normalOf(p), m = normalOf(q);
  if (!n.allFinite() || !m.allFinite()) return {};
  const Vec3 across = n.cross(m);
  const double through = std::min(reachThrough(p, q[0], m), reachThrough(q, p[0], n));
  if (!(through > 0.0) || !(across.norm() > 0.0)) return {};
  const Vec3 way = across.normalized();
  const Stretch in_p = stretchIn(p, q[0], m, way), in_q = stretchIn(q, p[0], n, way);
  const double begin = std::max(in_p.begin, in_q.begin), end = std::min(in_p.end, in_q.end);
  if (!(end > begin)) return {};
  // The point of the line of both planes nearest to the origin, and from there along it.
  const double middle = 0.5 * (begin + end);
  const double cosine = n.dot(m), sine2 = 1.0 - cosine * cosine, of_n = n.dot(p[0]), of_m = m.dot(q[0]);
  const Vec3 on_line = (of_n - cosine * of_m) / sine2 * n + (of_m - cosine * of_n) / sine2 * m;
  return {std::min(through, end - begin), on_line + middle * way};
}

}  // namespace

SelfCrossing findSelfCrossing(const Shells& shells) {
  PROVEOUT_ASSERT(shells.shell_of.size() == shells.mesh.triangles.size());
  const std::vector<std::uint8_t> all(shells.mesh.triangles.size(), 1);
  SelfCrossing out;
  for (const auto& [s, t] : findIntersectionsOf(shells.mesh, all)) {
    if (s == t || shells.shell_of[s] != shells.shell_of[t]) continue;
    const Crossing crossing = crossingOf(cornersOf(shells.mesh, s), cornersOf(shells.mesh, t));
    if (crossing.depth <= kCrossingRoundingMm) continue;
    ++out.pairs;
    if (crossing.depth <= out.depth_mm) continue;
    out.depth_mm = crossing.depth;
    out.where = crossing.where;
  }
  return out;
}

}  // namespace proveout
