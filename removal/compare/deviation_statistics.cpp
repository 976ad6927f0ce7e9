#include "removal/compare/deviation_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/assert.h"

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

/// Samples that are not left out, with the surface that each stands for.
struct Weighted {
  std::vector<float> deviation;  ///< mm
  std::vector<double> area;      ///< mm2
};

Weighted weigh(const SampledSide& side) {
  const std::vector<double> areas = pointAreas(side.mesh->surface);
  Weighted out;
  PROVEOUT_ASSERT(side.deviation.size() == areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (std::isnan(side.deviation[i])) continue;
    out.deviation.push_back(side.deviation[i]);
    out.area.push_back(areas[i]);
  }
  return out;
}

double percentile(const Weighted& samples, double share, double area) {
  std::vector<std::uint32_t> order(samples.deviation.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float da = std::abs(samples.deviation[a]), db = std::abs(samples.deviation[b]);
    return da != db ? da < db : a < b;
  });
  double sum = 0.0;
  for (const auto i : order) {
    sum += samples.area[i];
    if (sum >= share * area) return std::abs(samples.deviation[i]);
  }
  return order.empty() ? 0.0 : std::abs(samples.deviation[order.back()]);
}

DeviationFigures figuresOf(const Weighted& samples) {
  DeviationFigures out;
  double squares = 0.0;
  for (std::size_t i = 0; i < samples.deviation.size(); ++i) {
    squares += samples.area[i] * samples.deviation[i] * samples.deviation[i];
    out.area_mm2 += samples.area[i];
  }
  out.rms_mm = out.area_mm2 > 0.0 ? std::sqrt(squares / out.area_mm2) : 0.0;
  out.p95_mm = percentile(samples, 0.95, out.area_mm2);
  return out;
}

/// Twenty-four bins over four times the larger tolerance to both sides: what passes is seen in detail.
void fillHistogram(const Weighted& machined, const Weighted& nominal, Comparison& out) {
  constexpr int kBins = 24;
  const double largest = std::max(out.max_gouge_mm, out.max_excess_mm);
  const double tolerance = std::max(out.gouge_tolerance_mm, out.excess_tolerance_mm);
  const double reach = tolerance > 0.0 ? 4.0 * tolerance : std::max(largest, 1e-6);
  auto& h = out.histogram;
  h.area_mm2.assign(kBins, 0.0);
  for (int i = 0; i <= kBins; ++i) h.edges_mm.push_back(reach * (2.0 * i / kBins - 1.0));
  PROVEOUT_ASSERT(h.edges_mm.size() == h.area_mm2.size() + 1);
  for (const Weighted* side : {&machined, &nominal}) {
    for (std::size_t i = 0; i < side->deviation.size(); ++i) {
      const double bin = std::floor((side->deviation[i] / reach + 1.0) * 0.5 * kBins);
      h.area_mm2[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))] += 0.5 * side->area[i];
    }
  }
}

}  // namespace statistics_detail

void fillStatistics(const BothSides& sides, Comparison& out) {
  for (const SampledSide* side : {&sides.machined, &sides.nominal}) {
    for (const double d : side->deviation) {
      if (std::isnan(d)) continue;
      out.max_gouge_mm = std::max(out.max_gouge_mm, -d);
      out.max_excess_mm = std::max(out.max_excess_mm, d);
    }
  }
  const statistics_detail::Weighted machined = statistics_detail::weigh(sides.machined),
                                    nominal = statistics_detail::weigh(sides.nominal);
  out.machined = statistics_detail::figuresOf(machined);
  out.nominal = statistics_detail::figuresOf(nominal);
  out.rms_mm = std::max(out.machined.rms_mm, out.nominal.rms_mm);
  out.p95_mm = std::max(out.machined.p95_mm, out.nominal.p95_mm);
  PROVEOUT_ASSERT(out.p95_mm <= std::max(out.max_gouge_mm, out.max_excess_mm));
  statistics_detail::fillHistogram(machined, nominal, out);
}

}  // namespace proveout
