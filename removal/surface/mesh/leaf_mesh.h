// A mesh written leaf by leaf, and what each part of it came from.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/surface/mesh/surface_merge.h"
#include "removal/surface/mesh/surface_splits.h"

namespace proveout {

/// Where a leaf's vertices and triangles stand in the mesh. Those of all leaves follow each other without
/// gaps.
struct LeafPart {
  std::size_t first_triangle = 0;
  std::uint32_t triangles = 0;  ///< without those of fans
  std::size_t first_fan = 0;    ///< first triangle of its fans, which end where the next leaf's begin
  std::uint32_t first_vertex = 0;
  std::uint32_t vertices = 0;  ///< of its cells that stand for themselves
  std::size_t lastTriangle() const { return first_triangle + triangles; }  ///< the one after it
};

/// Its vertices are first those of cells that stand for themselves, leaf by leaf, then those of further
/// sheets, then those of fans; its triangles those of leaves, then those of fans.
struct LeafMesh {
  TriMesh mesh;
  std::vector<LeafPart> parts;  ///< one a leaf
  /// By leaf: triangles, from its first one, that lean far from the exact surface.
  std::vector<std::vector<std::uint32_t>> poor;
  std::uint32_t cells = 0;   ///< of the grid
  std::uint32_t kept = 0;    ///< of them, those that stand for themselves
  std::uint32_t sheets = 0;  ///< vertices of further sheets
  /// By cell: its vertex in the mesh, if it stands for itself. Null where nothing is ever merged.
  std::unique_ptr<std::uint32_t[]> number;
  std::vector<std::uint32_t> cell_at;    ///< the cell of a vertex; empty: each its own
  std::vector<const SplitQuad*> fan_at;  ///< of the vertices of fans

  /// The number in the mesh of a vertex of the grid that stands for itself.
  std::uint32_t numberOf(std::uint32_t v) const {
    if (number == nullptr) return v;
    return v >= cells ? v - cells + kept : number[v];
  }
  std::uint32_t cellAt(std::uint32_t vertex) const { return cell_at.empty() ? vertex : cell_at[vertex]; }
  std::uint32_t firstOfFans() const { return kept + sheets; }
  /// The first triangle of fans.
  std::size_t firstFanTriangle() const { return parts.empty() ? 0 : parts.back().lastTriangle(); }
  /// The one after the last of a leaf's fans.
  std::size_t lastFanTriangle(std::size_t leaf) const {
    return leaf + 1 < parts.size() ? parts[leaf + 1].first_fan : mesh.triangles.size();
  }
  /// The leaf that a triangle was written for.
  std::size_t leafOf(std::size_t triangle) const;
  const SplitQuad& fanOf(std::uint32_t vertex) const { return *fan_at[vertex - firstOfFans()]; }
};

/// Whether the numbers are dense: each vertex of a cell has its cell, which has that number; each triangle
/// has three different vertices of the mesh; each vertex has a position.
bool isDense(const LeafMesh& mesh);

/// Flags of the vertices of triangles in leaves with this flag, and of all fans.
std::vector<std::uint8_t> verticesOf(const LeafMesh& mesh, const std::vector<std::uint8_t>& leaves);

/// Merged cells whose triangles are not one closed fan, in leaves that are `unwatched` (a flag for each,
/// which this clears).
std::vector<std::uint32_t> findBrokenFans(const LeafMesh& mesh, const VertexMerger& merger,
                                          std::vector<std::uint8_t>& unwatched);

using TrianglePairs = std::vector<std::array<std::uint32_t, 2>>;

/// Triangles that run through each other. The surface does not fold where triangles face like the exact
/// surface. So this looks around those that do not, at fans where sheets touch or walls are, at cells of
/// several sheets and at vertices in the way of others, in leaves that are `unchecked` (a flag for each);
/// and at all that is in one of `doubts` (mm).
TrianglePairs findSelfIntersections(const LeafMesh& mesh, const SurfaceGrid& grid,
                                    const std::vector<std::uint8_t>& unchecked,
                                    const std::vector<Box3>& doubts);

/// The cells of a triangle's corners.
std::vector<std::uint32_t> cornerCellsOf(const LeafMesh& mesh, const SurfaceGrid& grid,
                                         std::uint32_t triangle);

/// Merged cells that a triangle depends on.
std::vector<std::uint32_t> mergedCellsOf(const LeafMesh& mesh, const SurfaceGrid& grid,
                                         const VertexMerger& merger, std::uint32_t triangle);

}  // namespace proveout
