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
    zone = {std::min(e.az, e.bz), std::max(e.az, e.bz), 0.0, 0.0, 0.0, false};
    if (e.arc) {
      zone.alpha = e.radius * e.radius - e.cz * e.cz, zone.beta = 2.0 * e.cz, zone.gamma = -1.0;
    } else {
      const double k = e.dr / e.dz, at_tip = e.ar - k * e.az;
      zone.alpha = at_tip * at_tip, zone.beta = 2.0 * at_tip * k, zone.gamma = k * k, zone.widens = k > 0.0;
    }
  }
  return solid;
}

PoseSolid grownSolid(const PoseSolid& solid, double by) {
  PoseSolid out;
  out.zones = solid.zones;
  for (int i = 0; i < solid.zones; ++i) {
    const PoseSolid::Zone& z = solid.zone[i];
    PoseSolid::Zone& to = out.zone[i];
    to = {z.low - by, z.high + by, 0.0, 0.0, 0.0, false};
    if (z.gamma < 0.0) {  // (alpha, beta, -1): centre at beta / 2
      const double radius = std::sqrt(z.alpha + 0.25 * z.beta * z.beta) + by;
      to.beta = z.beta, to.gamma = -1.0;
      to.alpha = radius * radius - 0.25 * z.beta * z.beta;
    } else {
      const auto radius2 = [&](double h) { return z.alpha + z.beta * h + z.gamma * h * h; };
      const double widest = std::sqrt(std::max({0.0, radius2(z.low), radius2(z.high)})) + by;
      to.alpha = widest * widest;
    }
    for (const double h : {to.low, to.high})
      out.rim[out.rims++] = {h, std::max(0.0, to.alpha + to.beta * h + to.gamma * h * h)};
  }
  return out;
}

/// No point of a square's columns is farther from the middle one, level, than its corners.
void reachOfRun(const PoseRun& run, double between, const Box3& bounds, const FourBlocks& blocks, double* low,
                double* high) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double half = blocks.half_width;
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    low[i] = kNone, high[i] = -kNone;
    any = any || (blocks.x[i] + half >= bounds.min.x() && blocks.x[i] - half <= bounds.max.x() &&
                  blocks.y[i] + half >= bounds.min.y() && blocks.y[i] - half <= bounds.max.y() &&
                  blocks.z_high[i] > bounds.min.z() && blocks.z_low[i] < bounds.max.z());
  }
  if (!any) return;
  PoseSolid around = grownSolid(*run.solid, std::sqrt(2.0) * half + between + kCullSlackMm);
  if (!run.straight) around.rims = 0;  // `between` holds what they leave
  PoseRun grown = run;
  grown.solid = &around;
  double x[8], y[8], from[8], to[8];
  for (int i = 0; i < 8; ++i) x[i] = blocks.x[i % 4], y[i] = blocks.y[i % 4];
  columnKernels().poses(grown, x, y, 4, from, to);
  for (int i = 0; i < 4; ++i) {
    const double lowest = std::max(from[i], bounds.min.z()) - kCullSlackMm,
                 highest = std::min(to[i], bounds.max.z()) + kCullSlackMm;
    if (!(from[i] <= to[i]) || lowest >= blocks.z_high[i] || highest <= blocks.z_low[i]) continue;
    low[i] = lowest, high[i] = highest;
  }
}

}  // namespace proveout
