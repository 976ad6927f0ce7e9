// Pieces of outlines that several types have.
#pragma once

#include <cmath>

#include "core/geometry/types.h"
#include "core/tool/profile.h"

namespace proveout::tool_types {

/// Ends a profile below `height`, mm: up a flank at `radius` and back to the axis.
inline void closeAt(ConvexProfile& p, double radius, double height) {
  p.lineTo(radius, height);
  p.lineTo(0.0, height);
}

/// Height at which a cone of the given included angle reaches `radius` from `tip_radius`, mm.
inline double coneHeight(double tip_radius, double radius, double included_deg) {
  return (radius - tip_radius) / std::tan(degToRad(0.5 * included_deg));
}

}  // namespace proveout::tool_types
