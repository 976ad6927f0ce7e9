// How high something stands near a place.
#pragma once

#include <optional>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// Largest z of the shape within the square of half side `reach` about `place`, along X and Y, mm. Nothing:
/// it is not there. Of a saved stock nothing is known, of a body in closed form its bounds.
std::optional<double> topNear(const StockShape& shape, const Vec2& place, double reach);
std::optional<double> topNear(const TriMesh& mesh, const Vec2& place, double reach);

}  // namespace proveout
