// Triangles of no area, taken out of a closed mesh.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Turns the longest edge of each triangle whose corners lie on one line, so that its middle corner becomes
/// one of the triangle behind that edge: the same surface, of triangles that all have an area. Requires a
/// closed 2-manifold. Those that cannot be turned stay: folded ones, and where the new edge is there already.
TriMesh withoutFlatTriangles(TriMesh mesh);

}  // namespace proveout
