// Bits of the samples around a leaf, shifted so that one word holds a corner of 64 cells.
#pragma once

#include <array>
#include <cstdint>

#include "removal/grid/stock_impl.h"

namespace proveout {

/// Samples of a leaf and of its seven upper neighbours (bit 0 of the place: x, 1: y, 2: z).
using BlockBits = std::array<const LeafBits*, 8>;

/// Samples of layer z (0..8) at (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1), bit leafBit(x, y).
inline std::array<std::uint64_t, 4> cornerLayer(const BlockBits& bits, int z) {
  const auto stepX = [](std::uint64_t own, std::uint64_t next) { return own >> 8 | next << 56; };
  const auto stepY = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 1 & 0x7F7F7F7F7F7F7F7Full) | (next & 0x0101010101010101ull) << 7;
  };
  const int up = z == 8 ? 4 : 0, layer = z & 7;
  const std::uint64_t own = (*bits[up])[layer], x = (*bits[up | 1])[layer], y = (*bits[up | 2])[layer],
                      xy = (*bits[up | 3])[layer];
  const std::uint64_t over = stepX(own, x);
  return {own, over, stepY(own, y), stepY(over, stepX(y, xy))};
}

/// Bits that are not the same in all of the words.
template <typename... Words>
std::uint64_t mixedBits(Words... words) {
  return (words | ...) & ~(words & ...);
}

/// Faces of cells, towards the next along x, y and z, that the surface crosses.
inline std::array<LeafBits, 3> crossedFaces(const BlockBits& bits) {
  std::array<LeafBits, 3> faces;
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    faces[0][z] = mixedBits(low[1], low[3], high[1], high[3]);
    faces[1][z] = mixedBits(low[2], low[3], high[2], high[3]);
    faces[2][z] = mixedBits(high[0], high[1], high[2], high[3]);
    low = high;
  }
  return faces;
}

}  // namespace proveout
