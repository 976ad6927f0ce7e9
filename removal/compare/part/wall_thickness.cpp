// The least wall: the smallest ball within the part that touches two faces that look away from each other.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel_for.h"
#include "core/mesh/signed_distance.h"
#include "removal/compare/deepest_point.h"
#include "removal/compare/part/part_probe.h"

namespace proveout {
namespace {

/// Faces whose normals are less than this cosine to each other are two sides of a wall: within 45 degrees of
/// opposite.
constexpr double kFacing = -0.70710678;
constexpr std::size_t kMostSamples = 200'000;
constexpr std::size_t kRefined = 48;
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

/// Diameter of the ball within that touches at the sample, where it is below `most` and the other side faces
/// it (shrinking ball: J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation using nearest neighbors
/// and the normal field", 2012). Infinite where it is not.
double ballAt(const SignedDistance& surface, const Sample& at, double most) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr int kRounds = 30;
  double radius = 0.5 * most;
  bool met = false;
  Vec3 other = Vec3::Zero();
  for (int round = 0; round < kRounds; ++round) {
    const Vec3 c = at.p - radius * at.normal;
    const SurfaceDistance d = surface.at(c);
    if (std::abs(d.distance) > radius * (1.0 - 1e-6) - 1e-9) break;
    const Vec3 q = c - d.distance * d.gradient.cast<double>();
    const Vec3 way = at.p - q;
    const double along = at.normal.dot(way);
    if (!(along > 0.0)) return kNone;
    const double next = way.squaredNorm() / (2.0 * along);
    other = surface.mesh().areaVector(d.triangle).normalized();
    met = true;
    if (next > radius * (1.0 - 1e-6)) break;
    radius = next;
  }
  return met && other.dot(at.normal) < kFacing ? 2.0 * radius : kNone;
}

/// A wall: from a point along the inward normal to the other side.
struct Wall {
  SurfacePoint from;
  double thickness = std::numeric_limits<double>::infinity();
};

/// The wall behind a point of the surface, by steps as long as the way to the surface is at least.
Wall wallBehind(const ExactPart& part, const SurfacePoint& from, double about) {
  Wall wall{from};
  const double end = 2.0 * about + 0.1;
  double t = std::min(1e-3, 0.25 * about);
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
  const SignedDistance surface(mesh, 0.5 * part.spacing_mm);
  const std::vector<Sample> samples = samplesOf(mesh, part.spacing_mm, rule);
  std::vector<double> thickness(samples.size(), std::numeric_limits<double>::infinity());
  const auto measure = [&](std::size_t first, std::size_t step, double most) {
    const std::size_t count = samples.size() > first ? (samples.size() - first + step - 1) / step : 0;
    parallelFor(std::size_t{0}, count, [&](std::size_t k) {
      if (progress.cancelled()) return;
      double& t = thickness[first + k * step];
      t = ballAt(surface, samples[first + k * step], most);
    });
    return thickness.empty() ? most : std::min(most, *std::min_element(thickness.begin(), thickness.end()));
  };
  // A few tell how thick a wall is of interest at all; the others then mostly take one question.
  const Vec3 size = meshExtent(part.mesh).bounds.size();
  constexpr std::size_t kFew = 64;
  const double whole = 1.01 * size.minCoeff();
  const double first = measure(0, kFew, whole);
  constexpr double kRoom = 1.25;  // what a sample that is not the thinnest place may have more
  measure(0, 1, std::min(kRoom * first, whole));
  if (progress.cancelled()) return;
  std::vector<std::size_t> order(samples.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::erase_if(order, [&](std::size_t k) { return !std::isfinite(thickness[k]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return thickness[a] < thickness[b]; });
  std::vector<std::size_t> chosen;
  for (const std::size_t k : order) {
    const auto near = [&](std::size_t c) {
      return (samples[c].p - samples[k].p).norm() < 4.0 * part.spacing_mm;
    };
    if (std::none_of(chosen.begin(), chosen.end(), near)) chosen.push_back(k);
    if (chosen.size() == kRefined) break;
  }
  std::vector<Wall> walls(chosen.size());
  const MeshPart of_mesh(surface, part.mesh_error_mm);
  const ExactPart& exact = part.exact != nullptr ? *part.exact : of_mesh;
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
