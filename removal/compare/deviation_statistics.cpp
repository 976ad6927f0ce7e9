#include "removal/compare/deviation_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout {
namespace statistics_detail {

/// The triangles of a side. At the border of what is left out the corners that are not stand for a third
/// each.
DeviationPieces piecesOf(const SampledSide& side) {
  const SurfaceMesh& mesh = side.mesh->surface;
  PROVEOUT_ASSERT(side.deviation.size() == mesh.points.size());
  DeviationPieces out;
  out.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const std::array<float, 3> at{side.deviation[v[0]], side.deviation[v[1]], side.deviation[v[2]]};
    const double area = 0.5 * mesh.areaVector(t).norm();
    if (std::none_of(at.begin(), at.end(), [](float d) { return std::isnan(d); })) {
      out.push_back({area, at});
      continue;
    }
    for (const float d : at) {
      if (!std::isnan(d)) out.push_back({area / 3.0, {d, d, d}});
    }
  }
  return out;
}

/// Share of a triangle where a linear function, with `f` at the corners in ascending order, is below `level`;
/// `f` are not all the same.
double shareBelow(const std::array<double, 3>& f, double level) {
  if (level <= f[0]) return 0.0;
  if (level >= f[2]) return 1.0;
  if (level < f[1]) return (level - f[0]) / (f[1] - f[0]) * ((level - f[0]) / (f[2] - f[0]));
  return 1.0 - (f[2] - level) / (f[2] - f[0]) * ((f[2] - level) / (f[2] - f[1]));
}

std::array<double, 3> sorted(const std::array<float, 3>& at) {
  std::array<double, 3> f{at[0], at[1], at[2]};
  std::sort(f.begin(), f.end());
  return f;
}

/// Area where the deviation is no larger than `level`.
double areaWithin(const DeviationPiece& piece, double level) {
  const std::array<double, 3> f = sorted(piece.at);
  if (f[0] == f[2]) return std::abs(f[0]) <= level ? piece.area_mm2 : 0.0;
  return piece.area_mm2 * (shareBelow(f, level) - shareBelow(f, -level));
}

/// Largest and smallest absolute deviation of a piece.
double mostOf(const DeviationPiece& p) {
  return std::max({std::abs(p.at[0]), std::abs(p.at[1]), std::abs(p.at[2])});
}
double leastOf(const DeviationPiece& p) {
  const auto [low, high] = std::minmax({p.at[0], p.at[1], p.at[2]});
  return low <= 0.0f && high >= 0.0f ? 0.0 : std::min(std::abs(low), std::abs(high));
}

/// The absolute deviation that `share` of the area keeps: by halving, with the pieces left that could tell.
double percentile(const DeviationPieces& pieces, double share, double area) {
  constexpr double kExact = 1e-9;  // mm
  constexpr int kMostSteps = 80;
  std::vector<std::uint32_t> open(pieces.size());
  std::iota(open.begin(), open.end(), 0u);
  double low = 0.0, high = 0.0, within = 0.0;
  for (const DeviationPiece& p : pieces) high = std::max(high, mostOf(p));
  for (int step = 0; step < kMostSteps && high - low > kExact; ++step) {
    const double level = 0.5 * (low + high);
    double sum = within;
    for (const std::uint32_t i : open) sum += areaWithin(pieces[i], level);
    (sum >= share * area ? high : low) = level;
    std::erase_if(open, [&](std::uint32_t i) {
      const bool below = mostOf(pieces[i]) <= low;
      if (below) within += pieces[i].area_mm2;
      return below || leastOf(pieces[i]) > high;
    });
  }
  return high;
}

}  // namespace statistics_detail

DeviationFigures figuresOf(const DeviationPieces& pieces) {
  DeviationFigures out;
  double squares = 0.0;
  for (const DeviationPiece& p : pieces) {
    const double a = p.at[0], b = p.at[1], c = p.at[2];
    squares += p.area_mm2 * (a * a + b * b + c * c + a * b + b * c + c * a) / 6.0;
    out.area_mm2 += p.area_mm2;
  }
  out.rms_mm = out.area_mm2 > 0.0 ? std::sqrt(squares / out.area_mm2) : 0.0;
  out.p95_mm = statistics_detail::percentile(pieces, 0.95, out.area_mm2);
  return out;
}

void addToHistogram(const DeviationPieces& pieces, double share, Comparison& comparison) {
  constexpr int kBins = 24;
  auto& h = comparison.histogram;
  if (h.edges_mm.empty()) {
    const double largest = std::max(comparison.max_gouge_mm, comparison.max_excess_mm);
    const double tolerance = std::max(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm);
    const double reach = tolerance > 0.0 ? 4.0 * tolerance : std::max(largest, 1e-6);
    h.area_mm2.assign(kBins, 0.0);
    for (int i = 0; i <= kBins; ++i) h.edges_mm.push_back(reach * (2.0 * i / kBins - 1.0));
  }
  PROVEOUT_ASSERT(h.edges_mm.size() == h.area_mm2.size() + 1);
  const double reach = h.edges_mm.back();
  const auto binOf = [&](double deviation) {
    const double bin = std::floor((deviation / reach + 1.0) * 0.5 * kBins);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0));
  };
  for (const DeviationPiece& p : pieces) {
    const std::array<double, 3> f = statistics_detail::sorted(p.at);
    const std::size_t first = binOf(f[0]), last = binOf(f[2]);
    double below = 0.0;
    for (std::size_t bin = first; bin <= last; ++bin) {
      const double upto = bin == last ? 1.0 : statistics_detail::shareBelow(f, h.edges_mm[bin + 1]);
      h.area_mm2[bin] += share * p.area_mm2 * (upto - below);
      below = upto;
    }
  }
}

void fillStatistics(const BothSides& sides, Comparison& out) {
  for (const SampledSide* side : {&sides.machined, &sides.nominal}) {
    for (const double d : side->deviation) {
      if (std::isnan(d)) continue;
      out.max_gouge_mm = std::max(out.max_gouge_mm, -d);
      out.max_excess_mm = std::max(out.max_excess_mm, d);
    }
  }
  DeviationPieces machined, nominal;
  parallelFor(0, 2, [&](int side) {
    DeviationPieces& pieces = side == 0 ? machined : nominal;
    pieces = statistics_detail::piecesOf(side == 0 ? sides.machined : sides.nominal);
    (side == 0 ? out.machined : out.nominal) = figuresOf(pieces);
  });
  addToHistogram(machined, 0.5, out);
  addToHistogram(nominal, 0.5, out);
  out.rms_mm = std::max(out.machined.rms_mm, out.nominal.rms_mm);
  out.p95_mm = std::max(out.machined.p95_mm, out.nominal.p95_mm);
  PROVEOUT_ASSERT(out.p95_mm <= std::max(out.max_gouge_mm, out.max_excess_mm));
}

}  // namespace proveout
