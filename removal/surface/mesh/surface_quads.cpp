#include "removal/surface/mesh/surface_quads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "removal/surface/cell/cell_cycles.h"

namespace proveout {

namespace {

/// Triangles that lean more than this (84 degrees, cosine) from the exact surface count as folded. Where a
/// corner is off the tangent plane by more than kOffPlane of the size, a feature edge may turn the surface
/// there, by up to 143 degrees.
constexpr double kFolded = 0.3;
constexpr double kFoldedAtFeature = -0.3;
constexpr double kOffPlane = 0.15;
/// Where a diagonal runs along a feature edge the surface may turn by up to 134 degrees there.
constexpr double kFoldedOverFeature = -0.7;
/// Diagonals whose middles are off the tangent plane alike, by this part of their length.
constexpr double kAlikeOff = 1e-3;
/// A triangle lower than this part of its length, as of three points on one edge, may be turned over by
/// rounding: it is cut only if the other cut is folded.
constexpr double kSliver = 1e-3;
constexpr double kSliverMargin = 1e-6;
constexpr double kPoorFacing = 0.5;
/// Where corners are farther off the tangent plane than this many times what crossings may be, there is a
/// feature edge: two triangles and four then differ by more than the tolerance, however near the crossing
/// is.
constexpr double kFeatureHeight = 2.0;
constexpr int kFoldRounds = 8;

}  // namespace

QuadCut cutQuad(const std::array<Vec3, 4>& p, const Vec3& middle, const Vec3& normal,
                unsigned smooth_corners) {
  const bool smooth = smooth_corners == 0xF;
  std::array<double, 4> up;
  for (int i = 0; i < 4; ++i) up[i] = normal.dot(p[i] - middle);
  const double off02 = std::abs(up[0] + up[2]), off13 = std::abs(up[1] + up[3]);
  const double length02 = (p[2] - p[0]).squaredNorm(), length13 = (p[3] - p[1]).squaredNorm();
  const double alike = kAlikeOff * std::sqrt(std::max(length02, length13));
  const bool prefer02 = std::abs(off02 - off13) > alike ? off02 < off13 : length02 <= length13;
  // How far each triangle is from being folded: its facing over what its slope allows.
  struct Cut {
    double margin = 2.0;
    bool poor = false;
  };
  const auto add = [&](Cut& cut, int a, int b, int c, bool over_feature) {
    const Vec3 area = (p[b] - p[a]).cross(p[c] - p[a]);
    double facing = normal.dot(area), margin = facing > 0.0 ? 1.0 : -1.0;
    bool poor = facing <= 0.0;
    if (!smooth) {
      const double length = area.norm();
      const double size2 = std::max((p[b] - p[a]).squaredNorm(), (p[c] - p[b]).squaredNorm());
      const double high = std::max({std::abs(up[a]), std::abs(up[b]), std::abs(up[c])});
      facing = length > 0.0 ? facing / length : -1.0;
      const bool off_plane = high * high > kOffPlane * kOffPlane * size2;
      margin = facing - (over_feature ? kFoldedOverFeature : off_plane ? kFoldedAtFeature : kFolded);
      const bool sliver = length < kSliver * size2;
      if (sliver) margin = std::min(margin, kSliverMargin);
      poor = sliver || facing < kPoorFacing;
    }
    cut.margin = std::min(cut.margin, margin);
    cut.poor = cut.poor || poor;
  };
  const auto cutAt = [&](bool at02) {
    Cut cut;
    const bool along_feature = smooth_corners == (at02 ? 0xAu : 0x5u);
    add(cut, 0, 1, at02 ? 2 : 3, along_feature);
    add(cut, at02 ? 0 : 1, 2, 3, along_feature);
    return cut;
  };
  const Cut preferred = cutAt(prefer02);
  if (preferred.margin > kSliverMargin) return {prefer02, preferred.margin, preferred.poor};
  const Cut other = cutAt(!prefer02);
  if (other.margin > preferred.margin) return {!prefer02, other.margin, other.poor};
  return {prefer02, preferred.margin, preferred.poor};
}

double bulgeOver(const Quad& quad, double limit) {
  std::array<Vec3, 4> d;
  double highest = 0.0;
  for (int i = 0; i < 4; ++i) {
    d[i] = quad.p[i] - quad.middle;
    highest = std::max(highest, std::abs(quad.normal.dot(d[i])));
  }
  if (highest > kFeatureHeight * limit) limit = kFanHeight;
  // Opposite corners on a feature edge are joined.
  if (highest <= limit || (~quad.smooth_corners & 0x5) == 0x5 || (~quad.smooth_corners & 0xA) == 0xA)
    return 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 area = d[i].cross(d[(i + 1) % 4]);
    if (quad.normal.dot(area) <= kFolded * area.norm()) return 0.0;
  }
  const int first = cutQuad(quad.p, quad.middle, quad.normal, quad.smooth_corners).at02 ? 0 : 1;
  const Vec3 &a = d[first], &b = d[first + 2];
  const Vec3& third =
      quad.normal.dot(a.cross(b)) > 0.0 ? d[(first + 3) % 4] : d[first + 1];  // on the crossing's side
  const Vec3 n = (b - a).cross(third - a);
  const double off = std::abs(n.dot(a)), length = n.norm();
  return off > limit * length ? off / length : 0.0;
}

