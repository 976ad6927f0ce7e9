// Changes of a finished mesh where it runs through itself.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

enum class MendAim {
  kMost,
  kAll  ///< if any pair is left, the mesh is as it was, bit for bit
};

/// Tries to part the triangles of `pairs` (as findIntersections gives them) by turning edges, drawing
/// vertices together and shifting vertices along the surface, so that old and new surface keep within 0.05
/// cells of each other; first as good as exactly. `mesh` must be closed and 2-manifold and stays so; its
/// vertices and triangles may become fewer. `cell_mm` > 0: the grid spacing. Returns the pairs that are left,
/// by the numbers that triangles had before. The same result for the same input always.
std::vector<std::array<std::uint32_t, 2>> mendIntersections(
    TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs, double cell_mm,
    MendAim aim = MendAim::kMost);

}  // namespace proveout
