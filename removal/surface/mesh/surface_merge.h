// Simplification: cells of flat patches share one vertex.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "removal/surface/cell/surface_grid.h"

namespace proveout {

/// Merges the cells of cubes of 2 to 64 cells whose surface is flat. The merged vertex is one of those of the
/// cells, so that it is on the surface as they are.
class VertexMerger {
 public:
  /// Merges what may be merged. `grid`: built, its folds repaired; it must outlive this. `flatness`: as for
  /// SurfaceGrid; 0: nothing is merged.
  VertexMerger(SurfaceGrid& grid, double flatness);

  bool active() const { return flatness_ > 0.0; }
  double flatness() const { return flatness_; }
  /// The vertex that stands for a vertex.
  std::uint32_t standIn(std::uint32_t v) const { return v < count_ ? stand_in_[v] & ~kMerged : v; }
  /// Whether a vertex is one of several cells that are merged.
  bool merged(std::uint32_t v) const { return v < count_ && (stand_in_[v] & kMerged) != 0; }
  /// Takes the cubes of these cells apart to the next smaller ones. Returns the leaves that it changed,
  /// ascending.
  std::vector<std::int32_t> takeApart(std::vector<std::uint32_t> cells);
  /// Merges nothing any more. Returns all leaves.
  std::vector<std::int32_t> giveUp();

 private:
  static constexpr std::uint32_t kMerged = 0x80000000u;
  std::vector<std::int32_t> leavesOf(const LeafReader& read, const SurfaceLeaf& leaf, int level,
                                     int above) const;
  bool isLevelSquare(const std::vector<std::int32_t>& leaves, int level) const;
  bool isFlat(const std::vector<std::int32_t>& leaves, int level) const;
  bool isDisk(const std::vector<std::int32_t>& leaves, int level) const;
  std::uint32_t middleOf(const std::vector<std::int32_t>& leaves) const;
  void mergeLeaves();
  void assign(const std::vector<std::int32_t>& leaves);
  std::vector<std::int32_t> allLeaves() const;
  bool standForThemselves() const;
  bool takeCellApart(std::size_t leaf, int place, std::vector<std::int32_t>& changed);
  void partAroundDetails();
  void partAround(const SurfaceLeaf& leaf, int place);
  void assignLeaf(const SurfaceLeaf& leaf);
  void assignCube(const SurfaceLeaf& leaf, const CellCube& cube);

  SurfaceGrid& grid_;
  double flatness_;
  std::uint32_t count_ = 0;
  std::unique_ptr<std::uint32_t[]> stand_in_;  ///< a cell; kMerged: it shares its vertex
};

}  // namespace proveout
