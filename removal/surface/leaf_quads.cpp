#include "removal/surface/leaf_quads.h"

#include <algorithm>

#include "core/base/assert.h"

namespace proveout {

Polygon polygonOf(const VertexMerger& merger, const std::array<std::uint32_t, 4>& v) {
  Polygon out;
  if (!merger.active()) {
    out.count = 4;
    out.v = v;
    return out;
  }
  for (const std::uint32_t corner : v) {
    const std::uint32_t s = merger.standIn(corner);
    if (out.count == 0 || (out.v[out.count - 1] != s && (out.count < 3 || out.v[0] != s)))
      out.v[out.count++] = s;
  }
  if (out.count > 1 && out.v[0] == out.v[out.count - 1]) --out.count;
  // Opposite corners that are one leave nothing between them.
  if (out.count == 4 && (out.v[0] == out.v[2] || out.v[1] == out.v[3])) out.count = 0;
  if (out.count == 3 && out.v[0] == out.v[2]) out.count = 0;
  if (out.count < 3) out.count = 0;
  return out;
}

std::optional<CornerLeaves> levelCorners(const SurfaceGrid& grid, const SurfaceLeaf& leaf) {
  if (!grid.isLevel(leaf, leaf.lower)) return std::nullopt;
  CornerLeaves corners;
  const int axis = leaf.level.axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  for (int i = 0; i < 4; ++i) {
    const int place = (kRing[i][0] ? u : 0) | (kRing[i][1] ? v : 0);
    corners[i] = &grid.leaves()[static_cast<std::size_t>(leaf.lower[place])];
    if (!corners[i]->all_level) return std::nullopt;
  }
  return corners;
}

bool QuadPlanner::anyMerged(const Quad& quad) const {
  return std::any_of(quad.v.begin(), quad.v.end(), [&](std::uint32_t v) { return merger_.merged(v); });
}

void QuadPlanner::add(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c,
                      const std::array<int, 4>& at, LeafQuads& out) const {
  PROVEOUT_ASSERT_DEAR(
      std::all_of(quad.v.begin(), quad.v.end(), [&](std::uint32_t v) { return v < grid_.vertexCount(); }));
  // To keep to the tolerance, such a quad is made of four triangles around its crossing.
  const bool bulged = bulges(quad, fan_height_);
  if (quad.split != 0 || (bulged && !anyMerged(quad))) {
    out.fans.push_back(splitQuad(grid_, leaf, at[0], at[1], at[2], at[3], quad, c));
    out.states.push_back(QuadState::kFan);
    return;
  }
  const int corners = polygonOf(merger_, quad.v).count;
  if (corners > 0) out.triangles += static_cast<std::uint32_t>(corners - 2);
  if (corners != 4 || anyMerged(quad)) {
    out.states.push_back(bulged ? QuadState::kMerged | QuadState::kBulged : QuadState::kMerged);
    return;
  }
  const QuadCut cut = cutQuad(quad.p, quad.middle, quad.normal, quad.smooth_corners);
  out.states.push_back(
      static_cast<std::uint8_t>((cut.at02 ? QuadState::kAt02 : 0) | (cut.poor ? QuadState::kPoor : 0)));
}

bool QuadPlanner::planLevel(const SurfaceLeaf& leaf, const CornerLeaves& corners, LeafQuads& out) const {
  std::array<std::uint32_t, 4> base;
  for (int i = 0; i < 4; ++i) {
    if (merger_.active() && !corners[i]->clusters.eight) return false;
    base[i] = corners[i]->base;
  }
  PROVEOUT_ASSERT(leaf.edges.count == 64);
  out.states.assign(64, merger_.active() ? QuadState::kMerged : QuadState::kAt02);
  out.triangles = 128;
  if (!merger_.active()) return true;
  // Four vertices stand for all; only where they meet is there anything left of a quad.
  if (!leaf.level.material_below) std::reverse(base.begin(), base.end());
  const int count = polygonOf(merger_, base).count;
  out.triangles = count > 0 ? static_cast<std::uint32_t>(count - 2) : 0;
  return true;
}

void QuadPlanner::plan(const SurfaceLeaf& leaf, LeafQuads& out) const {
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  out.triangles = 0;
  out.fans.clear();
  out.states.clear();
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    reader.read(axis, x, y, z, c, quad);
    add(leaf, quad, c, {axis, x, y, z}, out);
  });
  PROVEOUT_ASSERT(out.states.size() == leaf.stock->crossings.size());
}

}  // namespace proveout
