// Dual contouring: one vertex per sheet and cell, one polygon per crossed grid edge.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "core/base/parallel_for.h"
#include "removal/cell_cycles.h"
#include "removal/cell_vertex.h"
#include "removal/stock_impl.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using openvdb::Coord;
constexpr std::uint16_t kNoCell = 0xFFFF;

std::uint64_t faceId(const Crossing& c) { return (static_cast<std::uint64_t>(c.motion) << 16) | c.element; }

struct Cell {
  std::uint8_t pattern = 0;
  std::uint32_t first = 0;  ///< number of its first vertex in the leaf
};

struct LeafSurface {
  Coord origin;
  const std::vector<Crossing>* crossings = nullptr;
  std::array<std::uint16_t, 512> cell_of{};  ///< index into cells, or kNoCell
  std::vector<Cell> cells;
  std::vector<CellVertex> vertices;    ///< p in mm
  std::vector<std::uint16_t> cramped;  ///< voxels of single-sheet cells whose faces meet outside the cell
  std::uint32_t base = 0;              ///< number of the leaf's first vertex in the mesh
};

/// A quad with the crossing in its middle. Corners are vertex numbers of the mesh, CCW from outside.
struct Quad {
  std::array<std::uint32_t, 4> v;
  const Crossing* crossing;
  Coord at;
  int axis;
};

/// Where both cells of a face join its four crossings to one sheet each, two dual edges would coincide; each
/// gets a vertex of its own.
struct FaceSplit {
  std::uint32_t after;                                ///< polygon corner that it follows
  std::tuple<int, int, int, int, int, int, int> key;  ///< face origin, face axis, material corner
  Vec3 p;
};

struct SplitQuad {
  Quad quad;
  std::vector<FaceSplit> splits;
};

struct LeafQuads {
  std::vector<Quad> quads;
  std::vector<SplitQuad> split;
  int missing = 0;  ///< crossings without their four cells: a bug if it is ever above 0
};

/// How far a vertex may reach into a neighbouring cell (in cells): half, because the neighbour's other side
/// may do the same.
constexpr double kReach = 0.5;
/// Distance that it keeps from the neighbour's own vertex.
constexpr double kKeepOff = 0.1;

class Extractor {
 public:
  explicit Extractor(const Stock::Impl& impl) : impl_(impl) {}

  Result<StockSurface> run(Progress& progress);

 private:
  void collectLeaves();
  void placeLeaf(LeafSurface& leaf) const;
  /// Crossings of a cell by sheet.
  struct Sheets {
    std::array<std::array<SheetPoint, 12>, 4> points;
    std::array<int, 4> count{};
    std::span<const SheetPoint> of(int i) const {
      return {points[i].data(), static_cast<std::size_t>(count[i])};
    }
  };
  void collectSheets(const Coord& cell, int pattern, const float* d, Sheets& sheets) const;
  void placeCell(LeafSurface& leaf, int v, int pattern, const float* d) const;
  Box3 roomOf(const Coord& cell) const;
  void relaxLeaf(LeafSurface& leaf) const;
  SheetPoint sheetPoint(const Coord& at, int axis, const Coord& cell, float d0, float d1) const;
  void leafQuads(const LeafSurface& leaf, LeafQuads& out) const;
  const LeafSurface* cellOf(const Coord& at, const Cell*& cell) const;
  bool makeQuad(const Crossing& c, const Coord& at, int axis, LeafQuads& out) const;
  Vec3 crossingPoint(const Coord& at, int axis) const;
  const CellVertex& vertex(std::uint32_t number) const;
  void emitQuad(const Quad& quad, StockSurface& out);
  void emitSplit(const SplitQuad& split, StockSurface& out);
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Crossing& made_by,
                   StockSurface& out);
  double correctedVolume(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& n) const;

  const Stock::Impl& impl_;
  std::vector<LeafSurface> leaves_;
  std::unordered_map<Coord, std::uint32_t> leaf_at_;
  std::vector<CellVertex> extra_;  ///< vertices behind those of the leaves
  std::map<std::tuple<int, int, int, int, int, int, int>, std::uint32_t> split_vertex_;
  std::uint32_t leaf_vertices_ = 0;
  std::vector<std::uint32_t> leaf_of_vertex_;
  Vec3 center_ = Vec3::Zero();
};

