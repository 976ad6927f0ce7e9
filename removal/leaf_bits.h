// The samples of a leaf as bits.
#pragma once

#include <array>
#include <cstdint>

namespace proveout {

/// The 8x8x8 samples of a leaf, true in material: one word a layer of z, bit x * 8 + y.
using LeafBits = std::array<std::uint64_t, 8>;
inline constexpr LeafBits kAllOutside{};
inline constexpr LeafBits kAllInside{~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull, ~0ull};
inline constexpr int leafBit(int x, int y) { return x * 8 + y; }
inline bool leafSample(const LeafBits& bits, int x, int y, int z) { return bits[z] >> leafBit(x, y) & 1; }

}  // namespace proveout
