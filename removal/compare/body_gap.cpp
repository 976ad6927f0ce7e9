#include "removal/compare/body_gap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/assert.h"
#include "core/geometry/polygon.h"

namespace proveout {
namespace {

/// Cosine of the largest angle between facets that face each other.
constexpr double kFacing = 0.9;
/// Less of their area in front of each other is none, mm2.
constexpr double kLeastAreaMm2 = 1e-9;

using Polygon = std::vector<Vec2>;

/// The part of a convex polygon on the left of the line through a and b.
Polygon leftOf(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  Polygon out;
  const auto side = [&](const Vec2& p) { return cross2(b - a, p - a); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double of_p = side(p), of_q = side(q);
    if (of_p >= 0.0) out.push_back(p);
    if (of_p * of_q < 0.0) out.push_back(p + of_p / (of_p - of_q) * (q - p));
  }
  return out;
}

/// A facet in its own plane.
struct Facet {
  Facet(const SurfaceMesh& mesh, std::uint32_t t) {
    for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.points[mesh.triangles[t][c]];
    const Vec3 twice = mesh.areaVector(t);
    area = 0.5 * twice.norm();
    if (!(area > 0.0)) return;
    normal = twice.normalized();
    u = normal.unitOrthogonal();
    v = normal.cross(u);
  }
  Vec2 flat(const Vec3& p) const { return {u.dot(p - corners[0]), v.dot(p - corners[0])}; }
  Box3 box() const {
    Box3 out;
    for (const Vec3& p : corners) out.extend(p);
    return out;
  }
  std::array<Vec3, 3> corners;
  Vec3 normal = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
  double area = 0.0;
};

/// The largest distance, along the normal of `t`, of the part of `s` in front of it, and where; none where
/// none of it is in front, within `reach`.
std::optional<std::pair<double, Vec3>> facetGap(const Facet& t, const Facet& s, double reach) {
  if (t.normal.dot(s.normal) > -kFacing) return std::nullopt;
  Polygon part;
  for (const Vec3& p : s.corners) part.push_back(t.flat(p));
  if (polygonArea(part) < 0.0) std::reverse(part.begin(), part.end());
  for (std::size_t c = 0; c < 3 && !part.empty(); ++c)
    part = leftOf(part, t.flat(t.corners[c]), t.flat(t.corners[(c + 1) % 3]));
  if (part.size() < 3 || polygonArea(part) < kLeastAreaMm2) return std::nullopt;
  std::optional<std::pair<double, Vec3>> widest;
  for (const Vec2& p : part) {
    const Vec3 foot = t.corners[0] + p.x() * t.u + p.y() * t.v;
    const double distance = s.normal.dot(s.corners[0] - foot) / s.normal.dot(t.normal);
    if (distance < 0.0 || distance > reach) return std::nullopt;
    if (!widest || distance > widest->first) widest = {distance, foot + 0.5 * distance * t.normal};
  }
  return widest;
}

}  // namespace

std::optional<BodyGap> findGap(const SurfaceMesh& body, const TriangleTree& body_tree,
                               const SurfaceMesh& other, const TriangleTree& other_tree, double reach) {
  Box3 near;
  for (const Vec3& p : other.points) near.extend(p);
  BodyGap out;
  body_tree.forEachIn(near.inflated(reach), [&](std::uint32_t t) {
    const Facet facet(body, t);
    if (!(facet.area > 0.0)) return;
    bool faces = false;
    other_tree.forEachIn(facet.box().inflated(reach), [&](std::uint32_t s) {
      const auto gap = facetGap(facet, Facet(other, s), reach);
      if (!gap) return;
      if (!faces) {
        faces = true;
        out.facets.push_back(t);
        out.area_mm2 += facet.area;
      }
      if (gap->first < out.width_mm) return;
      out.width_mm = gap->first;
      out.where = gap->second;
    });
  });
  if (out.facets.empty()) return std::nullopt;
  PROVEOUT_ASSERT(out.area_mm2 > 0.0 && out.width_mm >= 0.0);
  std::sort(out.facets.begin(), out.facets.end());
  return out;
}

TriMesh withFacetsMoved(const TriMesh& mesh, const std::vector<std::uint32_t>& facets, double by_mm) {
  constexpr double kLeastCosine = 0.3;  // at sharper corners facets move by less
  const SurfaceMesh surface = toSurface(mesh);
  std::map<std::uint32_t, Vec3> sums;
  for (const std::uint32_t t : facets) {
    PROVEOUT_ASSERT(t < surface.triangles.size());
    for (const std::uint32_t v : surface.triangles[t])
      sums.try_emplace(v, Vec3::Zero()).first->second += surface.areaVector(t).normalized();
  }
  std::map<std::uint32_t, double> cosine;
  for (const std::uint32_t t : facets) {
    const Vec3 normal = surface.areaVector(t).normalized();
    for (const std::uint32_t v : surface.triangles[t]) {
      double& least = cosine.try_emplace(v, 1.0).first->second;
      least = std::min(least, sums[v].normalized().dot(normal));
    }
  }
  TriMesh out = mesh;
  for (const auto& [v, sum] : sums) {
    if (!(sum.norm() > 0.0)) continue;
    const double by = by_mm / std::max(cosine[v], kLeastCosine);
    out.positions[v] = (surface.points[v] + by * sum.normalized()).cast<float>();
  }
  return out;
}

}  // namespace proveout
