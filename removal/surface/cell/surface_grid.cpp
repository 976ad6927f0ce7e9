#include "removal/surface/cell/surface_grid.h"

#include <algorithm>
#include <tuple>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "removal/grid/leaf_layers.h"
#include "removal/surface/cell/face_joins.h"
#include "removal/surface/cell/leaf_placer.h"

namespace proveout {

namespace {

constexpr float kNormalUnit = 1.0f / Crossing::kNormalScale;

std::uint8_t findOneSheetFaces(CellShape shape) {
  const CellCycles cycles = cellCycles(shape);
  const auto& cycle = cycles.cycle_of_edge;
  std::uint8_t out = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, base = (face & 1) << axis;
    const int first = cycle[edgeAt(u, base)];
    if (first >= 0 && cycle[edgeAt(u, base | 1 << v)] == first && cycle[edgeAt(v, base)] == first &&
        cycle[edgeAt(v, base | 1 << u)] == first) {
      out |= static_cast<std::uint8_t>(1 << face);
    }
  }
  return out;
}

/// The places of one layer across an axis.
LeafBits layerAcross(int axis, int layer) {
  LeafBits bits{};
  for (int z = 0; z < 8; ++z) {
    bits[z] = axis == 0 ? kColumnX0 << 8 * layer : axis == 1 ? kColumnY0 << layer : z == layer ? ~0ull : 0ull;
  }
  return bits;
}

LevelFace levelFace(const SurfaceLeaf& leaf) {
  LevelFace out;
  const std::vector<Crossing>& crossings = leaf.stock->crossings;
  if (leaf.cells != 64 || leaf.edges.count != 64 || crossings.size() != 64) return out;
  const auto* const normal = crossings.front().normal;
  int axis = 0;
  while (axis < 2 && normal[axis] == 0) ++axis;
  if (normal[(axis + 1) % 3] != 0 || normal[(axis + 2) % 3] != 0) return out;
  int layer = 0;
  while (layer < 8 && layerAcross(axis, layer) != leaf.mixed) ++layer;
  if (layer == 8 || leaf.edges.crossed[axis] != leaf.mixed) return out;
  if (std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& c) { return c != crossings[0]; }))
    return out;
  out.axis = static_cast<std::int8_t>(axis);
  out.layer = static_cast<std::int8_t>(layer);
  out.crossing = crossings.front();
  std::array<int, 3> place{};
  place[axis] = layer;
  out.material_below = leafSample(leaf.stock->material(), place[0], place[1], place[2]);
  return out;
}

}  // namespace

std::uint8_t oneSheetFaces(CellShape shape) {
  static const auto kTable = tableOfPatterns<std::uint8_t>(findOneSheetFaces);
  return shape < kPatterns ? kTable[shape] : findOneSheetFaces(shape);
}

void SurfaceGrid::linkLeaf(SurfaceLeaf& leaf, std::size_t number) {
  const LeafReader read(impl_);
  leaf.stock = &impl_.leaves[number];
  const Coord& at = leaf.stock->origin;
  leaf.upper = read.statesBeside(at, 1);
  PROVEOUT_ASSERT(leaf.upper[0] == static_cast<std::int32_t>(number));
  // Each leaf enters itself as the lower one of its neighbours; the last entry is never read.
  for (std::size_t i = 0; i < 7; ++i) {
    if (leaf.upper[i] >= 0)
      leaves_[static_cast<std::size_t>(leaf.upper[i])].lower[i] = static_cast<std::int32_t>(number);
  }
  const BlockBits bits = blockBits(leaf);
  leaf.edges = leafEdges(leaf.stock->material(), {bits[1], bits[2], bits[4]});
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    leaf.mixed[z] = mixedBits(low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]);
    leaf.first_cell[z] = leaf.cells;
    leaf.cells = static_cast<std::uint16_t>(leaf.cells + countBits(leaf.mixed[z]));
    low = high;
  }
  leaf.level = levelFace(leaf);
}

bool SurfaceGrid::isLevel(const SurfaceLeaf& leaf, const std::array<std::int32_t, 8>& beside) const {
  if (leaf.level.axis < 0) return false;
  const int u = 1 << (leaf.level.axis + 1) % 3, v = 1 << (leaf.level.axis + 2) % 3;
  for (const int place : {u, v, u | v}) {
    const std::int32_t n = beside[static_cast<std::size_t>(place)];
    if (n < 0 || leaves_[static_cast<std::size_t>(n)].level != leaf.level) return false;
  }
  return true;
}

