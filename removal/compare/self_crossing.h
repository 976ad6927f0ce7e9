// Shells that cross themselves.
#pragma once

#include <cstddef>

#include "core/mesh/shells.h"

namespace proveout {

/// Places where facets of one shell run through each other.
struct SelfCrossing {
  std::size_t pairs = 0;      ///< of facets that do so by more than rounding
  double depth_mm = 0.0;      ///< of the deepest: so far would its facets have to move to come apart, at most
  Vec3 where = Vec3::Zero();  ///< of that, mm
};

/// What is shallower, mm, is the rounding of float coordinates and of whoever made the facets.
inline constexpr double kCrossingRoundingMm = 1e-3;

SelfCrossing findSelfCrossing(const Shells& shells);

}  // namespace proveout
