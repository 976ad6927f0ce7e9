// What goes through faces of cells whose four edges are all crossed.
#pragma once

#include "removal/grid/stock_impl.h"
#include "removal/surface/cell/cell_cycles.h"

namespace proveout {

/// Two opposite corners of such a face are in material, the others are not. Either the surface cuts off the
/// material corners singly, or material goes through between them and it cuts off the others. Crossings do
/// not show which; what cut the stock does, where that is known.
class FaceJoins {
 public:
  explicit FaceJoins(const Stock::Impl& impl);
  /// `at`: voxel of the cell's lowest corner; `pattern`: its material corners.
  CellShape shapeOf(const Coord& at, std::uint8_t pattern) const {
    const std::uint8_t doubtful = known_ ? doubtfulFaces()[pattern] : 0;
    return doubtful == 0 ? pattern : withJoins(at, pattern, doubtful);
  }

 private:
  CellShape withJoins(const Coord& at, std::uint8_t pattern, std::uint8_t doubtful) const;
  bool isJoined(const Coord& at, int axis, bool lowest_in) const;
  bool isSwept(const Vec3& p) const;
  bool isMaterial(const Vec3& p) const;

  const Stock::Impl& impl_;
  bool known_;
};

}  // namespace proveout
