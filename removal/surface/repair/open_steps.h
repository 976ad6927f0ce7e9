// Walls lower than a cell, for which the mesh has one vertex a cell: there it is opened along these vertices,
// and the wall set in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// A vertex on such a wall, mm.
struct StepVertex {
  std::uint32_t vertex = 0;
  Eigen::Vector3f at;         ///< where it is
  Eigen::Vector3f low, high;  ///< where the wall's two edges are
  std::uint32_t motion = 0;   ///< of the wall and of what is below it
};

/// Makes two vertices of each that lies where triangles of its motion and others meet, in one line: the one
/// below keeps its number and goes to `low`; wall triangles join them along the line, and close it at its
/// ends. What would turn triangles over, or run through others, is not done. `mesh`: closed and 2-manifold,
/// with motions; it stays so. `merged`: a flag for each vertex, or empty; new vertices get 0. The same
/// result for the same input always.
void openSteps(TriMesh& mesh, std::span<const StepVertex> steps, std::vector<std::uint8_t>& merged);

}  // namespace proveout
