#include "removal/pass.h"

#include <algorithm>

namespace proveout {

Sweep Pass::lineSweep() const {
  const Vec3 from = sweepStart(columns);
  return Sweep(*profile, from, from + sweepWay(columns), nullptr);
}

double highestReach(const Pass& pass) {
  return pass.columns.z + std::max(pass.columns.rise, 0.0) + pass.columns.solid->z_max + kCullSlackMm;
}

double lowestTop(const Pass& pass) {
  return pass.columns.z + std::min(pass.columns.rise, 0.0) + pass.columns.solid->z_max;
}

bool holdsEdges(const Pass& pass, double h) {
  const ColumnSweep& c = pass.columns;
  if (c.kind != ColumnSweep::Kind::kArc || !(c.wide || c.full)) return true;
  const double pillar = c.arc_radius - c.solid->radius;
  return pillar <= 0.0 || pillar >= h;
}

}  // namespace proveout
