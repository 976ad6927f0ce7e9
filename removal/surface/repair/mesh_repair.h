// Writes the mesh, and writes it again as long as merged cells or vertices spoil it.
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "removal/surface/mesh/leaf_quads.h"

namespace proveout {

struct RepairedMesh {
  TriMesh mesh;  ///< closed and 2-manifold, with motions
  /// By vertex: 1 where it stands for several cells. Empty: any may.
  std::vector<std::uint8_t> merged;
  /// Pairs of triangles that run through each other and could not be parted.
  std::size_t self_intersections = 0;
};

/// Takes merged cells apart where they spoil the mesh and around triangles that run through others; parts
/// those by small changes of the mesh, or walls their cells in where these do not help. `quads`: one a leaf,
/// as `planner` plans them with what `merger` has merged. `doubts`: boxes (mm) in which all triangles are
/// checked, besides those that always are. None if cancelled.
std::optional<RepairedMesh> repairedMesh(SurfaceGrid& grid, VertexMerger& merger, const QuadPlanner& planner,
                                         std::vector<LeafQuads> quads, const std::vector<Box3>& doubts,
                                         Progress& progress);

}  // namespace proveout
