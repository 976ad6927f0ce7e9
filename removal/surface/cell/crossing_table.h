// The crossings around a leaf's cells, by place.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include "removal/grid/leaf_layers.h"
#include "removal/surface/cell/surface_grid.h"

namespace proveout {

/// The crossings that the cells of a leaf touch, by the start of their edge (0..8 in each coordinate). Only
/// entries of crossed edges are valid.
class CrossingTable {
 public:
  void fill(const std::vector<SurfaceLeaf>& leaves, const SurfaceLeaf& leaf) {
    const Crossing* c = leaf.stock->crossings.data();
    forEachEdge(leaf.edges, [&](int axis, int x, int y, int z) { at_[index(axis, x, y, z)] = c++; });
    for (int i = 1; i < 7; ++i) {
      if (leaf.upper[i] >= 0) fillFrom(leaves[static_cast<std::size_t>(leaf.upper[i])], i);
    }
  }
  static int index(int axis, int x, int y, int z) { return ((axis * 9 + x) * 9 + y) * 9 + z; }
  const Crossing* operator[](int i) const { return at_[i]; }

 private:
  /// `place`: of the leaf, as seen from the one whose cells are read.
  void fillFrom(const SurfaceLeaf& leaf, int place) {
    const int dx = (place & 1) * 8, dy = (place >> 1 & 1) * 8, dz = (place >> 2) * 8;
    const std::uint64_t columns = (dx != 0 ? kColumnX0 : ~0ull) & (dy != 0 ? kColumnY0 : ~0ull);
    for (int axis = 0; axis < 3; ++axis) {
      if (place >> axis & 1) continue;
      for (int z = 0; z < (dz != 0 ? 1 : 8); ++z) {
        const std::uint64_t crossed = leaf.edges.crossed[axis][z];
        for (std::uint64_t rest = crossed & columns; rest != 0; rest &= rest - 1) {
          const int bit = std::countr_zero(rest);
          const int n = leaf.edges.first[axis][z] + countBits(crossed & ((1ull << bit) - 1));
          at_[index(axis, (bit >> 3) + dx, (bit & 7) + dy, z + dz)] =
              &leaf.stock->crossings[static_cast<std::size_t>(n)];
        }
      }
    }
  }
  std::array<const Crossing*, 3 * 729> at_;
};

}  // namespace proveout
