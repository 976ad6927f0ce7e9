#include "app/session/forecast/height_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// Slopes to both sides, and what they differ by, above which triangles stay small.
constexpr double kUneven = 0.05;

/// The sum over columns of the map, always in the same order.
template <typename Of>
double overColumns(int first, int last, const Of& of) {
  std::vector<double> each(static_cast<std::size_t>(std::max(first, last)), 0.0);
  parallelFor(first, std::max(first, last), [&](int x) { each[static_cast<std::size_t>(x)] = of(x); });
  return std::accumulate(each.begin(), each.end(), 0.0);
}

}  // namespace

double Footprint::heightAt2(double distance2) const {
  if (distance2 <= flat_radius * flat_radius) return 0.0;
  const double out = std::sqrt(distance2) - flat_radius, round = std::min(out, corner_end - flat_radius);
  const double up = corner > 0.0 ? corner - std::sqrt(std::max(0.0, corner * corner - round * round)) : 0.0;
  return up + rise * (out - round);
}

Footprint footprintOf(const Tool& tool) {
  const double radius = 0.5 * tool.diameter, tip = 0.5 * tool.tip_diameter;
  const double half_cone = degToRad(0.5 * tool.cone_angle_deg);
  switch (tool.type) {
    case ToolType::kBall:
      return {radius, 0.0, radius, radius, 0.0};
    case ToolType::kBull:
      return {radius, radius - tool.corner_radius, tool.corner_radius, radius, 0.0};
    case ToolType::kDrill:
      return {radius, 0.0, 0.0, 0.0, 1.0 / std::tan(degToRad(0.5 * tool.point_angle_deg))};
    case ToolType::kCone:
      return {radius, tip, 0.0, tip, 1.0 / std::tan(half_cone)};
    case ToolType::kTaperBall:  // the flank touches the ball where both have one slope
      return {radius, 0.0, tip, tip * std::cos(half_cone), 1.0 / std::tan(half_cone)};
    default:
      return {radius, radius, 0.0, radius, 0.0};
  }
}

HeightMap::HeightMap(const Box3& blank, double cell) : blank_(blank), cell_(cell) {
  nx_ = std::max(1, static_cast<int>(std::ceil(blank.size().x() / cell)));
  ny_ = std::max(1, static_cast<int>(std::ceil(blank.size().y() / cell)));
  height_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), blank.max.z());
  made_.resize(height_.size());
}

int HeightMap::column(double x) const {
  return static_cast<int>(std::clamp((x - blank_.min.x()) / cell_, 0.0, nx_ - 1.0));
}
int HeightMap::row(double y) const {
  return static_cast<int>(std::clamp((y - blank_.min.y()) / cell_, 0.0, ny_ - 1.0));
}

void HeightMap::lower(const Vec3& a, const Vec3& b, const Footprint& tool, const CutBy& made, int band) {
  const double radius = tool.radius;
  const int x0 = std::max(column(std::min(a.x(), b.x()) - radius), firstOf(band)),
            x1 = std::min(column(std::max(a.x(), b.x()) + radius), firstOf(band + 1) - 1);
  if (x0 > x1) return;
  const int y0 = row(std::min(a.y(), b.y()) - radius), y1 = row(std::max(a.y(), b.y()) + radius);
  const Vec2 along = (b - a).head<2>();
  const double length2 = along.squaredNorm(), lowest = std::max(std::min(a.z(), b.z()), blank_.min.z());
  for (int x = x0; x <= x1; ++x) {
    const double px = blank_.min.x() + (x + 0.5) * cell_;
    for (int y = y0; y <= y1; ++y) {
      double& height = height_[index(x, y)];
      if (height <= lowest) continue;
      const Vec2 p(px - a.x(), blank_.min.y() + (y + 0.5) * cell_ - a.y());
      const double t = length2 > 0 ? std::clamp(p.dot(along) / length2, 0.0, 1.0) : 0.0;
      const double distance2 = (p - t * along).squaredNorm();
      if (distance2 > radius * radius) continue;
      const double tip = length2 > 0 ? a.z() + t * (b.z() - a.z()) : std::min(a.z(), b.z());
      if (tip >= height) continue;
      const double lowered = std::max(tip + tool.heightAt2(distance2), blank_.min.z());
      if (lowered >= height) continue;
      height = lowered;
      made_[index(x, y)] = made;
    }
  }
}