void QuadReader::add(const SurfaceLeaf& leaf, int place) {
  const int dx = (place & 1) * 8, dy = (place >> 1 & 1) * 8, dz = (place >> 2) * 8;
  const std::uint64_t columns = (dx != 0 ? kColumnX7 : ~0ull) & (dy != 0 ? kColumnY7 : ~0ull);
  const Eigen::Vector3f shift(toFloat(-dx), toFloat(-dy), toFloat(-dz));
  for (int z = dz != 0 ? 7 : 0; z < 8; ++z) {
    const std::uint64_t mixed = leaf.mixed[z];
    for (std::uint64_t rest = mixed & columns; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const int rank = leaf.first_cell[z] + countBits(mixed & ((1ull << bit) - 1));
      const std::uint32_t cell = leaf.base + static_cast<std::uint32_t>(rank);
      const int i = index((bit >> 3) - dx, (bit & 7) - dy, z - dz);
      number_[i] = cell;
      traits_[i] = grid_.traits(cell);
      p_[i] = grid_.vertex(cell) + shift;
    }
  }
}

/// Calls use(leaf, place) for the leaf and those below it that cells of its quads are in.
template <typename Use>
void QuadReader::forEachLeaf(const Use& use) const {
  use(*leaf_, 0);
  for (int i = 1; i < 7; ++i) {
    if (leaf_->lower[i] >= 0) use(grid_.leaves()[static_cast<std::size_t>(leaf_->lower[i])], i);
  }
}

void QuadReader::load(const SurfaceLeaf& leaf) {
  leaf_ = &leaf;
  number_.fill(kNoCell);
  forEachLeaf([this](const SurfaceLeaf& from, int place) { add(from, place); });
}

void QuadReader::addFeatureEdges(const SurfaceLeaf& leaf, int place) {
  const int dx = (place & 1) * 8, dy = (place >> 1 & 1) * 8, dz = (place >> 2) * 8;
  for (const FeatureEdgeDirection& c : leaf.feature_edges) {
    const int x = (c.place >> 3 & 7) - dx, y = (c.place & 7) - dy, z = (c.place >> 6) - dz;
    if (std::min({x, y, z}) < -1) continue;
    const int i = index(x, y, z);
    if (c.outside && (traits_[i] & CellTraits::kOutside) == 0) continue;
    feature_edges_.push_back(c.along);
    feature_edge_at_[i] = static_cast<std::uint16_t>(feature_edges_.size());
  }
}

