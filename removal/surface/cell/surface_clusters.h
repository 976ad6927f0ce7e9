// Which cells of a leaf may become one vertex: flat patches of surface in cubes of 2, 4 and 8 cells.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/types.h"
#include "removal/grid/leaf_bits.h"

namespace proveout {

struct SurfaceLeaf;

/// Cubes of a leaf whose cells are merged to one vertex each.
struct LeafClusters {
  std::uint64_t two = 0;  ///< cubes of 2x2x2 cells, bit z/2 * 16 + x/2 * 4 + y/2
  std::uint8_t four = 0;  ///< cubes of 4x4x4 cells, bit z/4 * 4 + x/4 * 2 + y/4; only of merged smaller ones
  bool eight = false;     ///< the whole leaf; only of merged smaller ones
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< mean over the leaf, if it is merged whole
  std::uint8_t above = 0;  ///< cubes of 8 << above cells, from leaves that are merged whole
};

/// The cells of a leaf as the clusters see them, by rank.
struct LeafPatch {
  std::array<Eigen::Vector3f, 512> p, n;  ///< vertex (leaf units) and unit normal
  LeafBits gentle{};                      ///< one sheet that bends little inside the cell
  /// Faces of cells (towards the next along x, y, z) that the surface crosses.
  std::array<LeafBits, 3> faces{};
};

/// Finds the cubes whose surface is one disk, stays within `flatness` (grid steps, all of the range) of a
/// plane and has its normals in a narrow cone.
LeafClusters findClusters(const SurfaceLeaf& leaf, const LeafPatch& patch, float flatness);
/// What that finds where all cells lie on one plane, if the plane is merged at all: `flatness` must be more
/// than what the stored normals are good for.
bool mergesPlanes(float flatness);
LeafClusters planeClusters(const Eigen::Vector3f& normal);

/// The cells of a cube of a leaf: layers z0 .. z0 + size - 1, bits of `columns`.
struct CellCube {
  int z0 = 0, size = 8;
  std::uint64_t columns = ~0ull;
};
inline CellCube cubeAt(int size, int x0, int y0, int z0) {
  const std::uint64_t row = (1ull << size) - 1;
  std::uint64_t columns = 0;
  for (int x = x0; x < x0 + size; ++x) columns |= row << leafBit(x, y0);
  return {z0, size, columns};
}

}  // namespace proveout
