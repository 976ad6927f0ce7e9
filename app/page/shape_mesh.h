// Blanks and fixtures as meshes, to be drawn.
#pragma once

#include <optional>

#include "core/mesh/tri_mesh.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// The shape's surface, mm, round ones in 64 facets. None for a saved stock and a body in closed form.
std::optional<TriMesh> meshOfShape(const StockShape& shape);

/// Adds the triangles of `more`.
void appendMesh(const TriMesh& more, TriMesh& mesh);

}  // namespace proveout