void QuadReader::loadFeatureEdges() {
  feature_edges_.clear();
  feature_edge_at_.fill(0);
  forEachLeaf([this](const SurfaceLeaf& from, int place) { addFeatureEdges(from, place); });
}

std::array<Vec3, 4> QuadReader::featureEdgesOf(const Quad& quad, int axis, int x, int y, int z) const {
  std::array<Vec3, 4> along;
  along.fill(Vec3::Zero());
  if (feature_edges_.empty() || quad.smooth_corners == 0xF) return along;
  const std::array<int, 4> cell = ring(axis, x, y, z);
  const bool start_in = leafSample(leaf_->stock->material(), x, y, z);
  for (int i = 0; i < 4; ++i) {
    const int number = feature_edge_at_[cell[start_in ? i : 3 - i]];
    if (number > 0) along[i] = feature_edges_[number - 1].cast<double>();
  }
  return along;
}

std::array<int, 4> QuadReader::ring(int axis, int x, int y, int z) {
  constexpr int kStep[3] = {81, 9, 1};
  const int u = kStep[(axis + 1) % 3], v = kStep[(axis + 2) % 3], at = index(x, y, z);
  return {at - u - v, at - v, at, at - u};
}

bool QuadReader::cells(int axis, int x, int y, int z, Quad& quad) const {
  const std::array<int, 4> cell = ring(axis, x, y, z);
  quad.traits = 0;
  quad.smooth_corners = 0;
  for (int i = 0; i < 4; ++i) {
    quad.v[i] = number_[cell[i]];
    if (quad.v[i] == kNoCell) return false;
    quad.traits |= traits_[cell[i]];
    if (traits_[cell[i]] & CellTraits::kSmooth) quad.smooth_corners |= static_cast<std::uint8_t>(1 << i);
  }
  return true;
}

bool QuadReader::read(int axis, int x, int y, int z, const Crossing& c, Quad& quad) const {
  if (!cells(axis, x, y, z, quad)) return false;
  const std::array<int, 4> cell = ring(axis, x, y, z);
  for (int i = 0; i < 4; ++i) quad.p[i] = p_[cell[i]].cast<double>();
  arrange(axis, x, y, z, quad);
  readCrossing(axis, x, y, z, c, quad);
  return true;
}

void QuadReader::readCorners(int axis, int x, int y, int z, Quad& quad) const {
  cells(axis, x, y, z, quad);
  arrange(axis, x, y, z, quad);
}

/// Takes the sheets that the edge belongs to, and brings the corners into the quad's order.
void QuadReader::arrange(int axis, int x, int y, int z, Quad& quad) const {
  quad.split = 0;
  const bool start_in = leafSample(leaf_->stock->material(), x, y, z);
  if ((quad.traits & (CellTraits::kManySheets | CellTraits::kOneSheetFaces | CellTraits::kWalled)) != 0) {
    pickSheets(axis, x, y, z, start_in, quad);
  }
  if (!start_in) {
    std::swap(quad.v[0], quad.v[3]);
    std::swap(quad.v[1], quad.v[2]);
    std::swap(quad.p[0], quad.p[3]);
    std::swap(quad.p[1], quad.p[2]);
    const unsigned s = quad.smooth_corners;
    quad.smooth_corners = static_cast<std::uint8_t>(s >> 3 | (s >> 1 & 2) | (s << 1 & 4) | (s << 3 & 8));
  }
}

void QuadReader::readCrossing(int axis, int x, int y, int z, const Crossing& c, Quad& quad) {
  quad.middle = Vec3(x, y, z);
  quad.middle[axis] += c.t;
  constexpr double kUnit = 1.0 / Crossing::kNormalScale;
  quad.normal = Vec3(c.normal[0], c.normal[1], c.normal[2]) * kUnit;
}