void Extractor::collectLeaves() {
  for (auto it = impl_.distance->tree().cbeginLeaf(); it; ++it) {
    LeafSurface leaf;
    leaf.origin = it->origin();
    const auto found = impl_.crossings.find(leaf.origin);
    if (found != impl_.crossings.end()) leaf.crossings = &found->second;
    leaf_at_.emplace(leaf.origin, static_cast<std::uint32_t>(leaves_.size()));
    leaves_.push_back(std::move(leaf));
  }
}

SheetPoint Extractor::sheetPoint(const Coord& at, int axis, const Coord& cell, float d0, float d1) const {
  SheetPoint s;
  const Crossing* c = findCrossing(impl_.crossings, at, axis);
  for (int i = 0; i < 3; ++i) s.p[i] = at[i] - cell[i];
  if (c == nullptr) {  // not expected; the samples' own zero keeps the mesh whole
    s.p[axis] += d0 / (d0 - d1);
    s.n = Vec3::Unit(axis) * (d0 < d1 ? 1.0 : -1.0);
    s.face = ~std::uint64_t{0};
    return s;
  }
  s.p[axis] += c->t;
  s.n = Vec3(c->normal[0], c->normal[1], c->normal[2]);
  s.face = faceId(*c);
  return s;
}

/// Sorts the crossings of a cell by sheet. `d`: samples at the corners.
void Extractor::collectSheets(const Coord& cell, int pattern, const float* d, Sheets& sheets) const {
  const CellCycles& cycles = cellCycles()[pattern];
  for (int e = 0; e < 12; ++e) {
    const int cycle = cycles.cycle_of_edge[e];
    if (cycle < 0) continue;
    const int corner = edgeStartCorner(e), axis = e / 4;
    const Coord at = cell.offsetBy(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    sheets.points[cycle][sheets.count[cycle]++] =
        sheetPoint(at, axis, cell, d[corner], d[corner | 1 << axis]);
  }
}

void Extractor::placeCell(LeafSurface& leaf, int v, int pattern, const float* d) const {
  const Coord cell = leaf.origin.offsetBy(v >> 6, (v >> 3) & 7, v & 7);
  Sheets sheets;
  collectSheets(cell, pattern, d, sheets);
  leaf.cell_of[v] = static_cast<std::uint16_t>(leaf.cells.size());
  leaf.cells.push_back(
      {static_cast<std::uint8_t>(pattern), static_cast<std::uint32_t>(leaf.vertices.size())});
  const int count = cellCycles()[pattern].count;
  for (int i = 0; i < count; ++i) {
    CellVertex vertex = placeVertex(sheets.of(i), Box3{Vec3::Zero(), Vec3::Ones()});
    if (vertex.cramped && count == 1) leaf.cramped.push_back(static_cast<std::uint16_t>(v));
    vertex.p = impl_.position(cell) + vertex.p * impl_.h;
    leaf.vertices.push_back(vertex);
  }
}

/// The cell and the parts of its neighbours that its vertex may use: a tip may poke through a wall without
/// meeting a grid line. Free are neighbours without surface, and those with one smooth face, up to their own
/// vertex.
Box3 Extractor::roomOf(const Coord& cell) const {
  Box3 room{Vec3::Zero(), Vec3::Ones()};
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      Coord at = cell;
      at[axis] += side;
      double reach = kReach;
      const Cell* neighbour = nullptr;
      if (const LeafSurface* leaf = cellOf(at, neighbour)) {
        const CellVertex& vertex = leaf->vertices[neighbour->first];
        if (cellCycles()[neighbour->pattern].count != 1 || !vertex.smooth) continue;
        const double p = (vertex.p[axis] - impl_.position(cell)[axis]) / impl_.h;
        reach = std::clamp((side > 0 ? p - 1.0 : -p) - kKeepOff, 0.0, kReach);
      }
      (side > 0 ? room.max : room.min)[axis] += side * reach;
    }
  }
  return room;
}

