// Repairs a finished mesh where it intersects itself.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

enum class RepairAim {
  kMost,
  kAll  ///< if any pair is left, the mesh is as it was, bit for bit
};

/// Tries to part the triangles of `pairs` (as findIntersections gives them) by flipping and collapsing edges
/// and shifting vertices along the surface, so that old and new surface stay within 0.05 cells of each
/// other. Changes that hardly move the surface are tried first. `mesh` must be closed and 2-manifold and
/// stays so; its vertices and triangles may become fewer. `cell_mm` > 0: the grid spacing. Returns the pairs
/// that are left, by the numbers that triangles had before. The same input always gives the same result.
std::vector<std::array<std::uint32_t, 2>> repairIntersections(
    TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs, double cell_mm,
    RepairAim aim = RepairAim::kMost);

}  // namespace proveout
