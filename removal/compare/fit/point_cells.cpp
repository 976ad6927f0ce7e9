#include "removal/compare/fit/point_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace proveout {

namespace {

/// Cells along an axis, at most: a key has 21 bits for each.
constexpr double kMostCells = 1 << 20;

}  // namespace

PointCells::PointCells(std::vector<Vec3> points, double cell_mm)
    : points_(std::move(points)), cell_(cell_mm) {
  Box3 bounds;
  for (const Vec3& p : points_) bounds.extend(p);
  if (points_.empty()) return;
  corner_ = bounds.min;
  cell_ = std::max(cell_, bounds.size().maxCoeff() / kMostCells);
  std::vector<std::uint64_t> keys(points_.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = keyOf(cellOf(points_[i]));
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::sort(order_.begin(), order_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
  for (std::uint32_t k = 0; k < order_.size();) {
    std::uint32_t end = k;
    while (end < order_.size() && keys[order_[end]] == keys[order_[k]]) ++end;
    ranges_[keys[order_[k]]] = {k, end};
    k = end;
  }
}

PointCells::Cell PointCells::cellOf(const Vec3& p) const {
  // Places far off all points have cells beyond the last ones, which are empty.
  const auto along = [&](int k) {
    const double cells = std::floor((p[k] - corner_[k]) / cell_);
    return static_cast<std::int64_t>(std::clamp(cells, -2.0, kMostCells + 2.0));
  };
  return {along(0), along(1), along(2)};
}

std::uint64_t PointCells::keyOf(const Cell& cell) {
  const auto bits = [](std::int64_t v) { return static_cast<std::uint64_t>(v + 2); };
  return bits(cell.x) << 42 | bits(cell.y) << 21 | bits(cell.z);
}

std::vector<std::uint32_t> PointCells::crowds() const {
  std::vector<std::uint32_t> out(points_.size());
  for (const auto& [key, range] : ranges_) {
    for (std::uint32_t k = range.first; k < range.second; ++k) out[order_[k]] = range.second - range.first;
  }
  return out;
}

double pointSpacing(const std::vector<Vec3>& points, double area_mm2) {
  constexpr std::size_t kNeighbours = 8, kMostAsked = 2000;
  if (points.size() <= kNeighbours || !(area_mm2 > 0.0)) return 0.0;
  const double even = std::sqrt(area_mm2 / static_cast<double>(points.size()));
  const PointCells cells(points, 2.0 * even);
  std::vector<double> reaches, near;
  const std::size_t step = 1 + points.size() / kMostAsked;
  for (std::size_t i = 0; i < points.size(); i += step) {
    for (double radius = 2.0 * even;; radius *= 2.0) {
      near.clear();
      cells.forEachNear(points[i], radius, [&](std::uint32_t, double squared) { near.push_back(squared); });
      if (near.size() > kNeighbours || radius > 16.0 * even) break;
    }
    if (near.size() <= kNeighbours) continue;  // a stray
    std::nth_element(near.begin(), near.begin() + kNeighbours, near.end());
    reaches.push_back(std::sqrt(near[kNeighbours]));
  }
  if (reaches.empty()) return even;
  const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
  std::nth_element(reaches.begin(), middle, reaches.end());
  // Nine points lie in a circle of that radius, about.
  return *middle * std::sqrt(kPi / (static_cast<double>(kNeighbours) + 0.5));
}

}  // namespace proveout
