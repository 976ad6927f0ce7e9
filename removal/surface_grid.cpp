#include "removal/surface_grid.h"

#include <algorithm>

#include "core/base/parallel_for.h"
#include "removal/cell_cycles.h"

namespace proveout {

namespace {

using openvdb::Coord;

/// How far a vertex may reach into a neighbouring cell (in cells): half, because the neighbour's other side
/// may do the same.
constexpr double kReach = 0.5;
/// Distance that it keeps from the neighbour's own vertex.
constexpr double kKeepOff = 0.1;

std::uint64_t stepX(std::uint64_t own, std::uint64_t next) { return own >> 8 | next << 56; }
std::uint64_t stepY(std::uint64_t own, std::uint64_t next) {
  return (own >> 1 & 0x7F7F7F7F7F7F7F7Full) | (next & 0x0101010101010101ull) << 7;
}

/// Samples of layer z (0..8) at the four places (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
std::array<std::uint64_t, 4> cornerLayer(const std::array<const LeafBits*, 8>& bits, int z) {
  const int up = z == 8 ? 4 : 0, layer = z & 7;
  const std::uint64_t own = (*bits[up])[layer], x = (*bits[up | 1])[layer], y = (*bits[up | 2])[layer],
                      xy = (*bits[up | 3])[layer];
  const std::uint64_t over = stepX(own, x);
  return {own, over, stepY(own, y), stepY(over, stepX(y, xy))};
}

}  // namespace

/// Crossings of a cell by sheet.
struct SurfaceGrid::Sheets {
  std::array<std::array<SheetPoint, 12>, 4> points;
  std::array<int, 4> count{};
  std::span<const SheetPoint> of(int i) const {
    return {points[i].data(), static_cast<std::size_t>(count[i])};
  }
};

void SurfaceGrid::linkLeaf(SurfaceLeaf& leaf, std::size_t number) {
  const LeafReader read(impl_);
  leaf.stock = &impl_.leaves[number];
  const Coord& at = leaf.stock->origin;
  leaf.upper[0] = leaf.lower[0] = static_cast<std::int32_t>(number);
  std::array<const LeafBits*, 8> bits;
  bits[0] = &leaf.stock->material;
  for (int i = 1; i < 8; ++i) {
    const int dx = (i & 1) * 8, dy = (i >> 1 & 1) * 8, dz = (i >> 2) * 8;
    const std::int32_t up = read.state(at.offsetBy(dx, dy, dz));
    bits[i] = up >= 0 ? &impl_.leaves[static_cast<std::size_t>(up)].material
                      : (up == Stock::Impl::kInside ? &kAllInside : &kAllOutside);
    leaf.upper[i] = std::max(up, -1);
    leaf.lower[i] = i == 7 ? -1 : std::max(read.state(at.offsetBy(-dx, -dy, -dz)), -1);
  }
  leaf.edges = leafEdges(leaf.stock->material, {bits[1], bits[2], bits[4]});
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  int cells = 0;
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    const std::uint64_t any = low[0] | low[1] | low[2] | low[3] | high[0] | high[1] | high[2] | high[3];
    const std::uint64_t all = low[0] & low[1] & low[2] & low[3] & high[0] & high[1] & high[2] & high[3];
    leaf.mixed[z] = any & ~all;
    leaf.first_cell[z] = static_cast<std::uint16_t>(cells);
    cells += std::popcount(leaf.mixed[z]);
    low = high;
  }
}

CellAt SurfaceGrid::cellAt(const SurfaceLeaf& leaf, int x, int y, int z) const {
  CellAt cell;
  const int below = (x < 0) | (y < 0) << 1 | (z < 0) << 2, above = (x > 7) | (y > 7) << 1 | (z > 7) << 2;
  const std::int32_t number = below != 0 ? leaf.lower[below] : leaf.upper[above];
  if (number < 0) return cell;
  const SurfaceLeaf& there = leaves_[static_cast<std::size_t>(number)];
  const int lx = x & 7, ly = y & 7, lz = z & 7;
  if (!leafSample(there.mixed, lx, ly, lz)) return cell;
  cell.leaf = &there;
  cell.rank = there.rank(lx, ly, lz);
  cell.shift = {x - lx, y - ly, z - lz};
  return cell;
}

std::uint32_t SurfaceGrid::vertexNumber(const CellAt& cell, int sheet) const {
  if (sheet == 0) return cell.leaf->base + static_cast<std::uint32_t>(cell.rank);
  const auto& extra = cell.leaf->extra;
  const auto it = std::find_if(extra.begin(), extra.end(),
                               [&](const ExtraVertex& e) { return e.cell == cell.rank && e.sheet == sheet; });
  return cell.leaf->extra_base + static_cast<std::uint32_t>(it - extra.begin());
}

const Crossing* SurfaceGrid::crossingAt(const SurfaceLeaf& leaf, int axis, int x, int y, int z) const {
  const int above = x >> 3 | (y >> 3) << 1 | (z >> 3) << 2;
  const std::int32_t number = leaf.upper[above];
  if (number < 0) return nullptr;
  const SurfaceLeaf& there = leaves_[static_cast<std::size_t>(number)];
  const int lx = x & 7, ly = y & 7, lz = z & 7;
  if (!there.edges.isCrossed(axis, lx, ly, lz)) return nullptr;
  return &there.stock->crossings[static_cast<std::size_t>(there.edges.indexOf(axis, lx, ly, lz))];
}

