#include "removal/surface/mesh/leaf_quads.h"

#include <algorithm>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// Four triangles are made only where the crossing is off by more than this many times what the quad's edges
/// are. They keep these edges: where both are off alike, as on a cylinder, four triangles are no better than
/// two, and make ridges across what is straight.
constexpr double kFanGain = 1.5;

/// The crossing of the same face on a neighbouring edge, a `step` along `axis`: on the edge at the same
/// level or next to it. Sets where it is as seen from this one. Null where there is none in this leaf.
const Crossing* crossingBeside(const SurfaceLeaf& leaf, const Crossing& c, const std::array<int, 4>& at,
                               int axis, int step, Vec3& d) {
  for (const int up : {0, -1, 1}) {
    std::array<int, 4> next = at;
    const int aside = next[1 + axis] += step, along = next[1 + at[0]] += up;
    if (aside < 0 || aside > 7 || along < 0 || along > 7) continue;
    if (!leaf.edges.isCrossed(next[0], next[1], next[2], next[3])) continue;
    const auto index = static_cast<std::size_t>(leaf.edges.indexOf(next[0], next[1], next[2], next[3]));
    const Crossing& beside = leaf.stock->crossings[index];
    if (beside.face() != c.face()) continue;
    d = Vec3::Zero();
    d[axis] = step;
    d[at[0]] = up + static_cast<double>(beside.t) - static_cast<double>(c.t);
    return &beside;
  }
  return nullptr;
}

/// How far the surface is off a chord, given the square of its length, by how much the surface turns from
/// one crossing to another at `d`.
double offChord(const Crossing& from, const Crossing& to, const Vec3& d, double length2) {
  Vec3 turn;
  for (int i = 0; i < 3; ++i) turn[i] = to.normal[i] - from.normal[i];
  return std::abs(turn.dot(d)) / (Crossing::kNormalScale * d.squaredNorm()) * length2 / 8.0;
}

/// At most how far the surface is off the edges of a quad on one smooth face, where it is `off` at the
/// crossing, at which the bends in both directions add up. 0 where nothing is known.
double edgesOff(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c, const std::array<int, 4>& at,
                double off) {
  double most = 0.0;
  for (int i = 0; i < 2; ++i) {
    const int axis = (at[0] + 1 + i) % 3;  // sides i and i + 2 run along it
    const double length2 = std::max((quad.p[i + 1] - quad.p[i]).squaredNorm(),
                                    (quad.p[(i + 3) % 4] - quad.p[i + 2]).squaredNorm());
    for (const int step : {-1, 1}) {
      Vec3 d;
      const Crossing* beside = crossingBeside(leaf, c, at, axis, step, d);
      if (beside == nullptr) continue;
      const double here = offChord(c, *beside, d, length2);
      most = std::max({most, here, off - here});
    }
  }
  return most;
}

}  // namespace

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
  // Opposite corners with the same vertex leave nothing between them.
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

/// Whether two triangles are too far off the surface and four around the crossing are closer to it.
bool QuadPlanner::bulges(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c,
                         const std::array<int, 4>& at) const {
  // Which steps can be opened and which sheets parted must not depend on the tolerance.
  constexpr std::uint16_t kDetails = CellTraits::kStep | CellTraits::kManySheets | CellTraits::kClose;
  const bool at_detail = (quad.traits & kDetails) != 0;
  const double off = bulgeOver(quad, at_detail ? kFanHeight : fan_height_);
  return off > 0.0 && (quad.smooth_corners != 0xF || off > kFanGain * edgesOff(leaf, quad, c, at, off));
}

void QuadPlanner::add(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c,
                      const std::array<int, 4>& at, LeafQuads& out) const {
  PROVEOUT_ASSERT_DEAR(
      std::all_of(quad.v.begin(), quad.v.end(), [&](std::uint32_t v) { return v < grid_.vertexCount(); }));
  // To keep to the tolerance, such a quad is made of four triangles around its crossing.
  const bool bulged = bulges(leaf, quad, c, at);
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
  // Four vertices stand for all cells; a quad is left only where they meet.
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
