#include "removal/deviation_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/edge_table.h"

namespace proveout {
namespace statistics_detail {

/// A third of the area of the triangles around each sample point, mm2.
std::vector<double> pointAreas(const SurfaceMesh& mesh) {
  std::vector<double> area(mesh.points.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    const auto& p = mesh.points;
    const double third = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() / 6.0;
    for (const auto v : t) area[v] += third;
  }
  return area;
}

double percentile(const std::vector<float>& deviation, const std::vector<double>& weight, double share) {
  std::vector<std::uint32_t> order(deviation.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float da = std::abs(deviation[a]), db = std::abs(deviation[b]);
    return da != db ? da < db : a < b;
  });
  const double goal = share * std::accumulate(weight.begin(), weight.end(), 0.0);
  double sum = 0.0;
  for (const auto i : order) {
    sum += weight[i];
    if (sum >= goal) return std::abs(deviation[i]);
  }
  return order.empty() ? 0.0 : std::abs(deviation[order.back()]);
}

/// Twenty-four bins over four times the larger tolerance to both sides: what passes is seen in detail.
void fillHistogram(const std::vector<float>& deviation, const std::vector<double>& weight, Comparison& out) {
  constexpr int kBins = 24;
  const double largest = std::max(out.max_gouge_mm, out.max_excess_mm);
  const double tolerance = std::max(out.gouge_tolerance_mm, out.excess_tolerance_mm);
  const double reach = tolerance > 0.0 ? 4.0 * tolerance : std::max(largest, 1e-6);
  auto& h = out.histogram;
  h.area_mm2.assign(kBins, 0.0);
  for (int i = 0; i <= kBins; ++i) h.edges_mm.push_back(reach * (2.0 * i / kBins - 1.0));
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    const double bin = std::floor((deviation[i] / reach + 1.0) * 0.5 * kBins);
    h.area_mm2[static_cast<int>(std::clamp(bin, 0.0, kBins - 1.0))] += weight[i];
  }
}

}  // namespace statistics_detail

void fillStatistics(const BothSides& sides, Comparison& out) {
  for (const SampledSide* side : {&sides.machined, &sides.nominal}) {
    for (const double d : side->deviation) {
      out.max_gouge_mm = std::max(out.max_gouge_mm, -d);
      out.max_excess_mm = std::max(out.max_excess_mm, d);
    }
  }
  const std::vector<float>& deviation = sides.machined.deviation;
  const std::vector<double> weight = statistics_detail::pointAreas(sides.machined.mesh->surface);
  double squares = 0.0, area = 0.0;
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    squares += weight[i] * deviation[i] * deviation[i];
    area += weight[i];
  }
  out.rms_mm = area > 0.0 ? std::sqrt(squares / area) : 0.0;
  out.p95_mm = statistics_detail::percentile(deviation, weight, 0.95);
  statistics_detail::fillHistogram(deviation, weight, out);
}

double estimateTessellation(const TriMesh& mesh) {
  constexpr double kSmooth =
      degToRad(20);  // facets of one curved face meet under less; a real edge under more
  const auto corner = [&](std::uint32_t v) -> Vec3 { return mesh.positions[v].cast<double>(); };
  double worst = 0.0;
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    if (last - first != 2) return;
    const double length = (corner(low) - corner(first->other)).norm();
    Vec3 normal[2];
    double width = 0.0;
    for (int i = 0; i < 2; ++i) {
      const auto& t = mesh.triangles[first[i].half_edge / 3];
      normal[i] = (corner(t[1]) - corner(t[0])).cross(corner(t[2]) - corner(t[0]));
      width = std::max(width, normal[i].norm() / length);
    }
    const double angle = std::atan2(normal[0].cross(normal[1]).norm(), normal[0].dot(normal[1]));
    // A chord of a circle that turns by `angle` from facet to facet stands off by width * tan(angle / 4) / 2.
    if (angle < kSmooth) worst = std::max(worst, 0.5 * width * std::tan(0.25 * angle));
  });
  return worst;
}

}  // namespace proveout
