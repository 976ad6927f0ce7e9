// The samples of a leaf as bits.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace proveout {

/// The 8x8x8 samples of a leaf, true in material: one word a layer of z, bit x * 8 + y.
using LeafBits = std::array<std::uint64_t, 8>;
inline constexpr LeafBits kAllOutside{};
inline constexpr LeafBits kAllInside{~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull};
/// Of a layer, the samples of the first and of the last place in x and in y.
inline constexpr std::uint64_t kColumnX0 = 0xFF, kColumnX7 = kColumnX0 << 56;
inline constexpr std::uint64_t kColumnY0 = 0x0101010101010101ull, kColumnY7 = kColumnY0 << 7;
inline constexpr int leafBit(int x, int y) { return x * 8 + y; }
/// Bits that are set. std::popcount calls a function of the compiler's library where the processor that is
/// compiled for is not known to have an instruction for it.
inline int countBits(std::uint64_t bits) {
#if defined(__POPCNT__) || !defined(__x86_64__)
  return std::popcount(bits);
#else
  bits -= bits >> 1 & 0x5555555555555555ull;
  bits = (bits & 0x3333333333333333ull) + (bits >> 2 & 0x3333333333333333ull);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0Full;
  return static_cast<int>(bits * 0x0101010101010101ull >> 56);
#endif
}
inline bool leafSample(const LeafBits& bits, int x, int y, int z) { return bits[z] >> leafBit(x, y) & 1; }

}  // namespace proveout
