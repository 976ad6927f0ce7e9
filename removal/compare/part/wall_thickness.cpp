// The least wall: the shortest way through the material along the normal of a face to one that looks the
// other way.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel_for.h"
#include "core/geometry/box_tree.h"
#include "core/mesh/signed_distance.h"
#include "removal/compare/deepest_point.h"
#include "removal/compare/part/part_probe.h"

namespace proveout {
namespace {

/// Faces whose normals are less than this cosine to each other are two sides of a wall: within 45 degrees of
/// opposite.
constexpr double kFacing = -0.70710678;
constexpr std::size_t kMostSamples = 200'000;
constexpr std::size_t kRefined = 24;
constexpr double kLastStep = 1e-4;  ///< mm

struct Sample {
  Vec3 p, normal;
};

std::vector<Sample> samplesOf(const SurfaceMesh& mesh, double spacing, const PartRule& rule) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += 0.5 * mesh.areaVector(t).norm();
  spacing = std::max(spacing, std::sqrt(area / static_cast<double>(kMostSamples)));
  std::vector<Sample> out;
  // Each triangle in rows of smaller ones; of those that are smaller than the spacing every so many.
  double due = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 twice = mesh.areaVector(t);
    due += 0.5 * twice.norm() / (spacing * spacing);
    if (due < 1.0 || twice.norm() == 0.0) continue;
    const int rows = std::min(static_cast<int>(std::ceil(std::sqrt(due))), 2000);
    due = 0.0;
    const Vec3 &a = mesh.points[mesh.triangles[t][0]], &b = mesh.points[mesh.triangles[t][1]],
               &c = mesh.points[mesh.triangles[t][2]];
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j + i < rows; ++j) {
        const double u = (i + 1.0 / 3.0) / rows, v = (j + 1.0 / 3.0) / rows;
        const Vec3 p = a + u * (b - a) + v * (c - a);
        if (isIn(rule, p)) out.push_back({p, twice.normalized()});
      }
    }
  }
  return out;
}

/// Rays through the triangles of a mesh.
class Rays {
 public:
  explicit Rays(const SurfaceMesh& mesh) : mesh_(mesh), tree_(boxesOf(mesh)) {}

  /// How long the material is along the inward normal, where the face on its other side looks the other way;
  /// else infinite.
  double wallAt(const Sample& at) const {
    const Vec3 way = -at.normal, inverse = way.cwiseInverse();
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t met = 0;
    tree_.forEachPlaceWhere(
        [&](const BoxTree::Node& node, int side) { return entry(node, side, at.p, inverse) < best; },
        [&](std::uint32_t place) {
          const std::uint32_t t = tree_.order()[place];
          const double u = crossing(t, at.p, way);
          if (u < best) best = u, met = t;
        });
    if (!std::isfinite(best)) return best;
    const bool facing = mesh_.areaVector(met).normalized().dot(at.normal) < kFacing;
    return facing ? best : std::numeric_limits<double>::infinity();
  }

