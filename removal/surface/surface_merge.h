// Simplification: cells of flat patches share one vertex.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "removal/surface/surface_grid.h"

namespace proveout {

/// Merges the cells of cubes of 2 to 64 cells whose surface is flat. The merged vertex is one of those of the
/// cells, so that it is on the surface as they are.
class VertexMerger {
 public:
  /// `flatness`: as for SurfaceGrid; 0: nothing is merged.
  VertexMerger(SurfaceGrid& grid, double flatness) : grid_(grid), flatness_(flatness) {}

  bool active() const { return flatness_ > 0.0; }
  /// Merges whole leaves to larger cubes.
  void mergeLeaves();
  /// Chooses the vertex of each cube.
  void assign();
  /// The same where cubes were taken apart.
  void assign(const std::vector<std::int32_t>& leaves);
  /// The vertex that stands for a vertex. Requires assign.
  std::uint32_t standIn(std::uint32_t v) const { return v < count_ ? stand_in_[v] & ~kMerged : v; }
  /// Whether a vertex is one of several cells that are merged.
  bool merged(std::uint32_t v) const { return v < count_ && (stand_in_[v] & kMerged) != 0; }
  /// Takes the cubes of these cells apart to the next smaller ones. Adds the leaves that it changed, maybe
  /// repeatedly; call assign with them afterwards.
  void takeApart(std::vector<std::uint32_t> cells, std::vector<std::int32_t>& changed);
  /// Merges nothing any more. Call assign afterwards.
  void giveUp();

 private:
  static constexpr std::uint32_t kMerged = 0x80000000u;
  std::vector<std::int32_t> leavesOf(const LeafReader& read, const SurfaceLeaf& leaf, int level,
                                     int above) const;
  bool isFlat(const std::vector<std::int32_t>& leaves, int level) const;
  bool isDisk(const std::vector<std::int32_t>& leaves, int level) const;
  std::uint32_t middleOf(const std::vector<std::int32_t>& leaves) const;
  void assignLeaf(const SurfaceLeaf& leaf);
  void assignCube(const SurfaceLeaf& leaf, const CellCube& cube);

  SurfaceGrid& grid_;
  double flatness_;
  std::uint32_t count_ = 0;
  std::unique_ptr<std::uint32_t[]> stand_in_;  ///< a cell; kMerged: it shares its vertex
};

}  // namespace proveout