/// Further sheets of the cells, and faces whose two dual edges would coincide. Corners are still in the order
/// of kRing; the bits of `split` are in the quad's order.
void QuadReader::pickSheets(int axis, int x, int y, int z, bool start_in, Quad& quad) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<int, 4> corner;
  std::array<std::uint8_t, 4> faces;
  std::array<bool, 4> walled;
  for (int i = 0; i < 4; ++i) {
    corner[i] = kRing[i][0] << u | kRing[i][1] << v;
    const std::uint32_t cell = quad.v[i];
    faces[i] = oneSheetFaces(grid_.shape(cell));
    walled[i] = (grid_.traits(cell) & CellTraits::kWalled) != 0;
    if (!(grid_.traits(cell) & CellTraits::kManySheets)) continue;
    const int sheet = cellCycles(grid_.shape(cell)).cycle_of_edge[edgeAt(axis, corner[i])];
    if (sheet <= 0) continue;
    Eigen::Vector3i at(x, y, z);
    at[u] -= kRing[i][0];
    at[v] -= kRing[i][1];
    const int below = (at.x() < 0) | (at.y() < 0) << 1 | (at.z() < 0) << 2;
    const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(leaf_->lower[below])];
    const auto it = std::find_if(leaf.extra.begin(), leaf.extra.end(), [&](const ExtraVertex& e) {
      return e.cell == cell - leaf.base && e.sheet == sheet;
    });
    PROVEOUT_ASSERT(it != leaf.extra.end());
    quad.v[i] = leaf.extra_base + static_cast<std::uint32_t>(it - leaf.extra.begin());
    const Eigen::Vector3f shift(at.x() < 0 ? -8.0f : 0.0f, at.y() < 0 ? -8.0f : 0.0f,
                                at.z() < 0 ? -8.0f : 0.0f);
    quad.p[i] = (it->p + shift).cast<double>();
  }
  for (int i = 0; i < 4; ++i) {
    // Cells i and i + 1 share the face across `cross`.
    const int j = (i + 1) % 4, cross = kRing[i][0] != kRing[j][0] ? u : v;
    const int side = corner[i] >> cross & 1;
    const bool touch = faces[i] >> (cross * 2 + side) & faces[j] >> (cross * 2 + 1 - side) & 1;
    if (touch || walled[i] || walled[j]) {
      quad.split |= static_cast<std::uint8_t>(1 << (start_in ? i : (6 - i) % 4));
    }
  }
}

