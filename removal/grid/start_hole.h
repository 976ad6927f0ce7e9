// Holes of a blank that a wire is threaded through.
#pragma once

#include "core/geometry/types.h"

namespace proveout {

/// Round, along Z and all through; mm, frame of the blank.
struct StartHole {
  Vec2 at = Vec2::Zero();  ///< its axis
  double diameter = 0.0;   ///< > 0
};

}  // namespace proveout
