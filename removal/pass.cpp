#include "removal/pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

const double kDiagonal = std::sqrt(2.0);
/// Culling never decides within rounding, mm.
constexpr double kSlackMm = 1e-6;

}  // namespace

Sweep Pass::lineSweep() const {
  const Vec3 from = sweepStart(columns);
  return Sweep(*profile, from, from + sweepWay(columns), nullptr);
}

double reachIn(const Pass& pass, const BlockBox& box) {
  const ColumnSweep& c = pass.columns;
  const double qx = box.x - c.x, qy = box.y - c.y, corner = kDiagonal * box.half_width;
  double gap, rise_low = std::min(c.rise, 0.0), rise_high = std::max(c.rise, 0.0);
  if (c.kind == ColumnSweep::Kind::kLine) {
    const double along = qx * c.ux + qy * c.uy, across = qx * c.uy - qy * c.ux;
    const double over = along - std::clamp(along, 0.0, c.length);
    gap = std::sqrt(over * over + across * across) - corner;
    // Only this stretch of the way can be over the block.
    const double reach = corner + c.solid->radius;
    const double first = c.slope * std::clamp(along - reach, 0.0, c.length),
                 last = c.slope * std::clamp(along + reach, 0.0, c.length);
    rise_low = std::min(first, last);
    rise_high = std::max(first, last);
  } else {
    gap = std::abs(std::sqrt(qx * qx + qy * qy) - c.arc_radius) - corner;
  }
  constexpr double kMisses = std::numeric_limits<double>::infinity();
  if (gap > c.solid->radius + kSlackMm) return kMisses;
  const double radial = std::clamp(gap, 0.0, c.solid->radius);
  const double low = c.z + rise_low + c.solid->lower.height(radial) - kSlackMm;
  const double high = c.z + rise_high - c.solid->upper.height(radial) + kSlackMm;
  return low < box.z_high && high > box.z_low ? low : kMisses;
}

}  // namespace proveout
