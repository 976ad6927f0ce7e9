// Separates the surface of a body where it touches itself, at non-manifold edges and vertices.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Gives each fan of triangles about a vertex a vertex of its own, some steps of a mesh off the others'.
/// Where more than two triangles meet at an edge, those with material between them stay together. Requires a
/// closed mesh, outwards; without edges and vertices of several fans it stays as it is.
void partFans(TriMesh& mesh);

}  // namespace proveout
