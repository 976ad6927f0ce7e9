// The samples of a stock: an OpenVDB tree (vdb_tree.h) behind plain types, and whatever of it is asked again
// and again.
//
// Leaves are named by leaf coordinates (8 voxels a step). A leaf that the surface crosses is a node of the
// tree and has a number, that of its record in the stock's list of leaves; all others are tiles, inside or
// outside.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "removal/grid/coord.h"
#include "removal/grid/leaf_bits.h"

namespace proveout {

class StockTree {
 public:
  static constexpr std::int32_t kOutside = -1, kInside = -2;

  StockTree();
  ~StockTree();
  StockTree(StockTree&&) noexcept;
  StockTree& operator=(StockTree&&) noexcept;

  /// Room for leaves low..high (both included); everything is outside.
  void reset(const Coord& low, const Coord& high);
  bool holds(const Coord& leaf) const;

  /// Number of the leaf (>= 0), kInside or kOutside; kOutside beyond the room.
  std::int32_t get(const Coord& leaf) const;
  /// Its samples, whatever it is.
  const LeafBits& bits(const Coord& leaf) const;
  /// Both for the leaf and its seven neighbours towards +x, +y, +z, or with `step` -1 towards -x, -y, -z: bit
  /// 0 of the place says a step along x, bit 1 along y, bit 2 along z.
  std::array<std::int32_t, 8> getBeside(const Coord& leaf, int step) const;
  std::array<const LeafBits*, 8> bitsBeside(const Coord& leaf) const;

  // All that follow require a leaf within the room.
  /// The samples of a leaf that has or now gets this number; those of a new one are all outside. They stay
  /// where they are until the leaf becomes a tile. Leaves that have a number may
  /// get others by several threads at once.
  LeafBits* number(const Coord& leaf, std::int32_t number);
  /// The leaf becomes a tile.
  void setUniform(const Coord& leaf, bool inside);
  /// All leaves low..high within the room (both included) become tiles inside.
  void fillInside(const Coord& low, const Coord& high);

  /// Calls body(low, high) for boxes of leaves that together hold every tile inside.
  void forEachInside(const std::function<void(const Coord& low, const Coord& high)>& body) const;

  /// Bytes that room of this many leaves each way would take before it holds any leaf.
  static double bytesFor(const Coord& low, const Coord& high);

  struct Nodes;  ///< stock_nodes.h
  const Nodes& nodes() const { return *nodes_; }

 private:
  std::unique_ptr<Nodes> nodes_;
};

}  // namespace proveout
