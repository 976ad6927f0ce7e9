#include "removal/pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

const double kDiagonal = std::sqrt(2.0);
/// Culling never decides within rounding, mm.
constexpr double kSlackMm = 1e-6;

/// Lower boundary at `radial`, which is its least height from there outwards.
double lowestBeyond(const ColumnSolid& solid, double radial) {
  if (solid.ball) return solid.radius - std::sqrt(solid.radius * solid.radius - radial * radial);
  return solid.flat ? solid.z_min : solid.lower.height(radial);
}

}  // namespace

Sweep Pass::lineSweep() const {
  const Vec3 from = sweepStart(columns);
  return Sweep(*profile, from, from + sweepWay(columns), nullptr);
}

double highestReach(const Pass& pass) {
  return pass.columns.z + std::max(pass.columns.rise, 0.0) + pass.columns.solid->z_max + kSlackMm;
}

double reachIn(const Pass& pass, const BlockBox& box) {
  constexpr double kMisses = std::numeric_limits<double>::infinity();
  const ColumnSweep& c = pass.columns;
  const ColumnSolid& solid = *c.solid;
  const double qx = box.x - c.x, qy = box.y - c.y, corner = kDiagonal * box.half_width;
  const double reach = corner + solid.radius + kSlackMm;
  double gap2, rise_low = std::min(c.rise, 0.0), rise_high = std::max(c.rise, 0.0);
  if (c.kind == ColumnSweep::Kind::kLine) {
    const double along = qx * c.ux + qy * c.uy, across = qx * c.uy - qy * c.ux;
    const double over = along - std::clamp(along, 0.0, c.length);
    gap2 = over * over + across * across;
    if (gap2 > reach * reach) return kMisses;
    // Only this stretch of the way can be over the block.
    const double first = c.slope * std::clamp(along - reach, 0.0, c.length),
                 last = c.slope * std::clamp(along + reach, 0.0, c.length);
    rise_low = std::min(first, last);
    rise_high = std::max(first, last);
  } else {
    const double gap = std::sqrt(qx * qx + qy * qy) - c.arc_radius;
    gap2 = gap * gap;
    if (gap2 > reach * reach) return kMisses;
  }
  const double lowest = c.z + rise_low + solid.z_min - kSlackMm, highest = c.z + rise_high + solid.z_max + kSlackMm;
  if (lowest >= box.z_high || highest <= box.z_low) return kMisses;
  const double radial = std::clamp(std::sqrt(gap2) - corner, 0.0, solid.radius);
  const double low = c.z + rise_low + lowestBeyond(solid, radial) - kSlackMm;
  return low < box.z_high ? low : kMisses;
}

}  // namespace proveout
