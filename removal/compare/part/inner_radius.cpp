// The smallest radius of inner corners, across their edges.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel_for.h"
#include "removal/compare/part/part_probe.h"

namespace proveout {
namespace {

constexpr std::size_t kMostCorners = 30'000;
/// Edges that turn less are of facets that stand for something flat or for a radius of no interest.
constexpr double kLeastCorner = 0.5 * kPi / 180.0;
/// A corner whose radius shrinks with the steps down to this one is sharp, mm.
constexpr double kSharp = 2e-3;

struct Corner {
  double radius = std::numeric_limits<double>::infinity();
  SurfacePoint at;
};

/// By how the normals turn towards each other along the way: of a circle its radius, of a surface that of a
/// section along the normal. Infinite where it is not hollow.
double radiusOf(const SurfacePoint& a, const SurfacePoint& b) {
  const Vec3 way = b.p - a.p;
  const double turn = way.dot(a.normal - b.normal);
  return turn > 1e-6 * way.norm() ? way.squaredNorm() / turn : std::numeric_limits<double>::infinity();
}

/// By ever shorter steps to both sides of the edge, until the radius is no longer that of the steps.
Corner cornerAt(const ExactPart& part, const MeshEdge& edge, double step) {
  Corner out;
  Vec3 middle = edge.middle, normal = edge.normal;
  const double first = step;
  double before = std::numeric_limits<double>::infinity();
  for (; step > 1e-4; step *= 0.5) {
    const Vec3 side = normal.cross(edge.along).normalized();
    const std::optional<SurfacePoint> a = surfaceNear(part, middle - step * side, 3.0 * first);
    const std::optional<SurfacePoint> b = surfaceNear(part, middle + step * side, 3.0 * first);
    if (!a || !b || (b->p - a->p).norm() < 0.1 * step) return out;
    const double radius = radiusOf(*a, *b);
    if (!std::isfinite(radius)) return out;
    const Vec3 sum = a->normal + b->normal;
    out.at = *a;
    out.at.p = 0.5 * (a->p + b->p);
    if (std::abs(radius - before) < 0.005 * radius) {
      out.radius = std::min(radius, before);
      return out;
    }
    before = radius;
    if (sum.norm() > 1e-6) normal = sum.normalized();
    // Into the corner: the nearest point of the surface would be one of its walls.
    const Vec3 inside = out.at.p - 2.0 * step * normal;
    const std::optional<double> share = crossingBetween(part, out.at.p, inside);
    if (share) middle = out.at.p + *share * (inside - out.at.p);
  }
  out.radius = before < kSharp ? 0.0 : before;
  return out;
}

}  // namespace

void measureInnerRadius(const MeasuredPart& part, const PartRule& rule, Progress& progress,
                        PartFeature& out) {
  if (part.exact == nullptr) return;
  progress.report("measuring corners", 0.0);
  std::vector<MeshEdge> edges = turningEdges(part.mesh, kLeastCorner, rule);
  std::erase_if(edges, [](const MeshEdge& edge) { return edge.turn_rad > 0.0; });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const MeshEdge& a, const MeshEdge& b) { return a.turn_rad < b.turn_rad; });
  // The sharpest, and of the others as many as there is time for.
  if (edges.size() > kMostCorners) {
    const std::size_t each = edges.size() / (kMostCorners / 2) + 1;
    std::vector<MeshEdge> fewer(edges.begin(), edges.begin() + kMostCorners / 2);
    for (std::size_t k = kMostCorners / 2; k < edges.size(); k += each) fewer.push_back(edges[k]);
    edges = std::move(fewer);
  }
  Corner least;
  constexpr std::size_t kAtOnce = 1024;
  for (std::size_t first = 0; first < edges.size() && least.radius > 0.0; first += kAtOnce) {
    if (progress.cancelled()) return;
    std::vector<Corner> corners(std::min(kAtOnce, edges.size() - first));
    parallelFor(std::size_t{0}, corners.size(), [&](std::size_t k) {
      corners[k] = cornerAt(*part.exact, edges[first + k], part.spacing_mm);
    });
    for (const Corner& corner : corners)
      if (corner.radius < least.radius) least = corner;
  }
  if (!std::isfinite(least.radius)) return;
  out.measured = least.radius;
  out.where = least.at.p;
  out.maker = least.at.maker;
}

}  // namespace proveout
