#include "removal/surface/mesh/leaf_mesh.h"

#include <algorithm>
#include <atomic>

#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/intersections.h"
#include "removal/surface/mesh/surface_faults.h"

namespace proveout {

std::size_t LeafMesh::leafOf(std::size_t triangle) const {
  const bool fan = triangle >= firstFanTriangle();
  const auto after = [&](std::size_t t, const LeafPart& part) {
    return t < (fan ? part.first_fan : part.first_triangle);
  };
  return static_cast<std::size_t>(std::upper_bound(parts.begin(), parts.end(), triangle, after) -
                                  parts.begin()) -
         1;
}

bool isDense(const LeafMesh& mesh) {
  const std::size_t vertices = mesh.mesh.positions.size();
  if (vertices != mesh.firstOfFans() + mesh.fan_at.size()) return false;
  if (mesh.number != nullptr && mesh.cell_at.size() != mesh.kept) return false;
  for (std::uint32_t v = 0; v < mesh.kept; ++v) {
    if (mesh.numberOf(mesh.cellAt(v)) != v) return false;
  }
  const auto& triangles = mesh.mesh.triangles;
  return mesh.mesh.motion.size() == triangles.size() &&
         std::all_of(triangles.begin(), triangles.end(),
                     [&](const auto& t) { return triangleIsProper(t, vertices); });
}

std::vector<std::uint8_t> verticesOf(const LeafMesh& mesh, const std::vector<std::uint8_t>& leaves) {
  const TriMesh& all = mesh.mesh;
  std::vector<std::uint8_t> touched(all.positions.size(), 0);
  const auto touch = [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      for (const std::uint32_t v : all.triangles[t])
        std::atomic_ref(touched[v]).store(1, std::memory_order_relaxed);
    }
  };
  parallelFor(std::size_t{0}, mesh.parts.size(), [&](std::size_t i) {
    if (leaves[i] != 0) touch(mesh.parts[i].first_triangle, mesh.parts[i].lastTriangle());
  });
  touch(mesh.firstFanTriangle(), all.triangles.size());
  return touched;
}

std::vector<std::uint32_t> findBrokenFans(const LeafMesh& mesh, const VertexMerger& merger,
                                          std::vector<std::uint8_t>& unwatched) {
  std::vector<std::uint32_t> faults;
  if (!merger.active()) return faults;
  const std::vector<std::uint8_t> touched = verticesOf(mesh, unwatched);
  std::fill(unwatched.begin(), unwatched.end(), 0);
  std::vector<std::uint32_t> watched(mesh.mesh.positions.size(), kNoWatch);
  parallelFor(std::size_t{0}, mesh.parts.size(), [&](std::size_t i) {
    const LeafPart& part = mesh.parts[i];
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertices; ++v) {
      if (touched[v] != 0 && merger.merged(mesh.cell_at[v])) watched[v] = mesh.cell_at[v];
    }
  });
  findBrokenFans(mesh.mesh, watched, faults);
  return faults;
}

namespace {

/// Whether a leaf or one beside it has a flag.
bool isNear(const SurfaceLeaf& leaf, const std::vector<std::uint8_t>& flags) {
  const auto has = [&](std::int32_t n) { return n >= 0 && flags[static_cast<std::size_t>(n)] != 0; };
  return std::ranges::any_of(leaf.upper, has) || std::ranges::any_of(leaf.lower, has);
}

/// Flags the triangles of a leaf's fans. Those start at their middle; those without places where sheets touch
/// face like the surface.
void markFans(const LeafMesh& mesh, std::size_t leaf, std::vector<std::uint8_t>& flags) {
  for (std::size_t t = mesh.parts[leaf].first_fan; t < mesh.lastFanTriangle(leaf); ++t) {
    if (!mesh.fanOf(mesh.mesh.triangles[t][0]).faces.empty()) flags[t] = 1;
  }
}

}  // namespace

TrianglePairs findSelfIntersections(const LeafMesh& mesh, const SurfaceGrid& grid,
                                    const std::vector<std::uint8_t>& unchecked,
                                    const std::vector<Box3>& doubts) {
  const TriMesh& all = mesh.mesh;
  std::vector<std::uint8_t> corner(all.positions.size(), 0), suspect(all.triangles.size(), 0);
  if (!doubts.empty()) flagInside(all, doubts, corner);
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    if (unchecked[i] == 0) continue;
    for (const std::uint32_t k : mesh.poor[i]) {
      for (const std::uint32_t v : all.triangles[mesh.parts[i].first_triangle + k]) corner[v] = 1;
    }
    const SurfaceLeaf& leaf = grid.leaves()[i];
    for (std::uint32_t k = 0; k < leaf.extra.size(); ++k) {
      corner[mesh.numberOf(leaf.extra_base + k)] = 1;
      corner[mesh.numberOf(leaf.base + leaf.extra[k].cell)] = 1;
    }
    for (const OutsideVertex& o : leaf.outside) {
      if (grid.crowds(leaf, o.place)) corner[mesh.numberOf(leaf.cellAt(o.place))] = 1;
    }
  }
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    if (mesh.lastFanTriangle(i) > mesh.parts[i].first_fan && isNear(grid.leaves()[i], unchecked))
      markFans(mesh, i, suspect);
  }
  forEachBelow(suspect.size(), [&](std::size_t t) {
    const auto& v = all.triangles[t];
    suspect[t] |= corner[v[0]] | corner[v[1]] | corner[v[2]];
  });
  return findIntersectionsOf(all, suspect);
}

std::vector<std::uint32_t> cornerCellsOf(const LeafMesh& mesh, const SurfaceGrid& grid,
                                         std::uint32_t triangle) {
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t v : mesh.mesh.triangles[triangle]) {
    if (v < mesh.kept) {
      cells.push_back(mesh.cellAt(v));
    } else if (v < mesh.firstOfFans()) {
      cells.push_back(grid.cellOf(v - mesh.kept + mesh.cells));
    }
  }
  return cells;
}

std::vector<std::uint32_t> mergedCellsOf(const LeafMesh& mesh, const SurfaceGrid& grid,
                                         const VertexMerger& merger, std::uint32_t triangle) {
  std::vector<std::uint32_t> cells = cornerCellsOf(mesh, grid, triangle);
  for (const std::uint32_t v : mesh.mesh.triangles[triangle]) {
    if (v >= mesh.firstOfFans()) {
      for (const std::uint32_t corner : mesh.fanOf(v).v) cells.push_back(merger.standIn(grid.cellOf(corner)));
    }
  }
  std::erase_if(cells, [&](std::uint32_t cell) { return !merger.merged(cell); });
  return cells;
}

}  // namespace proveout
