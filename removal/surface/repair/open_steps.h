// Walls lower than a cell, for which the mesh has only one vertex a cell: opens the mesh along these
// vertices and sets the wall in.
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
/// ends. A step whose wall would fold triangles, or make them run through others, is left closed. `mesh`:
/// closed and 2-manifold, with motions; it stays so. `merged`: a flag for each vertex, or empty; new
/// vertices get 0. The same input always gives the same result.
void openSteps(TriMesh& mesh, std::span<const StepVertex> steps, std::vector<std::uint8_t>& merged);

}  // namespace proveout