/// Gives vertices whose faces meet outside their cell the room that neighbours leave. Neighbours that are
/// asked never move here.
void Extractor::relaxLeaf(LeafSurface& leaf) const {
  auto read = impl_.distance->getConstUnsafeAccessor();
  for (const std::uint16_t v : leaf.cramped) {
    const Coord cell = leaf.origin.offsetBy(v >> 6, (v >> 3) & 7, v & 7);
    float d[8];
    for (int c = 0; c < 8; ++c) d[c] = read.getValue(cell.offsetBy(c & 1, c >> 1 & 1, c >> 2 & 1));
    const Cell& record = leaf.cells[leaf.cell_of[v]];
    Sheets sheets;
    collectSheets(cell, record.pattern, d, sheets);
    CellVertex& vertex = leaf.vertices[record.first];
    vertex.p = impl_.position(cell) + placeVertex(sheets.of(0), roomOf(cell)).p * impl_.h;
  }
}

void Extractor::placeLeaf(LeafSurface& leaf) const {
  leaf.cell_of.fill(kNoCell);
  std::array<float, kBlockSize> d;
  auto read = impl_.distance->getConstUnsafeAccessor();
  for (int x = 0; x < kBlock; ++x) {
    for (int y = 0; y < kBlock; ++y) {
      for (int z = 0; z < kBlock; ++z) d[blockIndex(x, y, z)] = read.getValue(leaf.origin.offsetBy(x, y, z));
    }
  }
  for (int v = 0; v < 512; ++v) {
    const int at = blockIndex(v >> 6, (v >> 3) & 7, v & 7);
    float corner[8];
    int pattern = 0;
    for (int c = 0; c < 8; ++c) {
      corner[c] =
          d[at + (c & 1) * kBlockStride[0] + (c >> 1 & 1) * kBlockStride[1] + (c >> 2 & 1) * kBlockStride[2]];
      if (corner[c] < 0.0f) pattern |= 1 << c;
    }
    if (pattern != 0 && pattern != 255) placeCell(leaf, v, pattern, corner);
  }
}

const LeafSurface* Extractor::cellOf(const Coord& at, const Cell*& cell) const {
  const auto found = leaf_at_.find(at & ~7);
  if (found == leaf_at_.end()) return nullptr;
  const LeafSurface& leaf = leaves_[found->second];
  const std::uint16_t index = leaf.cell_of[((at.x() & 7) << 6) | ((at.y() & 7) << 3) | (at.z() & 7)];
  if (index == kNoCell) return nullptr;
  cell = &leaf.cells[index];
  return &leaf;
}

Vec3 Extractor::crossingPoint(const Coord& at, int axis) const {
  const Crossing* c = findCrossing(impl_.crossings, at, axis);
  return impl_.position(at) + Vec3::Unit(axis) * (impl_.h * (c != nullptr ? c->t : 0.5));
}