namespace {

/// Places of cells (see OutsideVertex), leaf by leaf.
using Places = std::vector<std::vector<std::uint16_t>>;

/// Crossed edges of a leaf, on each axis, at these cells.
std::array<LeafBits, 3> edgesOf(const Places& cells, const SurfaceLeaf& leaf) {
  std::array<LeafBits, 3> edges{};
  const auto mark = [&](int axis, int x, int y, int z) {
    if ((x | y | z) >= 0 && x < 8 && y < 8 && z < 8) edges[axis][z] |= 1ull << leafBit(x, y);
  };
  for (int below = 0; below < 7; ++below) {
    if (leaf.lower[below] < 0) continue;
    const int dx = (below & 1) * 8, dy = (below >> 1 & 1) * 8, dz = (below >> 2) * 8;
    for (const int place : cells[static_cast<std::size_t>(leaf.lower[below])]) {
      const int x = (place >> 3 & 7) - dx, y = (place & 7) - dy, z = (place >> 6) - dz;
      for (int i = 0; i < 4; ++i) {
        const int u = i & 1, v = i >> 1;
        mark(0, x, y + u, z + v);
        mark(1, x + u, y, z + v);
        mark(2, x + u, y + v, z);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z < 8; ++z) edges[axis][z] &= leaf.edges.crossed[axis][z];
  }
  return edges;
}

/// Where a vertex goes if it is put back into its cell, in the units of `leaf`.
Vec3 insideOf(const SurfaceGrid& grid, std::uint32_t cell, const SurfaceLeaf& leaf) {
  const SurfaceLeaf& own = grid.leaves()[grid.leafOf(cell)];
  const auto it =
      std::ranges::find_if(own.outside, [&](const OutsideVertex& o) { return own.cellAt(o.place) == cell; });
  PROVEOUT_ASSERT(it != own.outside.end());
  const Coord to = own.stock->origin, from = leaf.stock->origin;
  return it->inside.cast<double>() + Vec3(to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
}

bool folds(const Quad& quad) {
  const unsigned smooth = quad.smooth_corners == 0xF ? 0u : quad.smooth_corners;
  return cutQuad(quad.p, quad.middle, quad.normal, smooth).margin <= 0.0;
}

/// Of the vertices at corners of a quad that folds, the one that repairs the fold if it alone is put back;
/// -1 if there is none. Of several, the one nearest to another corner, which is on the same feature edge.
int cornerThatRepairsFold(const SurfaceGrid& grid, const SurfaceLeaf& leaf, const Quad& quad,
                          std::span<const int> corners) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int i : corners) {
    Quad without = quad;
    without.p[i] = insideOf(grid, quad.v[i], leaf);
    if (folds(without)) continue;
    for (int j = 0; j < 4; ++j) {
      const double distance2 = (quad.p[j] - quad.p[i]).squaredNorm();
      if (j == i || distance2 >= least) continue;
      least = distance2;
      best = i;
    }
  }
  return best;
}

/// The vertices outside their cells at quads of a leaf, around these cells, that fold: one of each quad
/// where that is enough, otherwise all.
std::vector<std::uint32_t> foldingVertices(const SurfaceGrid& grid, const SurfaceLeaf& leaf,
                                           const Places& cells) {
  std::vector<std::uint32_t> folding;
  LeafEdges asked;
  asked.crossed = edgesOf(cells, leaf);
  if (asked.crossed == std::array<LeafBits, 3>{}) return folding;
  QuadReader reader(grid);
  reader.load(leaf);
  forEachEdge(asked, [&](int axis, int x, int y, int z) {
    Quad quad;
    if (!reader.cells(axis, x, y, z, quad) || !(quad.traits & CellTraits::kOutside)) return;
    const Crossing& c = leaf.stock->crossings[static_cast<std::size_t>(leaf.edges.indexOf(axis, x, y, z))];
    reader.read(axis, x, y, z, c, quad);
    if (!folds(quad)) return;
    std::vector<int> corners;
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t v = quad.v[i];
      if (v < grid.cellCount() && (grid.traits(v) & CellTraits::kOutside) != 0) corners.push_back(i);
    }
    const int one = corners.size() > 1 ? cornerThatRepairsFold(grid, leaf, quad, corners) : -1;
    if (one >= 0) corners = {one};
    for (const int i : corners) folding.push_back(quad.v[i]);
  });
  return folding;
}

}  // namespace

void repairFolds(SurfaceGrid& grid) {
  auto& leaves = grid.leaves();
  // First all that are outside, then those that were put back: other quads stay as they are.
  Places moved(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (const OutsideVertex& o : leaves[i].outside) moved[i].push_back(o.place);
  }
  for (int round = 0; round < kFoldRounds; ++round) {
    std::vector<std::vector<std::uint32_t>> folding(leaves.size());
    parallelFor(std::size_t{0}, leaves.size(),
                [&](std::size_t i) { folding[i] = foldingVertices(grid, leaves[i], moved); });
    bool any = false;
    for (const auto& list : folding) {
      for (const std::uint32_t v : list) grid.markFolding(v);
      any = any || !list.empty();
    }
    if (!any) return;
    parallelFor(std::size_t{0}, leaves.size(), [&](std::size_t i) {
      SurfaceLeaf& leaf = leaves[i];
      moved[i].clear();
      std::erase_if(leaf.outside, [&](const OutsideVertex& o) {
        const bool put = grid.putInside(leaf.cellAt(o.place), o.inside, o.off);
        if (put) moved[i].push_back(o.place);
        return put;
      });
    });
  }
}

}  // namespace proveout
