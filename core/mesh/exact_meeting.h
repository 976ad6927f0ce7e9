// Whether two triangles of a mesh run through each other, without rounding. Slow: for pairs that were found.
#pragma once

#include <cstdint>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Whether two triangles of the mesh meet elsewhere than in their common corners; touching counts. Triangles
/// whose corners lie on one line are not looked at: see isFlat().
bool meetExactly(const TriMesh& mesh, std::uint32_t s, std::uint32_t t);
/// Whether the corners of a triangle lie on one line.
bool isFlat(const TriMesh& mesh, std::uint32_t t);
/// Seen from above (along Z): whether the corners of a triangle turn left (1), right (-1), or not at all (0).
int turnFromAbove(const TriMesh& mesh, std::uint32_t t);

}  // namespace proveout
