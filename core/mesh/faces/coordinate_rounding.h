// How exactly the coordinates of a mesh are written.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// How far a coordinate of the mesh may lie off the one that was meant, mm: half of a step of single
/// precision at the size of the mesh, or of the decimals that all its coordinates are rounded to, in mm or
/// inches. 0 for a mesh without points.
double coordinateRounding(const TriMesh& mesh);

}  // namespace proveout