 private:
  static std::vector<ShortBox> boxesOf(const SurfaceMesh& mesh) {
    std::vector<ShortBox> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      Box3 box;
      for (const std::uint32_t v : t) box.extend(mesh.points[v]);
      boxes.push_back(ShortBox::around(box));
    }
    return boxes;
  }
  /// Where the ray enters a child's bounds; infinite where it does not.
  static double entry(const BoxTree::Node& node, int side, const Vec3& p, const Vec3& inverse) {
    double from = 0.0, to = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double low = static_cast<double>(node.low[side][k]) - p[k],
                   high = static_cast<double>(node.high[side][k]) - p[k];
      if (!std::isfinite(inverse[k])) {
        if (low > 0.0 || high < 0.0) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double a = low * inverse[k], b = high * inverse[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  }
  /// Where the ray leaves the material through a triangle (T. Moeller, B. Trumbore, "Fast, minimum storage
  /// ray-triangle intersection", 1997), not where it starts; infinite where it does not.
  double crossing(std::uint32_t t, const Vec3& p, const Vec3& way) const {
    constexpr double kMissed = std::numeric_limits<double>::infinity(), kStart = 1e-5;
    const auto& v = mesh_.triangles[t];
    const Vec3 &a = mesh_.points[v[0]], ab = mesh_.points[v[1]] - a, ac = mesh_.points[v[2]] - a;
    const Vec3 across = way.cross(ac);
    const double det = ab.dot(across);
    if (!(det < 0.0)) return kMissed;  // seen from its back
    const Vec3 from = p - a;
    const double x = from.dot(across) / det;
    const Vec3 other = from.cross(ab);
    const double y = way.dot(other) / det;
    constexpr double kEdge = 1e-9;  // what runs into an edge is of both triangles
    if (x < -kEdge || y < -kEdge || x + y > 1.0 + kEdge) return kMissed;
    const double u = ac.dot(other) / det;
    return u > kStart ? u : kMissed;
  }

  const SurfaceMesh& mesh_;
  BoxTree tree_;
};

/// A wall: from a point along the inward normal to the other side.
struct Wall {
  SurfacePoint from;
  double thickness = std::numeric_limits<double>::infinity();
};

/// The wall behind a point of the surface, `about` so thick, by steps as long as the way to the surface is at
/// least.
Wall wallBehind(const ExactPart& part, const SurfacePoint& from, double about) {
  Wall wall{from};
  const double end = 2.0 * about + 0.1;
  double t = 0.5 * about;
  if (part.at(from.p - t * from.normal, end).value >= 0.0) t = std::min(1e-3, 0.1 * about);
  for (int round = 0; round < 400 && t < end; ++round) {
    const Vec3 at = from.p - t * from.normal;
    const ExactPart::Sample s = part.at(at, end);
    if (s.value > -1e-8) {
      if (s.normal.dot(from.normal) < kFacing) wall.thickness = t;
      return wall;
    }
    t -= s.value;
  }
  return wall;
}

/// From a sample to the thinnest place around it.
Wall thinnest(const ExactPart& part, const Sample& start, double about, double step, const PartRule& rule) {
  const double reach = std::max(4.0 * step, 0.05);
  const auto measure = [&](const Vec3& p) {
    const std::optional<SurfacePoint> on = surfaceNear(part, p, reach);
    return on && isIn(rule, on->p) ? wallBehind(part, *on, about) : Wall();
  };
  Wall best = measure(start.p);
  constexpr int kDirections = 6;
  for (int moves = 0; step > kLastStep && moves < 200;) {
    const Vec3 u = best.from.normal.unitOrthogonal(), v = best.from.normal.cross(u);
    Wall next = best;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * kPi * i / kDirections;
      const Wall tried = measure(best.from.p + step * (std::cos(angle) * u + std::sin(angle) * v));
      if (tried.thickness < next.thickness) next = tried;
    }
    if (next.thickness < best.thickness - 1e-9) {
      best = next;
      ++moves;
    } else {
      step *= 0.5;
    }
  }
  return best;
}

}  // namespace

void measureThickness(const MeasuredPart& part, const PartRule& rule, Progress& progress, PartFeature& out) {
  if (part.mesh.triangles.empty()) return;
  progress.report("measuring walls", 0.0);
  const SurfaceMesh mesh = toSurface(part.mesh);
  const std::vector<Sample> samples = samplesOf(mesh, part.spacing_mm, rule);
  std::vector<double> thickness(samples.size(), std::numeric_limits<double>::infinity());
  {
    const Rays rays(mesh);
    parallelFor(std::size_t{0}, samples.size(), [&](std::size_t k) {
      if (!progress.cancelled()) thickness[k] = rays.wallAt(samples[k]);
    });
  }
  if (progress.cancelled()) return;
  std::vector<std::size_t> order(samples.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::erase_if(order, [&](std::size_t k) { return !std::isfinite(thickness[k]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return thickness[a] < thickness[b]; });
  std::vector<std::size_t> chosen;
  constexpr double kRoom = 1.25;  // what a sample that is not the thinnest place may have more
  for (const std::size_t k : order) {
    if (thickness[k] > kRoom * thickness[order.front()] + part.spacing_mm) break;
    const auto near = [&](std::size_t c) {
      return (samples[c].p - samples[k].p).norm() < 4.0 * part.spacing_mm;
    };
    if (std::none_of(chosen.begin(), chosen.end(), near)) chosen.push_back(k);
    if (chosen.size() == kRefined) break;
  }
  std::vector<Wall> walls(chosen.size());
  std::optional<SignedDistance> distance;
  std::optional<MeshPart> of_mesh;
  if (part.exact == nullptr)
    of_mesh.emplace(distance.emplace(mesh, 0.5 * part.spacing_mm), part.mesh_error_mm);
  const ExactPart& exact = part.exact != nullptr ? *part.exact : *of_mesh;
  parallelFor(std::size_t{0}, chosen.size(), [&](std::size_t i) {
    walls[i] = thinnest(exact, samples[chosen[i]], thickness[chosen[i]], part.spacing_mm, rule);
  });
  const auto least = std::min_element(walls.begin(), walls.end(),
                                      [](const Wall& a, const Wall& b) { return a.thickness < b.thickness; });
  if (least == walls.end() || !std::isfinite(least->thickness)) return;
  out.measured = least->thickness;
  out.where = least->from.p - 0.5 * least->thickness * least->from.normal;
  out.maker = least->from.maker;
}

}  // namespace proveout
