// A connected piece of what is left of a blank.
#pragma once

#include <string>

#include "core/geometry/types.h"

namespace proveout {

struct StockBody {
  double volume_mm3 = 0.0;
  Box3 bounds;       ///< mm, frame of its clamping
  std::string role;  ///< "part", "slug", "loose"
};

}  // namespace proveout
