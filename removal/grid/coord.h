// Whole coordinates on the grid: of a voxel, or of a leaf (8 voxels each way).
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace proveout {

class Coord {
 public:
  constexpr Coord() = default;
  constexpr Coord(int x, int y, int z) : c_{x, y, z} {}

  constexpr int x() const { return c_[0]; }
  constexpr int y() const { return c_[1]; }
  constexpr int z() const { return c_[2]; }
  constexpr int operator[](int axis) const { return c_[static_cast<std::size_t>(axis)]; }
  constexpr int& operator[](int axis) { return c_[static_cast<std::size_t>(axis)]; }

  constexpr Coord offsetBy(int dx, int dy, int dz) const { return {c_[0] + dx, c_[1] + dy, c_[2] + dz}; }
  constexpr Coord offsetBy(int d) const { return offsetBy(d, d, d); }
  /// Clears the given bits of every coordinate: `& ~7` is the first voxel of the leaf.
  constexpr Coord operator&(int mask) const { return {c_[0] & mask, c_[1] & mask, c_[2] & mask}; }
  constexpr auto operator<=>(const Coord&) const = default;  ///< by x, then y, then z

 private:
  std::array<int, 3> c_{};
};

}  // namespace proveout
