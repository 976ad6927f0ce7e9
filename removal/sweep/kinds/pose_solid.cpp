#include "removal/sweep/kinds/pose_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/sweep/column_sweep.h"

namespace proveout {

double leastRadius(const ConvexProfile& profile) {
  double least = profile.maxRadius();
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc) {
      least = std::min(least, e.radius);
    } else if (e.dz != 0.0) {
      least = std::min({least, e.ar, e.br});
    }
  }
  return least;
}

PoseSolid poseSolid(const ConvexProfile& profile) {
  PoseSolid solid;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc && e.cr != 0.0) return {};
    if (e.br > 0.0) solid.rim[solid.rims++] = {e.bz, e.br * e.br};
    if (!e.arc && e.dz == 0.0) continue;
    PoseSolid::Zone& zone = solid.zone[solid.zones++];
    zone = {std::min(e.az, e.bz), std::max(e.az, e.bz), 0.0, 0.0, 0.0, std::max(e.ar, e.br), false};
    if (e.arc) {
      zone.alpha = e.radius * e.radius - e.cz * e.cz, zone.beta = 2.0 * e.cz, zone.gamma = -1.0;
    } else {
      const double k = e.dr / e.dz, at_tip = e.ar - k * e.az;
      zone.alpha = at_tip * at_tip, zone.beta = 2.0 * at_tip * k, zone.gamma = k * k, zone.widens = k > 0.0;
    }
  }
  return solid;
}

void reachOfRun(const PoseRun& run, double between, const Box3& bounds, const FourBlocks& blocks, double* low,
                double* high) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double half = blocks.half_width;
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    any = any || (blocks.x[i] + half >= bounds.min.x() && blocks.x[i] - half <= bounds.max.x() &&
                  blocks.y[i] + half >= bounds.min.y() && blocks.y[i] - half <= bounds.max.y() &&
                  blocks.z_high[i] > bounds.min.z() && blocks.z_low[i] < bounds.max.z());
  }
  double from[4], to[4];
  if (any) columnKernels().pose_reach(run, between, blocks, from, to);
  for (int i = 0; i < 4; ++i) {
    low[i] = kNone, high[i] = -kNone;
    if (!any || !(from[i] <= to[i])) continue;
    const double lowest = std::max(from[i], bounds.min.z()) - kCullSlackMm,
                 highest = std::min(to[i], bounds.max.z()) + kCullSlackMm;
    if (lowest >= blocks.z_high[i] || highest <= blocks.z_low[i]) continue;
    low[i] = lowest, high[i] = highest;
  }
}

}  // namespace proveout