/// Sorts the crossings of a cell by sheet.
void SurfaceGrid::collectSheets(const SurfaceLeaf& leaf, int place, int pattern, Sheets& sheets) const {
  const CellCycles& cycles = cellCycles()[pattern];
  const int x = place >> 3 & 7, y = place & 7, z = place >> 6;
  for (int e = 0; e < 12; ++e) {
    const int cycle = cycles.cycle_of_edge[e];
    if (cycle < 0) continue;
    const int corner = edgeStartCorner(e), axis = e / 4;
    const Crossing* c = crossingAt(leaf, axis, x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
    if (c == nullptr) continue;
    SheetPoint& s = sheets.points[cycle][sheets.count[cycle]++];
    s.p = Vec3(corner & 1, corner >> 1 & 1, corner >> 2);
    s.p[axis] += c->t;
    s.n = c->unitNormal();
    s.face = c->face();
  }
}

void SurfaceGrid::placeCell(SurfaceLeaf& leaf, int place, int pattern) {
  const int x = place >> 3 & 7, y = place & 7, z = place >> 6;
  const int rank = leaf.rank(x, y, z);
  const std::size_t number = leaf.base + static_cast<std::size_t>(rank);
  Sheets sheets;
  collectSheets(leaf, place, pattern, sheets);
  patterns_[number] = static_cast<std::uint8_t>(pattern);
  const int count = cellCycles()[pattern].count;
  for (int i = 0; i < count; ++i) {
    const CellVertex vertex = placeVertex(sheets.of(i), Box3{Vec3::Zero(), Vec3::Ones()});
    const Eigen::Vector3f p = (Vec3(x, y, z) + vertex.p).cast<float>();
    if (i == 0) {
      vertices_[number] = p;
      smooth_[number] = vertex.smooth && count == 1;
      if (vertex.cramped && count == 1) leaf.cramped.push_back(static_cast<std::uint16_t>(place));
    } else {
      leaf.extra.push_back({static_cast<std::uint16_t>(rank), static_cast<std::uint8_t>(i), p});
    }
  }
}

void SurfaceGrid::placeLeaf(SurfaceLeaf& leaf) {
  const LeafReader read(impl_);
  std::array<const LeafBits*, 8> bits;
  for (int i = 0; i < 8; ++i) {
    bits[i] = &read.bits(leaf.stock->origin.offsetBy((i & 1) * 8, (i >> 1 & 1) * 8, (i >> 2) * 8));
  }
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    for (std::uint64_t rest = leaf.mixed[z]; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      int pattern = 0;
      for (int c = 0; c < 4; ++c) {
        pattern |= static_cast<int>(low[c] >> bit & 1) << c | static_cast<int>(high[c] >> bit & 1) << (c + 4);
      }
      placeCell(leaf, z << 6 | bit, pattern);
    }
    low = high;
  }
}

/// The cell and the parts of its neighbours that its vertex may use: a tip may poke through a wall without
/// meeting a grid line. Free are neighbours without surface, and those with one smooth face, up to their own
/// vertex.
Box3 SurfaceGrid::roomOf(const SurfaceLeaf& leaf, int x, int y, int z) const {
  Box3 room{Vec3::Zero(), Vec3::Ones()};
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      Eigen::Vector3i at(x, y, z);
      at[axis] += side;
      double reach = kReach;
      if (const CellAt there = cellAt(leaf, at.x(), at.y(), at.z()); there.leaf != nullptr) {
        const std::size_t number = there.leaf->base + static_cast<std::size_t>(there.rank);
        if (!smooth_[number]) continue;
        const double p =
            vertices_[number][axis] + there.shift[axis] - (side > 0 ? at[axis] - 1 : at[axis] + 1);
        reach = std::clamp((side > 0 ? p - 1.0 : -p) - kKeepOff, 0.0, kReach);
      }
      (side > 0 ? room.max : room.min)[axis] += side * reach;
    }
  }
  return room;
}

/// Gives vertices whose faces meet outside their cell the room that neighbours leave. Neighbours that are
/// asked never move here.
void SurfaceGrid::relaxLeaf(SurfaceLeaf& leaf) {
  for (const std::uint16_t place : leaf.cramped) {
    const int x = place >> 3 & 7, y = place & 7, z = place >> 6;
    const std::size_t number = leaf.base + static_cast<std::size_t>(leaf.rank(x, y, z));
    Sheets sheets;
    collectSheets(leaf, place, patterns_[number], sheets);
    const Vec3 p = Vec3(x, y, z) + placeVertex(sheets.of(0), roomOf(leaf, x, y, z)).p;
    vertices_[number] = p.cast<float>();
  }
}

void SurfaceGrid::numberExtras() {
  std::size_t total = vertices_.size();
  for (SurfaceLeaf& leaf : leaves_) {
    leaf.extra_base = static_cast<std::uint32_t>(total);
    total += leaf.extra.size();
  }
  vertices_.reserve(total);
  for (const SurfaceLeaf& leaf : leaves_) {
    for (const ExtraVertex& e : leaf.extra) vertices_.push_back(e.p);
  }
}

void SurfaceGrid::build(Progress& progress) {
  leaves_.resize(impl_.leaves.size());
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
      if (!progress.cancelled()) body(i);
    });
  };
  eachLeaf([&](std::size_t i) { linkLeaf(leaves_[i], i); });
  std::size_t cells = 0;
  for (SurfaceLeaf& leaf : leaves_) {
    leaf.base = static_cast<std::uint32_t>(cells);
    cells += static_cast<std::size_t>(leaf.first_cell[7] + std::popcount(leaf.mixed[7]));
  }
  vertices_.resize(cells);
  patterns_.resize(cells);
  smooth_.resize(cells);
  eachLeaf([&](std::size_t i) { placeLeaf(leaves_[i]); });
  eachLeaf([&](std::size_t i) { relaxLeaf(leaves_[i]); });
  if (!progress.cancelled()) numberExtras();
}

}  // namespace proveout
