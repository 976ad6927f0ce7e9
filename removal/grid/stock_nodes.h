// Inside of StockTree: the OpenVDB tree, and where its nodes of 16x16x16 leaves stand.
#pragma once

#include <array>
#include <vector>

#include "removal/grid/stock_tree.h"
#include "removal/grid/vdb_tree.h"

namespace proveout {

struct StockTree::Nodes {
  /// What a value accessor keeps for one thread, for all: a node of 16x16x16 leaves, or what all of it is.
  struct Block {
    StockLowerNode* node = nullptr;
    bool inside = false;
  };

  VdbTree tree{false};
  Coord low;                  ///< leaf that is at index 0 0 0 of the tree
  std::array<int, 3> size{};  ///< leaves each way
  std::array<int, 3> block_count{};
  std::vector<Block> blocks;

  /// Index of a leaf's first voxel, see vdb_tree.h.
  openvdb::Coord indexOf(const Coord& leaf) const {
    return {8 * (leaf.z() - low.z()), 8 * (leaf.x() - low.x()), 8 * (leaf.y() - low.y())};
  }
  Coord leafAt(const openvdb::Coord& index) const {
    return {low.x() + (index.y() >> 3), low.y() + (index.z() >> 3), low.z() + (index.x() >> 3)};
  }
};

}  // namespace proveout
