// Judges what merging cells makes of quads, before any triangle is written.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "removal/surface/mesh/leaf_quads.h"

namespace proveout {

class MergeJudge {
 public:
  /// Both must outlive this.
  MergeJudge(const SurfaceGrid& grid, const VertexMerger& merger);

  /// Merged cells that spoil a quad in these leaves (a flag for each): its triangles face the wrong way or
  /// are off the surface that there was, or it should be a fan. In the order of the leaves; a cell may come
  /// several times. Empty when cancelled.
  std::vector<std::uint32_t> faults(const std::vector<LeafQuads>& quads,
                                    const std::vector<std::uint8_t>& changed, Progress& progress) const;

 private:
  void judgeLeaf(const SurfaceLeaf& leaf, const LeafQuads& quads, std::vector<std::uint32_t>& faults) const;

  const SurfaceGrid& grid_;
  const VertexMerger& merger_;
  double reach_;  ///< how far merged triangles may be off the corners that there were, mm
};

}  // namespace proveout
