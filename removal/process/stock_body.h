// A connected piece of what is left of a blank.
#pragma once

#include <string>
#include <vector>

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

/// mm3.
inline double volumeOf(const std::vector<StockBody>& bodies) {
  double sum = 0.0;
  for (const StockBody& body : bodies) sum += body.volume_mm3;
  return sum;
}

}  // namespace proveout