BlockBits SurfaceGrid::blockBits(const SurfaceLeaf& leaf) const {
  BlockBits bits;
  for (int i = 0; i < 8; ++i) {
    const std::int32_t n = leaf.upper[i];
    bits[i] = n >= 0 ? &impl_.leaves[static_cast<std::size_t>(n)].material()
                     : (n == StockTree::kInside ? &kAllInside : &kAllOutside);
  }
  return bits;
}

/// What placeLeaf does, for a leaf and neighbours of one level face.
void SurfaceGrid::placeLevel(SurfaceLeaf& leaf) {
  constexpr std::array<std::uint8_t, 3> kLowCorners = {0x55, 0x33, 0x0F};
  leaf.all_level = true;
  const auto& [axis, layer, material_below, c] = leaf.level;
  const std::uint8_t low = kLowCorners[static_cast<std::size_t>(axis)];
  const CellShape shape = static_cast<std::uint8_t>(material_below ? low : ~low);
  const auto traits = static_cast<std::uint16_t>(oneSheetFaces(shape) | CellTraits::kSmooth);
  const float height = 0.25f * (c.t + c.t + c.t + c.t) + toFloat(layer);  // rounded as for any cell
  std::size_t number = leaf.base;
  for (int z = 0; z < 8; ++z) {
    for (std::uint64_t rest = leaf.mixed[z]; rest != 0; rest &= rest - 1, ++number) {
      const int bit = std::countr_zero(rest);
      Eigen::Vector3f p = Eigen::Vector3f(bit >> 3, bit & 7, z) + Eigen::Vector3f::Constant(0.5f);
      p[axis] = height;
      vertices_[number] = p;
      shapes_[number] = shape;
      traits_[number] = traits;
    }
  }
  const Eigen::Vector3f normal(c.normal[0], c.normal[1], c.normal[2]);
  if (flatness_ > 0.0) leaf.clusters = planeClusters((normal * kNormalUnit).normalized());
}

void SurfaceGrid::placeLeaf(SurfaceLeaf& leaf) {
  const auto flatness = toFloat(flatness_);
  if ((flatness == 0.0f || mergesPlanes(flatness)) && isLevel(leaf, leaf.upper)) return placeLevel(leaf);
  const BlockBits bits = blockBits(leaf);
  CrossingTable crossings;
  crossings.fill(leaves_, leaf);
  LeafPatch patch;
  LeafPlacer placer(impl_, leaf, crossings, flatness_ > 0.0 ? &patch : nullptr);
  const FaceJoins joins(impl_);
  int rank = 0;
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    for (std::uint64_t rest = leaf.mixed[z]; rest != 0; rest &= rest - 1, ++rank) {
      const int bit = std::countr_zero(rest);
      int pattern = 0;
      for (int c = 0; c < 4; ++c) {
        pattern |= static_cast<int>(low[c] >> bit & 1) << c | static_cast<int>(high[c] >> bit & 1) << (c + 4);
      }
      const Coord at = leaf.stock->origin.offsetBy(bit >> 3, bit & 7, z);
      const CellShape shape = joins.shapeOf(at, static_cast<std::uint8_t>(pattern));
      const LeafPlacer::Placed placed = placer.place(bit, z, rank, shape);
      const std::size_t number = leaf.base + static_cast<std::size_t>(rank);
      vertices_[number] = placed.p;
      shapes_[number] = shape;
      traits_[number] = placed.traits;
    }
    low = high;
  }
  PROVEOUT_ASSERT(rank == leaf.cells);
  PROVEOUT_ASSERT_DEAR(
      std::is_sorted(leaf.extra.begin(), leaf.extra.end(), [](const ExtraVertex& a, const ExtraVertex& b) {
        return std::tie(a.cell, a.sheet) < std::tie(b.cell, b.sheet);
      }));
  if (flatness_ > 0.0) {
    patch.faces = crossedFaces(bits);
    leaf.clusters = findClusters(leaf, patch, flatness);
  }
}

void SurfaceGrid::numberExtras() {
  for (SurfaceLeaf& leaf : leaves_) {
    leaf.extra_base = static_cast<std::uint32_t>(cell_count_ + extra_count_);
    extra_count_ += leaf.extra.size();
  }
}

std::size_t SurfaceGrid::countThin() const {
  constexpr std::uint16_t kThin = CellTraits::kManySheets | CellTraits::kOff;
  return static_cast<std::size_t>(std::count_if(&traits_[0], &traits_[cell_count_],
                                                [](std::uint16_t traits) { return (traits & kThin) != 0; }));
}