bool Extractor::makeQuad(const Crossing& c, const Coord& at, int axis, LeafQuads& out) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  constexpr int kRing[4][2] = {
      {1, 1}, {0, 1}, {0, 0}, {1, 0}};  // CCW about +axis: what to step back along u and v
  Quad quad{{}, &c, at, axis};
  SplitQuad split;
  std::array<const Cell*, 4> cells{};
  std::array<int, 4> corner_in_cell{};
  for (int i = 0; i < 4; ++i) {
    Coord cell_at = at;
    cell_at[u] -= kRing[i][0];
    cell_at[v] -= kRing[i][1];
    const LeafSurface* leaf = cellOf(cell_at, cells[i]);
    if (leaf == nullptr) return false;
    corner_in_cell[i] = kRing[i][0] << u | kRing[i][1] << v;
    const int cycle = cellCycles()[cells[i]->pattern].cycle_of_edge[edgeAt(axis, corner_in_cell[i])];
    quad.v[i] = leaf->base + cells[i]->first + static_cast<std::uint32_t>(cycle);
  }
  const bool start_in = cells[2]->pattern & 1;  // cell 2 starts at `at`
  for (int i = 0; i < 4; ++i) {
    // Cells i and i + 1 share the face across `cross`; it runs along axis and the other direction.
    const int j = (i + 1) % 4;
    const int cross = kRing[i][0] != kRing[j][0] ? u : v, other = cross == u ? v : u;
    const int side = corner_in_cell[i] >> cross & 1;
    const auto oneSheet = [&](const Cell& cell, int face_side) {
      const CellCycles& cycles = cellCycles()[cell.pattern];
      const int base = face_side << cross;
      const int e[4] = {edgeAt(axis, base), edgeAt(axis, base | 1 << other), edgeAt(other, base),
                        edgeAt(other, base | 1 << axis)};
      for (int k = 0; k < 4; ++k) {
        if (cycles.cycle_of_edge[e[k]] < 0 || cycles.cycle_of_edge[e[k]] != cycles.cycle_of_edge[e[0]])
          return false;
      }
      return true;
    };
    if (!oneSheet(*cells[i], side) || !oneSheet(*cells[j], 1 - side)) continue;
    Coord face = at;
    const int back = corner_in_cell[i] >> other & 1;
    face[other] -= back;
    Coord material = at;
    if (!start_in) ++material[axis];
    Coord other_edge = material;  // the crossed edge along `other` at the material corner, in this face
    other_edge[other] -= back;
    const Vec3 p = 0.5 * (crossingPoint(at, axis) + crossingPoint(other_edge, other));
    split.splits.push_back({static_cast<std::uint32_t>(i),
                            {face.x(), face.y(), face.z(), cross, material.x(), material.y(), material.z()},
                            p});
  }
  if (!start_in) {
    std::reverse(quad.v.begin(), quad.v.end());
    for (FaceSplit& s : split.splits)
      s.after = (6 - s.after) % 4;  // between old i, i+1 = between new 3-i-1, 3-i
  }
  if (split.splits.empty()) {
    out.quads.push_back(quad);
  } else {
    split.quad = quad;
    std::sort(split.splits.begin(), split.splits.end(),
              [](const FaceSplit& a, const FaceSplit& b) { return a.after < b.after; });
    out.split.push_back(std::move(split));
  }
  return true;
}

void Extractor::leafQuads(const LeafSurface& leaf, LeafQuads& out) const {
  if (leaf.crossings == nullptr) return;
  for (const Crossing& c : *leaf.crossings) {
    const int v = c.key / 3;
    if (!makeQuad(c, leaf.origin.offsetBy(v >> 6, (v >> 3) & 7, v & 7), c.key % 3, out)) ++out.missing;
  }
}

const CellVertex& Extractor::vertex(std::uint32_t number) const {
  if (number >= leaf_vertices_) return extra_[number - leaf_vertices_];
  const LeafSurface& leaf = leaves_[leaf_of_vertex_[number]];
  return leaf.vertices[number - leaf.base];
}

/// Volume of the tetrahedron to the centre, and of the bulge between the triangle and the quadratic surface
/// that has the given normals at its corners: a third of the area times the sum of the edges' mid heights.
double Extractor::correctedVolume(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& n) const {
  const Vec3 a = p[0] - center_, b = p[1] - center_, c = p[2] - center_;
  double bulge = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    bulge += (n[j] - n[i]).dot(p[j] - p[i]) / 8.0;
  }
  return a.dot(b.cross(c)) / 6.0 + 0.5 * (b - a).cross(c - a).norm() * bulge / 3.0;
}

void Extractor::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Crossing& made_by,
                            StockSurface& out) {
  out.mesh.triangles.push_back({a, b, c});
  out.mesh.motion.push_back(made_by.motion);
  const Vec3 fallback(made_by.normal[0], made_by.normal[1], made_by.normal[2]);
  const std::uint64_t face = faceId(made_by);
  const CellVertex &va = vertex(a), &vb = vertex(b), &vc = vertex(c);
  out.volume_mm3 += correctedVolume(
      {va.p, vb.p, vc.p},
      {va.normalOf(face, fallback), vb.normalOf(face, fallback), vc.normalOf(face, fallback)});
}

