// What a wire cuts.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "removal/grid/stock_shape.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {

/// A blank with upright walls; mm, workpiece frame.
struct PrismBlank {
  std::vector<PlaneLoop> loops;  ///< borders and start holes that do not cross
  double z_low = 0.0, z_high = 0.0;
  /// Where fixtures reach between these heights, as convex polygons seen from +z: see footprintOf.
  PlanePolygons held_at;

  double height() const { return z_high - z_low; }
};

/// Boxes, and cylinders and tubes along Z. Errors: other shapes.
Result<PrismBlank> prismOf(const StockShape& shape);

}  // namespace proveout