bool SurfaceGrid::build(Progress& progress) {
  leaves_.resize(impl_.leaves.size());
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
      if (!progress.cancelled()) body(i);
    });
  };
  eachLeaf([&](std::size_t i) { linkLeaf(leaves_[i], i); });
  if (progress.cancelled()) return true;
  for (SurfaceLeaf& leaf : leaves_) {
    if (leaf.stock->crossings.size() != leaf.edges.count) return false;
    leaf.base = static_cast<std::uint32_t>(cell_count_);
    cell_count_ += leaf.cells;
  }
  vertices_ = std::make_unique_for_overwrite<Eigen::Vector3f[]>(cell_count_);
  shapes_ = std::make_unique_for_overwrite<CellShape[]>(cell_count_);
  traits_ = std::make_unique_for_overwrite<std::uint16_t[]>(cell_count_);
  eachLeaf([&](std::size_t i) { placeLeaf(leaves_[i]); });
  if (!progress.cancelled()) numberExtras();
  return true;
}

std::size_t SurfaceGrid::leafOf(std::uint32_t cell) const {
  const auto above = std::upper_bound(leaves_.begin(), leaves_.end(), cell,
                                      [](std::uint32_t c, const SurfaceLeaf& leaf) { return c < leaf.base; });
  return static_cast<std::size_t>(above - leaves_.begin()) - 1;
}

std::uint32_t SurfaceGrid::cellOf(std::uint32_t vertex) const {
  if (vertex < cell_count_) return vertex;
  const auto above =
      std::upper_bound(leaves_.begin(), leaves_.end(), vertex,
                       [](std::uint32_t v, const SurfaceLeaf& leaf) { return v < leaf.extra_base; });
  const SurfaceLeaf& leaf = *(above - 1);
  return leaf.base + leaf.extra[vertex - leaf.extra_base].cell;
}

bool SurfaceGrid::putInside(std::uint32_t cell, const Eigen::Vector3f& p, bool off) {
  if (!(traits_[cell] & CellTraits::kFolds)) return false;
  if (off) traits_[cell] |= CellTraits::kOff;
  traits_[cell] &= static_cast<std::uint16_t>(~(CellTraits::kFolds | CellTraits::kOutside));
  vertices_[cell] = p;
  return true;
}

double SurfaceGrid::crossingOn(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return 0.5;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leaf.edges.isCrossed(axis, x, y, z)) return 0.5;
  const auto i = static_cast<std::size_t>(leaf.edges.indexOf(axis, x, y, z));
  return std::clamp<double>(leaf.stock->crossings[i].t, kEndGap, 1.0 - kEndGap);
}

std::optional<std::uint32_t> SurfaceGrid::cellAt(const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return std::nullopt;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leafSample(leaf.mixed, x, y, z)) return std::nullopt;
  return leaf.cellAt(z << 6 | leafBit(x, y));
}

bool SurfaceGrid::isCrossed(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  return number >= 0 &&
         leaves_[static_cast<std::size_t>(number)].edges.isCrossed(axis, at.x() & 7, at.y() & 7, at.z() & 7);
}

MotionId SurfaceGrid::motionOn(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return kNoMotion;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leaf.edges.isCrossed(axis, x, y, z)) return kNoMotion;
  const int i = leaf.edges.indexOf(axis, x, y, z);
  return knownMotion(leaf.stock->crossings[static_cast<std::size_t>(i)].motion);
}

bool verticesInReach(const SurfaceGrid& grid) {
  constexpr double kRounding = 1e-4;
  const auto outside = [](const SurfaceLeaf& leaf, int rank, const Eigen::Vector3f& p) {
    const int place = leaf.placeOf(rank);
    return outsideBy(p.cast<double>() - Vec3(place >> 3 & 7, place & 7, place >> 6));
  };
  for (const SurfaceLeaf& leaf : grid.leaves()) {
    for (int rank = 0; rank < leaf.cells; ++rank) {
      const std::uint32_t cell = leaf.base + static_cast<std::uint32_t>(rank);
      const std::uint16_t traits = grid.traits(cell);
      const double reach = traits & CellTraits::kOutside      ? kVertexReach
                           : traits & CellTraits::kManySheets ? kThinReach + kSheetGap
                                                              : 0.0;
      if (!(outside(leaf, rank, grid.vertex(cell)) <= reach + kRounding)) return false;
    }
    for (const ExtraVertex& extra : leaf.extra) {
      if (!(outside(leaf, extra.cell, extra.p) <= kThinReach + kSheetGap + kRounding)) return false;
    }
  }
  return true;
}

}  // namespace proveout
