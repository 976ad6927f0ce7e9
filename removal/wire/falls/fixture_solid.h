// Fixtures as a wire meets them: closed surfaces, and where they reach between the heights of a workpiece.
#pragma once

#include <vector>

#include "core/mesh/surface_mesh.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// A box, cylinder, tube or closed mesh as a surface; empty for other shapes. Cylinders are at most 0.001 mm
/// too large, and bores as much too small.
SurfaceMesh solidOf(const StockShape& shape);

/// What a body must be nearer to than this so that it touches it, mm.
inline constexpr double kHeldWithinMm = 0.01;

/// The triangles of a surface between two heights, each clipped there, as convex polygons seen from +z; of
/// upright ones the polygon is flat.
std::vector<std::vector<Vec2>> footprintOf(const SurfaceMesh& solid, double z_low, double z_high);

}  // namespace proveout