void Extractor::emitQuad(const Quad& quad, StockSurface& out) {
  std::array<Vec3, 4> p;
  for (int i = 0; i < 4; ++i) p[i] = vertex(quad.v[i]).p;
  const Vec3 n(quad.crossing->normal[0], quad.crossing->normal[1], quad.crossing->normal[2]);
  const auto agreement = [&](int a, int b, int c) {
    const Vec3 area = (p[b] - p[a]).cross(p[c] - p[a]);
    const double length = area.norm();
    return length > 0.0 ? n.dot(area) / length : -1.0;
  };
  // The diagonal whose triangles face as the exact surface does; alike: the shorter one.
  const double split02 = std::min(agreement(0, 1, 2), agreement(0, 2, 3));
  const double split13 = std::min(agreement(0, 1, 3), agreement(1, 2, 3));
  const bool use02 = std::abs(split02 - split13) > 1e-9
                         ? split02 > split13
                         : (p[2] - p[0]).squaredNorm() <= (p[3] - p[1]).squaredNorm();
  const auto& v = quad.v;
  if (use02) {
    addTriangle(v[0], v[1], v[2], *quad.crossing, out);
    addTriangle(v[0], v[2], v[3], *quad.crossing, out);
  } else {
    addTriangle(v[0], v[1], v[3], *quad.crossing, out);
    addTriangle(v[1], v[2], v[3], *quad.crossing, out);
  }
}

void Extractor::emitSplit(const SplitQuad& split, StockSurface& out) {
  const auto newVertex = [&](const Vec3& p) {
    CellVertex v;
    v.p = p;
    extra_.push_back(v);
    out.mesh.positions.push_back(p.cast<float>());
    return static_cast<std::uint32_t>(leaf_vertices_ + extra_.size() - 1);
  };
  std::vector<std::uint32_t> ring;
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    ring.push_back(split.quad.v[i]);
    for (; next < split.splits.size() && split.splits[next].after == i; ++next) {
      const auto [it, fresh] = split_vertex_.emplace(split.splits[next].key, 0);
      if (fresh) it->second = newVertex(split.splits[next].p);
      ring.push_back(it->second);
    }
  }
  const std::uint32_t middle = newVertex(crossingPoint(split.quad.at, split.quad.axis));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    addTriangle(middle, ring[i], ring[(i + 1) % ring.size()], *split.quad.crossing, out);
  }
}

Result<StockSurface> Extractor::run(Progress& progress) {
  progress.report("meshing", 0.0);
  collectLeaves();
  parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
    if (!progress.cancelled()) placeLeaf(leaves_[i]);
  });
  parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
    if (!progress.cancelled()) relaxLeaf(leaves_[i]);
  });
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    leaves_[i].base = static_cast<std::uint32_t>(total);
    total += leaves_[i].vertices.size();
    leaf_of_vertex_.resize(total, static_cast<std::uint32_t>(i));
  }
  if (total > 0xF0000000u) {
    return Error{ErrorKind::kResourceLimit,
                 "the surface has more vertices than a mesh can number; take a coarser resolution"};
  }
  leaf_vertices_ = static_cast<std::uint32_t>(total);
  progress.report("meshing", 0.5);
  std::vector<LeafQuads> quads(leaves_.size());
  parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
    if (!progress.cancelled()) leafQuads(leaves_[i], quads[i]);
  });
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  center_ = impl_.blank.center();
  StockSurface out;
  out.mesh.positions.reserve(total);
  for (const LeafSurface& leaf : leaves_) {
    for (const CellVertex& v : leaf.vertices) out.mesh.positions.push_back(v.p.cast<float>());
  }
  for (const LeafQuads& q : quads) {
    if (q.missing > 0)
      return Error{ErrorKind::kInternal, "the stock's grid has a hole; please report this job"};
    for (const Quad& quad : q.quads) emitQuad(quad, out);
    for (const SplitQuad& split : q.split) emitSplit(split, out);
  }
  progress.report("meshing", 1.0);
  return out;
}

}  // namespace

Result<StockSurface> Stock::surface(int threads, Progress& progress) const {
  const ThreadLimit limit(threads);
  try {
    return Extractor(*impl_).run(progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::kResourceLimit, "not enough memory for the surface; take a coarser resolution"};
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("extracting the surface failed: {}", e.what())};
  }
}

}  // namespace proveout
