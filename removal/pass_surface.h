// What surface a pass leaves where it cuts a grid edge, in closed form for the commonest tools.
#pragma once

#include <optional>

#include "removal/pass.h"

namespace proveout {

/// Surface of a swept volume at a point.
struct PassSurface {
  Vec3 normal;  ///< unit, away from the swept volume
  int element;  ///< as SweepSample::element
};

/// `p` is on the surface, where the pass cuts a grid edge along `axis`; `below`: the material's end of a
/// vertical edge is the lower one. Empty for arcs and for tools other than flat and ball ends.
std::optional<PassSurface> closedSurface(const Pass& pass, const Vec3& p, int axis, bool below);

}  // namespace proveout
