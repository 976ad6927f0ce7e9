// How much of a cell is material: exactly, and under the surface that its crossings make.
#pragma once

#include <optional>
#include <vector>

#include "removal/surface/mesh/surface_quads.h"
#include "removal/sweep/swept_field.h"

namespace proveout {

/// What a path leaves of its blank. Requires Stock::Impl::cut and cut_blank.
class CellMaterial {
 public:
  explicit CellMaterial(const Stock::Impl& impl) : impl_(impl) {}
  /// The part (0 to 1) of the cell with this lowest corner (mm) that is material, to about a thousandth: the
  /// cell is halved on all axes until only one face lies in a part, taken as a plane there, or the parts are
  /// small. None where no tool reached: the cell is as it was.
  std::optional<double> share(const Vec3& low);
  /// How often a body's distance was asked for; those of curves are weighted by what they cost.
  std::size_t asked() const { return asked_; }

 private:
  struct Part {
    Vec3 middle;
    double edge;  ///< mm
    int depth;
    bool at_blank;  ///< the blank's surface may be in it
  };
  double shareOf(Part part, std::size_t begin, std::size_t end);
  double cutByPlanes(const Part& part, std::size_t begin) const;

  const Stock::Impl& impl_;
  std::vector<SweptField> sweeps_;  ///< of the bodies that reach the cell
  std::vector<std::uint16_t>
      kept_;  ///< a stack: those that reach a part, those that reach the part around it, ...
  std::size_t asked_ = 0;
};

/// What StockSurface::volume_mm3 counts in a cell.
class CellUnderSurface {
 public:
  explicit CellUnderSurface(const SurfaceGrid& grid) : grid_(grid), read_(grid.impl()) {}
  /// Part of the cell's volume. Where vertices leave their cells it may be below 0 or above 1; the cells
  /// beside it make up for that.
  double share(const Coord& cell);

 private:
  using Corners = std::array<int, 4>;
  double wall(const Corners& corners, int axis, int side) const;
  double pieceAtWall(const Corners& corners, int from, int to, int axis, int side) const;
  double bulge(int edge) const;
  Vec3 crossing(int from, int to) const;
  Vec3 vertex(const Coord& cell, int edge, bool* smooth = nullptr) const;
  bool isIn(int corner) const { return (shape_ >> corner & 1) != 0; }

  const SurfaceGrid& grid_;
  LeafReader read_;
  Coord cell_;
  CellShape shape_ = 0;
};

}  // namespace proveout
