// A connected piece of what is left of a blank.
#pragma once

#include <string>

#include "core/geometry/types.h"

namespace proveout {

struct StockBody {
  double volume_mm3 = 0.0;
  Box3 bounds;       ///< mm, frame of its clamping
  std::string role;  ///< "part", "slug", "loose"
  /// Of slugs that a wire cut free: which way they can leave the part, along Z: "both", "down", "up", "none";
  /// else empty.
  std::string leaves = {};
};

}  // namespace proveout
