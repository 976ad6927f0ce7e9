#include "removal/compare/self_crossing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
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

/// Every third bit of a number of ten bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000FFu;
  x = (x | x << 8) & 0x0300F00Fu;
  x = (x | x << 4) & 0x030C30C3u;
  return (x | x << 2) & 0x09249249u;
}

/// The triangles in the order of the Z curve through their middles: files have them face by face, and those
/// of a large face in no order.
std::vector<std::uint32_t> alongZCurve(const TriMesh& mesh) {
  constexpr double kCells = 1023.0;
  const Box3 box = meshBounds(mesh);
  const Vec3 scale = kCells * box.size().cwiseMax(1e-9).cwiseInverse();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys(mesh.triangles.size());
  for (std::uint32_t t = 0; t < keys.size(); ++t) {
    const Corners c = cornersOf(mesh, t);
    const Vec3 cell = ((c[0] + c[1] + c[2]) / 3.0 - box.min).cwiseProduct(scale);
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread(static_cast<std::uint32_t>(std::clamp(cell[axis], 0.0, kCells))) << axis;
    keys[t] = {key, t};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, t] : keys) order.push_back(t);
  return order;
}

}  // namespace

SelfCrossing findSelfCrossing(const Shells& shells) {
  PROVEOUT_ASSERT(shells.shell_of.size() == shells.mesh.triangles.size());
  SelfCrossing out;
  for (const auto& [s, t] : findIntersectionsAmong(shells.mesh, alongZCurve(shells.mesh))) {
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