double HeightMap::addedArea() const {
  return overColumns(0, nx_, [&](int x) {
    double added = 0.0;
    for (int y = 0; y < ny_; ++y) {
      const double z = height_[index(x, y)];
      const double dx = x + 1 < nx_ ? (height_[index(x + 1, y)] - z) / cell_ : 0.0;
      const double dy = y + 1 < ny_ ? (height_[index(x, y + 1)] - z) / cell_ : 0.0;
      const double area = cell_ * cell_, slope = std::sqrt(1.0 + dx * dx + dy * dy);
      added += area * (z > blank_.min.z() ? slope - 1.0 : slope - 3.0);
    }
    return added;
  });
}

CutAreas HeightMap::cutOf(int x) const {
  CutAreas cut;
  for (int y = 0; y < ny_; ++y) {
    const std::size_t at = index(x, y), beside = x + 1 < nx_ ? index(x + 1, y) : at,
                      behind = y + 1 < ny_ ? index(x, y + 1) : at;
    const double z = height_[at], zx = height_[beside], zy = height_[behind];
    if (zx == z && zy == z) continue;
    const CutBy& made = made_[z <= std::min(zx, zy) ? at : zx <= zy ? beside : behind];
    const double dx = (zx - z) / cell_, dy = (zy - z) / cell_, slope = std::sqrt(1.0 + dx * dx + dy * dy);
    const double area =
        static_cast<double>(made.faces) * cell_ * cell_ * (z > blank_.min.z() ? slope : slope - 1.0);
    cut.all_mm2 += area;
    if (!made.ruled) cut.bends_mm += area * static_cast<double>(made.bend);
    if (made.stepped) cut.stepped_mm2 += area;
    if (made.ruled) (made.bend > 0.0F ? cut.ruled_mm2 : cut.flat_mm2) += area;
  }
  return cut;
}

CutAreas HeightMap::cutAreas() const {
  std::vector<CutAreas> columns(static_cast<std::size_t>(nx_));
  parallelFor(0, nx_, [&](int x) { columns[static_cast<std::size_t>(x)] = cutOf(x); });
  CutAreas cut;
  for (const CutAreas& column : columns) {
    cut.all_mm2 += column.all_mm2;
    cut.flat_mm2 += column.flat_mm2;
    cut.ruled_mm2 += column.ruled_mm2;
    cut.stepped_mm2 += column.stepped_mm2;
    cut.bends_mm += column.bends_mm;
  }
  return cut;
}

double HeightMap::unevenArea() const {
  const double least = kUneven * cell_;
  const auto isUneven = [&](std::size_t before, std::size_t at, std::size_t after) {
    const double back = height_[before] - height_[at], on = height_[after] - height_[at];
    return std::abs(back) > least && std::abs(on) > least && std::abs(back + on) > least;
  };
  const double count = overColumns(1, nx_ - 1, [&](int x) {
    double uneven = 0.0;
    for (int y = 1; y + 1 < ny_; ++y) {
      const std::size_t at = index(x, y);
      if (made_[at].ruled || height_[at] <= blank_.min.z() || height_[at] >= blank_.max.z()) continue;
      if (isUneven(index(x - 1, y), at, index(x + 1, y)) || isUneven(index(x, y - 1), at, index(x, y + 1)))
        uneven += 1.0;
    }
    return uneven;
  });
  return count * cell_ * cell_;
}

}  // namespace proveout
