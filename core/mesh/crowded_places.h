// Where a mesh may run through itself, from the directions that its triangles face.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Numbers of the triangles, in order, that may meet others elsewhere than in common corners. Two triangles
/// that do are both among them, if the mesh is closed and was made by moving the surface of one that does not
/// run through itself by at most `moved_mm` (each point, and no triangle turned over on the way).
///
/// Space is cut into cubes. In one whose triangles all face one direction, within 72 degrees and with those
/// around it, lines in this direction only go out of the material. Two sheets above each other would have
/// material twice below the lower one, and only as far from the surface as it was moved; as this cannot go on
/// through the whole cube, there is one sheet, which the lines pass once.
std::vector<std::uint32_t> trianglesInCrowdedPlaces(const TriMesh& mesh, double moved_mm);

}  // namespace proveout
