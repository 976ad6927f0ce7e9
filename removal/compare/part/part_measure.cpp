#include "removal/compare/part/part_measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel_for.h"
#include "core/mesh/edge_table.h"
#include "removal/compare/part/part_probe.h"

namespace proveout {
namespace {

Vec3 cornerOf(const TriMesh& mesh, std::size_t t, std::size_t k) {
  return mesh.positions[mesh.triangles[t][k]].cast<double>();
}

Vec3 areaVectorOf(const TriMesh& mesh, std::size_t t) {
  const Vec3 a = cornerOf(mesh, t, 0);
  return 0.5 * (cornerOf(mesh, t, 1) - a).cross(cornerOf(mesh, t, 2) - a);
}

std::uint32_t motionOf(const TriMesh& mesh, std::size_t t) {
  return mesh.motion.empty() ? kNoMotion : mesh.motion[t];
}

}  // namespace

bool isIn(const PartRule& rule, const Vec3& p) { return !rule.region || rule.region->contains(p); }

std::optional<SurfacePoint> surfaceNear(const ExactPart& part, const Vec3& p, double reach) {
  const SettledPoint settled = settle(part, p, reach);
  if (!settled.found) return std::nullopt;
  const ExactPart::Sample s = part.at(settled.p, reach);
  return SurfacePoint{settled.p, s.normal, settled.maker};
}

std::optional<double> crossingBetween(const ExactPart& part, const Vec3& outside, const Vec3& inside) {
  const double length = (inside - outside).norm();
  const auto valueAt = [&](double u) { return part.at(outside + u * (inside - outside), length).value; };
  double low = 0.0, high = 1.0, at_low = valueAt(0.0), at_high = valueAt(1.0);
  if (at_low < 0.0 || at_high > 0.0) return std::nullopt;
  constexpr double kNear = 1e-7;
  int kept = 0;  // Illinois: an end that stays twice counts half
  for (int round = 0; round < 60 && (high - low) * length > kNear; ++round) {
    double u = at_low > at_high ? low + (high - low) * at_low / (at_low - at_high) : 0.5 * (low + high);
    if (!(u > low && u < high)) u = 0.5 * (low + high);
    const double value = valueAt(u);
    if (std::abs(value) < 0.1 * kNear) return u;
    if (value > 0.0) {
      low = u, at_low = value;
      if (kept == 1) at_high *= 0.5;
      kept = 1;
    } else {
      high = u, at_high = value;
      if (kept == -1) at_low *= 0.5;
      kept = -1;
    }
  }
  return 0.5 * (low + high);
}

std::vector<MeshEdge> turningEdges(const TriMesh& mesh, double least_rad, const PartRule& rule) {
  std::vector<MeshEdge> out;
  const double least_cos = std::cos(least_rad);
  const auto add = [&](const HalfEdge& one, const HalfEdge& other) {
    const std::uint32_t left = one.half_edge / 3, right = other.half_edge / 3, corner = one.half_edge % 3;
    const Vec3 a = cornerOf(mesh, left, corner), b = cornerOf(mesh, left, (corner + 1) % 3);
    const Vec3 n = areaVectorOf(mesh, left).normalized(), m = areaVectorOf(mesh, right).normalized();
    const double cosine = n.dot(m);
    if (!(cosine < least_cos) || !isIn(rule, 0.5 * (a + b))) return;
    MeshEdge edge;
    edge.middle = 0.5 * (a + b);
    edge.along = (b - a).normalized();
    const Vec3 sum = n + m;
    if (!edge.along.allFinite() || sum.norm() < 1e-3) return;
    edge.normal = sum.normalized();
    edge.turn_rad = std::atan2(n.cross(m).dot(edge.along), cosine);
    edge.left_motion = motionOf(mesh, left);
    edge.right_motion = motionOf(mesh, right);
    out.push_back(edge);
  };
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    if (last - first == 2) add(first[0], first[1]);
  });
  return out;
}

bool needsExactPart(Quantity quantity) {
  return quantity == Quantity::kInnerRadius || quantity == Quantity::kScallop ||
         quantity == Quantity::kRoughness;
}

void measureSkin(const MeasuredPart& part, const PartRule& rule, PartFeature& out) {
  const TriMesh& mesh = part.mesh;
  std::vector<double> area(mesh.triangles.size(), 0.0);
  parallelFor(std::size_t{0}, area.size(), [&](std::size_t t) {
    if (motionOf(mesh, t) != kNoMotion) return;
    const Vec3 middle = (cornerOf(mesh, t, 0) + cornerOf(mesh, t, 1) + cornerOf(mesh, t, 2)) / 3.0;
    if (!isIn(rule, middle)) return;
    if (part.exact != nullptr && part.clamped_again) {
      const SettledPoint settled = settle(*part.exact, middle, 4.0 * part.spacing_mm);
      if (settled.found && settled.maker.motion != kNoMotion) return;
    }
    area[t] = areaVectorOf(mesh, t).norm();
  });
  double sum = 0.0, most = 0.0;
  for (std::size_t t = 0; t < area.size(); ++t) {
    sum += area[t];
    if (area[t] <= most) continue;
    most = area[t];
    out.where = (cornerOf(mesh, t, 0) + cornerOf(mesh, t, 1) + cornerOf(mesh, t, 2)) / 3.0;
  }
  out.measured = sum;
}

Result<std::vector<PartFeature>> measurePart(const MeasuredPart& part, const std::vector<PartRule>& rules,
                                             Progress& progress) {
  std::vector<PartFeature> out;
  for (const PartRule& rule : rules) {
    PartFeature feature;
    feature.quantity = rule.quantity;
    feature.measurable = part.exact != nullptr || !needsExactPart(rule.quantity);
    switch (rule.quantity) {
      case Quantity::kThickness:
        measureThickness(part, rule, progress, feature);
        break;
      case Quantity::kInnerRadius:
        measureInnerRadius(part, rule, progress, feature);
        break;
      case Quantity::kSkin:
        measureSkin(part, rule, feature);
        break;
      default:
        measureCrests(part, rule, progress, feature);
    }
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    out.push_back(feature);
  }
  return out;
}

}  // namespace proveout
