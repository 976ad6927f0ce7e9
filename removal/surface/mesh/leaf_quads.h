// What becomes of the quads of a leaf: two triangles, a fan, or what merging leaves of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "removal/surface/mesh/surface_merge.h"
#include "removal/surface/mesh/surface_quads.h"
#include "removal/surface/mesh/surface_splits.h"

namespace proveout {

/// What is known of a quad: how it is cut, if its corners stand for themselves; or that its corners are
/// merged, so that it is judged where they ended up; or that it is a fan.
struct QuadState {
  static constexpr std::uint8_t kAt02 = 1;  ///< cut from corner 0 to 2
  static constexpr std::uint8_t kPoor = 2;  ///< see QuadCut::poor
  static constexpr std::uint8_t kMerged = 4;
  static constexpr std::uint8_t kFan = 8;
  static constexpr std::uint8_t kBulged = 16;  ///< it should be a fan, but its corners are merged
};

/// The quads of a leaf.
struct LeafQuads {
  std::uint32_t triangles = 0;       ///< of all that are not fans
  std::vector<std::uint8_t> states;  ///< see QuadState; one a crossing, in their order
  std::vector<SplitQuad> fans;       ///< in the order of their crossings
};

/// A quad's corners after merging, without repeats.
struct Polygon {
  int count = 0;  ///< 0, where nothing is left of it, 3 or 4
  std::array<std::uint32_t, 4> v;
};
Polygon polygonOf(const VertexMerger& merger, const std::array<std::uint32_t, 4>& v);

/// The four leaves that the corners of a leaf's quads are in, in the order of kRing.
using CornerLeaves = std::array<const SurfaceLeaf*, 4>;
/// Those of a leaf whose quads are all of one level face, with the vertices in the middle of their cells.
std::optional<CornerLeaves> levelCorners(const SurfaceGrid& grid, const SurfaceLeaf& leaf);

/// Decides what becomes of quads, as cells are merged now.
class QuadPlanner {
 public:
  /// `fan_height`: how far a crossing may be off two triangles, grid steps. Both must outlive this.
  QuadPlanner(const SurfaceGrid& grid, const VertexMerger& merger, double fan_height)
      : grid_(grid), merger_(merger), fan_height_(fan_height) {}

  /// Plans all quads of a leaf, in place of what `out` has.
  void plan(const SurfaceLeaf& leaf, LeafQuads& out) const;
  /// Plans the quads of a level leaf as a whole. False, and nothing is planned, unless all or none of them
  /// are merged.
  bool planLevel(const SurfaceLeaf& leaf, const CornerLeaves& corners, LeafQuads& out) const;
  /// Adds the quad of the next crossing, on the edge `at` (axis, x, y, z).
  void add(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c, const std::array<int, 4>& at,
           LeafQuads& out) const;

 private:
  bool anyMerged(const Quad& quad) const;
  bool bulges(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c,
              const std::array<int, 4>& at) const;

  const SurfaceGrid& grid_;
  const VertexMerger& merger_;
  double fan_height_;
};

}  // namespace proveout
