// What every leaf of the stock is: outside, inside, or crossed by the surface and then which record. A grid
// of blocks of 8x8x8 leaves; a block that is all one side takes one number.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "removal/grid/coord.h"

namespace proveout {

class LeafIndex {
 public:
  static constexpr std::int32_t kOutside = -1, kInside = -2;

  /// Room for leaves low..high (leaf coordinates, both included); everything is outside.
  void reset(const Coord& low, const Coord& high);

  /// Number of the leaf's record (>= 0), kInside or kOutside; kOutside beyond the room.
  std::int32_t get(const Coord& leaf) const {
    const std::int64_t at = blockOf(leaf);
    if (at < 0) return kOutside;
    const std::int32_t block = blocks_[static_cast<std::size_t>(at)];
    return block < 0 ? block : cells_[static_cast<std::size_t>(block)][cellOf(leaf)];
  }
  bool holds(const Coord& leaf) const { return blockOf(leaf) >= 0; }
  /// Requires a leaf within the room.
  void set(const Coord& leaf, std::int32_t value);
  /// All leaves low..high within the room (both included).
  void fill(const Coord& low, const Coord& high, std::int32_t value);

  /// Calls body(low, high) for boxes of leaves that together hold every leaf of the given uniform value.
  template <typename Body>
  void forEachBox(std::int32_t value, Body&& body) const {
    for (int x = 0; x < size_[0]; ++x) {
      for (int y = 0; y < size_[1]; ++y) {
        for (int z = 0; z < size_[2]; ++z) {
          const std::int32_t block = blocks_[number(x, y, z)];
          const Coord first = low_.offsetBy(8 * x, 8 * y, 8 * z);
          if (block == value) body(first, first.offsetBy(7));
          if (block < 0) continue;
          for (int i = 0; i < 512; ++i) {
            const Coord leaf = first.offsetBy(i >> 6, i >> 3 & 7, i & 7);
            if (cells_[static_cast<std::size_t>(block)][static_cast<std::size_t>(i)] == value)
              body(leaf, leaf);
          }
        }
      }
    }
  }

  /// Bytes that room of this many leaves each way would take before any block is split.
  static double bytesFor(const Coord& low, const Coord& high);

 private:
  static std::size_t cellOf(const Coord& leaf) {
    return static_cast<std::size_t>((leaf.x() & 7) << 6 | (leaf.y() & 7) << 3 | (leaf.z() & 7));
  }
  std::size_t number(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(z);
  }
  std::int64_t blockOf(const Coord& leaf) const {
    const int x = (leaf.x() - low_.x()) >> 3, y = (leaf.y() - low_.y()) >> 3, z = (leaf.z() - low_.z()) >> 3;
    if (x < 0 || y < 0 || z < 0 || x >= size_[0] || y >= size_[1] || z >= size_[2]) return -1;
    return static_cast<std::int64_t>(number(x, y, z));
  }

  Coord low_;                  ///< a multiple of 8
  std::array<int, 3> size_{};  ///< blocks each way
  std::vector<std::int32_t> blocks_;
  std::vector<std::array<std::int32_t, 512>> cells_;
};

}  // namespace proveout
