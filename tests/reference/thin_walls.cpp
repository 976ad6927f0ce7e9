#include "tests/reference/thin_walls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout::reference {

namespace {

/// Samples of the surface are this far from each other, of what is thin.
constexpr double kSpacing = 0.25;
/// Cosine of the least angle between the sides of a wall: others are edges.
constexpr double kOpposite = -0.5;
/// From here on the material behind a sample is looked at, mm.
constexpr double kSkin = 1e-5;

SurfaceMesh toSurface(const std::vector<ReferencePart::Facet>& facets) {
  SurfaceMesh out;
  for (const auto& facet : facets) {
    const auto first = static_cast<std::uint32_t>(out.points.size());
    out.points.insert(out.points.end(), facet.corners.begin(), facet.corners.end());
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// Points of a triangle in rows along its longest edge.
std::vector<Vec3> samplesOf(const std::array<Vec3, 3>& corners, double spacing) {
  const auto length = [&](std::size_t k) { return (corners[(k + 1) % 3] - corners[k]).norm(); };
  std::size_t k = 0;
  for (const std::size_t other : {1, 2}) {
    if (length(other) > length(k)) k = other;
  }
  const Vec3 &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
  const auto parts = [&](double way) { return std::max(1, static_cast<int>(std::ceil(way / spacing))); };
  const double height = (b - a).cross(c - a).norm() / std::max(length(k), kSkin);
  std::vector<Vec3> out;
  const int rows = parts(height);
  for (int row = 0; row < rows; ++row) {
    const double up = (row + 0.5) / rows;
    const Vec3 from = a + up * (c - a), to = b + up * (c - b);
    const int n = parts((to - from).norm());
    for (int i = 0; i < n; ++i) out.push_back(from + (i + 0.5) / n * (to - from));
  }
  return out;
}

/// Where a ray from `p` meets a triangle, or nothing.
std::optional<double> meets(const Vec3& p, const Vec3& way, const std::array<Vec3, 3>& corners) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0], across = way.cross(v);
  const double size = u.dot(across);
  if (size == 0.0) return std::nullopt;
  const Vec3 from = p - corners[0], other = from.cross(u);
  const double s = from.dot(across) / size, t = way.dot(other) / size;
  if (s < 0.0 || t < 0.0 || s + t > 1.0) return std::nullopt;
  return v.dot(other) / size;
}

}  // namespace

ThinWalls::ThinWalls(std::vector<ReferencePart::Facet> facets, double thin)
    : facets_(std::move(facets)), tree_(toSurface(facets_)), thin_(thin), places_(facets_.size()) {}

bool ThinWalls::endsBehind(const Vec3& p, const Vec3& way, const Vec3& normal) const {
  const Vec3 from = p + kSkin * way, to = p + thin_ * way;
  double nearest = thin_ - kSkin;
  bool thin = false;
  tree_.forEachIn({from.cwiseMin(to), from.cwiseMax(to)}, [&](std::uint32_t i) {
    const auto at = meets(from, way, facets_[i].corners);
    if (!at || *at < 0.0 || *at >= nearest) return;
    nearest = *at;
    thin = facets_[i].normal.dot(normal) < kOpposite;
  });
  return thin;
}

const std::vector<Vec3>& ThinWalls::placesOf(std::size_t facet) {
  auto& places = places_[facet];
  if (!places) {
    places.emplace();
    for (const Vec3& p : samplesOf(facets_[facet].corners, kSpacing * thin_)) {
      const Vec3& n = facets_[facet].normal;
      if (endsBehind(p, -n, n) || endsBehind(p, n, n)) places->push_back(p);
    }
  }
  return *places;
}

bool ThinWalls::isNear(const Vec3& p, double within) {
  bool found = false;
  const Vec3 reach = Vec3::Constant(within);
  tree_.forEachIn({p - reach, p + reach}, [&](std::uint32_t i) {
    if (found) return;
    const auto& places = placesOf(i);
    found = std::any_of(places.begin(), places.end(), [&](const Vec3& q) { return (q - p).norm() < within; });
  });
  return found;
}

}  // namespace proveout::reference
