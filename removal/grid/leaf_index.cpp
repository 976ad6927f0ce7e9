#include "removal/grid/leaf_index.h"

namespace proveout {

namespace {

Coord firstOfBlock(const Coord& leaf) { return leaf & ~7; }

}  // namespace

void LeafIndex::reset(const Coord& low, const Coord& high) {
  low_ = firstOfBlock(low);
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    size_[static_cast<std::size_t>(axis)] = (firstOfBlock(high)[axis] - low_[axis]) / 8 + 1;
    count *= static_cast<std::size_t>(size_[static_cast<std::size_t>(axis)]);
  }
  blocks_.assign(count, kOutside);
  cells_.clear();
}

double LeafIndex::bytesFor(const Coord& low, const Coord& high) {
  double count = 1.0;
  for (int axis = 0; axis < 3; ++axis) count *= (high[axis] - low[axis]) / 8.0 + 2.0;
  return count * sizeof(std::int32_t);
}

void LeafIndex::set(const Coord& leaf, std::int32_t value) {
  std::int32_t& block = blocks_[static_cast<std::size_t>(blockOf(leaf))];
  if (block < 0 && block == value) return;
  if (block < 0) {
    cells_.emplace_back().fill(block);
    block = static_cast<std::int32_t>(cells_.size() - 1);
  }
  cells_[static_cast<std::size_t>(block)][cellOf(leaf)] = value;
}

void LeafIndex::fill(const Coord& low, const Coord& high, std::int32_t value) {
  for (int x = low.x(); x <= high.x(); x = (x | 7) + 1) {
    for (int y = low.y(); y <= high.y(); y = (y | 7) + 1) {
      for (int z = low.z(); z <= high.z(); z = (z | 7) + 1) {
        const Coord first(x, y, z);
        const Coord last(std::min(x | 7, high.x()), std::min(y | 7, high.y()), std::min(z | 7, high.z()));
        const std::int64_t at = blockOf(first);
        if (at < 0) continue;
        if (first == firstOfBlock(first) && last == first.offsetBy(7)) {
          blocks_[static_cast<std::size_t>(at)] = value;
          continue;
        }
        for (int i = first.x(); i <= last.x(); ++i) {
          for (int j = first.y(); j <= last.y(); ++j) {
            for (int k = first.z(); k <= last.z(); ++k) set(Coord(i, j, k), value);
          }
        }
      }
    }
  }
}

}  // namespace proveout
