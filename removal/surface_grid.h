// The cells that the surface runs through: one vertex a cell and sheet.
//
// A cell belongs to the leaf of its lowest corner and has that corner's place. Inside a leaf, lengths are in
// grid steps from the leaf's first sample ("leaf units").
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "removal/cell_vertex.h"
#include "removal/stock_impl.h"

namespace proveout {

/// Vertex of a further sheet of a cell; the first sheet's is in the cell's own place.
struct ExtraVertex {
  std::uint16_t cell = 0;  ///< rank of the cell in its leaf
  std::uint8_t sheet = 1;
  Eigen::Vector3f p;  ///< leaf units
};

struct SurfaceLeaf {
  const StockLeaf* stock = nullptr;
  LeafEdges edges;
  LeafBits mixed{};                           ///< cells with surface
  std::array<std::uint16_t, 8> first_cell{};  ///< rank of the layer's first such cell
  /// Numbers of the leaves around, -1 where none: bit 0 of the place: one step along x, 1: y, 2: z.
  std::array<std::int32_t, 8> upper{}, lower{};
  std::uint32_t base = 0;        ///< vertex number of its first cell
  std::uint32_t extra_base = 0;  ///< vertex number of its first extra vertex
  std::vector<ExtraVertex> extra;
  std::vector<std::uint16_t> cramped;  ///< places of one-sheet cells whose faces meet outside the cell

  int rank(int x, int y, int z) const {
    return first_cell[z] + std::popcount(mixed[z] & ((1ull << leafBit(x, y)) - 1));
  }
};

/// Place in a leaf as one number.
inline constexpr int packPlace(int x, int y, int z) { return z << 6 | leafBit(x, y); }

/// A cell with surface, wherever it is.
struct CellAt {
  const SurfaceLeaf* leaf = nullptr;  ///< null: no surface there
  int rank = 0;
  Eigen::Vector3i shift = Eigen::Vector3i::Zero();  ///< origin of its leaf in the units of the asking leaf
};

class SurfaceGrid {
 public:
  explicit SurfaceGrid(const Stock::Impl& impl) : impl_(impl) {}

  /// Finds the cells and places their vertices. Stops early when cancelled.
  void build(Progress& progress);

  const Stock::Impl& impl() const { return impl_; }
  const std::vector<SurfaceLeaf>& leaves() const { return leaves_; }
  /// Vertices of leaves, first those of the cells, then the extra ones.
  std::size_t vertexCount() const { return vertices_.size(); }
  const Eigen::Vector3f& vertex(std::uint32_t number) const { return vertices_[number]; }
  /// Material corners of a cell as bits; see cell_cycles.h.
  std::uint8_t pattern(const CellAt& cell) const {
    return patterns_[cell.leaf->base + static_cast<std::uint32_t>(cell.rank)];
  }
  /// Cell at a place -1..8 of a leaf, with either no coordinate below 0 or none above 7.
  CellAt cellAt(const SurfaceLeaf& leaf, int x, int y, int z) const;
  std::uint32_t vertexNumber(const CellAt& cell, int sheet) const;
  /// The crossing of an edge that starts at a place 0..8 of a leaf, or null.
  const Crossing* crossingAt(const SurfaceLeaf& leaf, int axis, int x, int y, int z) const;

 private:
  struct Sheets;
  void linkLeaf(SurfaceLeaf& leaf, std::size_t number);
  void placeLeaf(SurfaceLeaf& leaf);
  void placeCell(SurfaceLeaf& leaf, int place, int pattern);
  void collectSheets(const SurfaceLeaf& leaf, int place, int pattern, Sheets& sheets) const;
  Box3 roomOf(const SurfaceLeaf& leaf, int x, int y, int z) const;
  void relaxLeaf(SurfaceLeaf& leaf);
  void numberExtras();

  const Stock::Impl& impl_;
  std::vector<SurfaceLeaf> leaves_;
  std::vector<Eigen::Vector3f> vertices_;
  std::vector<std::uint8_t> patterns_;  ///< a cell
  std::vector<std::uint8_t> smooth_;    ///< a cell: one smooth surface runs through it
};

}  // namespace proveout
