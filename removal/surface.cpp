// Dual contouring: one vertex per sheet and cell, one polygon per crossed grid edge.
#include "removal/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/parallel_for.h"
#include "removal/cell_cycles.h"
#include "removal/quad_volume.h"
#include "removal/surface_grid.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// CCW about +axis: what to step back along the next axis and the one after it.
constexpr int kRing[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};

/// Faces of a cell (bit axis * 2 + side) whose four edges are all crossed and belong to one sheet.
std::array<std::uint8_t, 256> makeOneSheetFaces() {
  std::array<std::uint8_t, 256> table{};
  for (int pattern = 0; pattern < 256; ++pattern) {
    const auto& cycle = cellCycles()[pattern].cycle_of_edge;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, base = (face & 1) << axis;
      const int first = cycle[edgeAt(u, base)];
      if (first >= 0 && cycle[edgeAt(u, base | 1 << v)] == first && cycle[edgeAt(v, base)] == first &&
          cycle[edgeAt(v, base | 1 << u)] == first) {
        table[pattern] |= static_cast<std::uint8_t>(1 << face);
      }
    }
  }
  return table;
}

/// The quad around a crossed edge. Corners are CCW from outside; lengths are in the units of its leaf.
struct Quad {
  std::array<std::uint32_t, 4> v;
  std::array<Vec3, 4> p;
  Vec3 middle;  ///< the crossing
  Vec3 normal;
  std::uint32_t motion = kNoMotion;
};

/// Where both cells of a face join its four crossings to one sheet each, two dual edges would coincide; each
/// gets a vertex of its own.
struct FaceSplit {
  int after = 0;             ///< corner of the quad that it follows
  std::array<int, 7> key{};  ///< voxel of the face, its axis, voxel of the material corner
  Eigen::Vector3f p;         ///< mm
};

/// A quad with such faces; its middle becomes a vertex.
struct SplitQuad {
  Quad quad;
  Eigen::Vector3f middle;  ///< mm
  std::vector<FaceSplit> faces;
};

struct LeafOutput {
  double volume = 0.0;  ///< of the cones from the centre, grid steps^3
  int triangles = 0;    ///< of quads that are not split
  std::size_t first_triangle = 0;
  bool hole = false;  ///< a crossing without its four cells: a bug
  std::vector<SplitQuad> split;
};

class Extractor {
 public:
  explicit Extractor(const Stock::Impl& impl) : impl_(impl), grid_(impl), one_sheet_(makeOneSheetFaces()) {}

  Result<StockSurface> run(Progress& progress);

 private:
  struct EdgeCells {
    std::array<CellAt, 4> cell;
    std::array<int, 4> corner{};  ///< of the cell, where the edge starts
    std::uint8_t one_sheet = 0;   ///< bit i: the face between cells i and i + 1 needs a split
  };
  bool edgeCells(const SurfaceLeaf& leaf, int axis, int x, int y, int z, EdgeCells& out) const;
  Quad makeQuad(const SurfaceLeaf& leaf, int axis, int x, int y, int z, const Crossing& c,
                const EdgeCells& cells) const;
  SplitQuad makeSplit(const SurfaceLeaf& leaf, int axis, int x, int y, int z, const Quad& quad,
                      const EdgeCells& cells) const;
  template <typename Body>
  void forEachCrossing(const SurfaceLeaf& leaf, Body&& body) const;
  void measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const;
  void writeLeaf(const SurfaceLeaf& leaf, const LeafOutput& out, TriMesh& mesh) const;
  void writeVertices(const SurfaceLeaf& leaf, TriMesh& mesh) const;
  void writeSplits(const std::vector<LeafOutput>& outputs, TriMesh& mesh) const;
  Vec3 positionOf(const SurfaceLeaf& leaf, const Vec3& p) const {
    return impl_.position(leaf.stock->origin) + impl_.h * p;
  }

  const Stock::Impl& impl_;
  SurfaceGrid grid_;
  std::array<std::uint8_t, 256> one_sheet_;
};

/// False where a cell is missing, which no sound stock has.
bool Extractor::edgeCells(const SurfaceLeaf& leaf, int axis, int x, int y, int z, EdgeCells& out) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<std::uint8_t, 4> faces;
  for (int i = 0; i < 4; ++i) {
    Eigen::Vector3i at(x, y, z);
    at[u] -= kRing[i][0];
    at[v] -= kRing[i][1];
    out.cell[i] = grid_.cellAt(leaf, at.x(), at.y(), at.z());
    if (out.cell[i].leaf == nullptr) return false;
    out.corner[i] = kRing[i][0] << u | kRing[i][1] << v;
    faces[i] = one_sheet_[grid_.pattern(out.cell[i])];
  }
  for (int i = 0; i < 4; ++i) {
    // Cells i and i + 1 share the face across `cross`.
    const int j = (i + 1) % 4, cross = kRing[i][0] != kRing[j][0] ? u : v;
    const int side = out.corner[i] >> cross & 1;
    if (faces[i] >> (cross * 2 + side) & faces[j] >> (cross * 2 + 1 - side) & 1) {
      out.one_sheet |= static_cast<std::uint8_t>(1 << i);
    }
  }
  return true;
}

Quad Extractor::makeQuad(const SurfaceLeaf& leaf, int axis, int x, int y, int z, const Crossing& c,
                         const EdgeCells& cells) const {
  Quad quad;
  const bool start_in = leafSample(leaf.stock->material, x, y, z);
  for (int i = 0; i < 4; ++i) {
    const CellAt& cell = cells.cell[i];
    const CellCycles& cycles = cellCycles()[grid_.pattern(cell)];
    const int sheet = cycles.count == 1 ? 0 : cycles.cycle_of_edge[edgeAt(axis, cells.corner[i])];
    const int at = start_in ? i : 3 - i;
    quad.v[at] = grid_.vertexNumber(cell, sheet);
    quad.p[at] = grid_.vertex(quad.v[at]).cast<double>() + cell.shift.cast<double>();
  }
  quad.middle = Vec3(x, y, z);
  quad.middle[axis] += c.t;
  quad.normal = c.unitNormal();
  quad.motion = c.motion;
  return quad;
}

SplitQuad Extractor::makeSplit(const SurfaceLeaf& leaf, int axis, int x, int y, int z, const Quad& quad,
                               const EdgeCells& cells) const {
  SplitQuad out{quad, positionOf(leaf, quad.middle).cast<float>(), {}};
  const bool start_in = leafSample(leaf.stock->material, x, y, z);
  for (int i = 0; i < 4; ++i) {
    if (!(cells.one_sheet >> i & 1)) continue;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int cross = kRing[i][0] != kRing[(i + 1) % 4][0] ? u : v, other = cross == u ? v : u;
    const int back = cells.corner[i] >> other & 1;
    Eigen::Vector3i face(x, y, z), material = face;
    face[other] -= back;
    if (!start_in) ++material[axis];
    Eigen::Vector3i edge = material;  // the crossed edge along `other` at the material corner, in this face
    edge[other] -= back;
    Vec3 end = edge.cast<double>();
    // It may start below this leaf, where only the leaf there can look it up.
    const Eigen::Vector3i home = edge.unaryExpr([](int k) { return k < 0 ? -8 : 0; });
    const int below = (home.x() != 0) | (home.y() != 0) << 1 | (home.z() != 0) << 2;
    const std::int32_t number = leaf.lower[below];
    const Eigen::Vector3i local = edge - home;
    const Crossing* c = number < 0 ? nullptr
                                   : grid_.crossingAt(grid_.leaves()[static_cast<std::size_t>(number)], other,
                                                      local.x(), local.y(), local.z());
    end[other] += c != nullptr ? c->t : 0.5f;
    const openvdb::Coord& o = leaf.stock->origin;
    FaceSplit split;
    split.after = start_in ? i : (6 - i) % 4;  // between old i, i+1 = between new 2-i, 3-i
    split.key = {face.x() + o.x(),     face.y() + o.y(),     face.z() + o.z(),    cross,
                 material.x() + o.x(), material.y() + o.y(), material.z() + o.z()};
    split.p = positionOf(leaf, 0.5 * (quad.middle + end)).cast<float>();
    out.faces.push_back(split);
  }
  std::sort(out.faces.begin(), out.faces.end(),
            [](const FaceSplit& a, const FaceSplit& b) { return a.after < b.after; });
  return out;
}

/// Calls body(axis, x, y, z, crossing) for each crossed edge of the leaf.
template <typename Body>
void Extractor::forEachCrossing(const SurfaceLeaf& leaf, Body&& body) const {
  const Crossing* c = leaf.stock->crossings.data();
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z < 8; ++z) {
      for (std::uint64_t rest = leaf.edges.crossed[axis][z]; rest != 0; rest &= rest - 1, ++c) {
        const int bit = std::countr_zero(rest);
        body(axis, bit >> 3, bit & 7, z, *c);
      }
    }
  }
}

void Extractor::measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const {
  if (leaf.stock->crossings.size() != leaf.edges.count) {
    out.hole = true;
    return;
  }
  const Vec3 center = (impl_.blank.center() - impl_.position(leaf.stock->origin)) / impl_.h;
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    EdgeCells cells;
    if (!edgeCells(leaf, axis, x, y, z, cells)) {
      out.hole = true;
      return;
    }
    const Quad quad = makeQuad(leaf, axis, x, y, z, c, cells);
    out.volume += quadVolume(quad.p, quad.middle, quad.normal, center);
    if (cells.one_sheet != 0) {
      out.split.push_back(makeSplit(leaf, axis, x, y, z, quad, cells));
    } else {
      out.triangles += 2;
    }
  });
}

/// The diagonal whose triangles face as the exact surface does; alike: the shorter one.
bool splitsAt02(const Quad& quad) {
  const auto& p = quad.p;
  const auto agreement = [&](int a, int b, int c) {
    const Vec3 area = (p[b] - p[a]).cross(p[c] - p[a]);
    const double length = area.norm();
    return length > 0.0 ? quad.normal.dot(area) / length : -1.0;
  };
  const double split02 = std::min(agreement(0, 1, 2), agreement(0, 2, 3));
  const double split13 = std::min(agreement(0, 1, 3), agreement(1, 2, 3));
  if (std::abs(split02 - split13) > 1e-6) return split02 > split13;
  return (p[2] - p[0]).squaredNorm() <= (p[3] - p[1]).squaredNorm();
}

void Extractor::writeLeaf(const SurfaceLeaf& leaf, const LeafOutput& out, TriMesh& mesh) const {
  std::size_t next = out.first_triangle;
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    EdgeCells cells;
    edgeCells(leaf, axis, x, y, z, cells);
    if (cells.one_sheet != 0) return;
    const Quad quad = makeQuad(leaf, axis, x, y, z, c, cells);
    const auto& v = quad.v;
    const bool use02 = splitsAt02(quad);
    mesh.triangles[next] = use02 ? Triangle{v[0], v[1], v[2]} : Triangle{v[0], v[1], v[3]};
    mesh.triangles[next + 1] = use02 ? Triangle{v[0], v[2], v[3]} : Triangle{v[1], v[2], v[3]};
    mesh.motion[next] = mesh.motion[next + 1] = quad.motion;
    next += 2;
  });
}

void Extractor::writeVertices(const SurfaceLeaf& leaf, TriMesh& mesh) const {
  const int cells = leaf.first_cell[7] + std::popcount(leaf.mixed[7]);
  const auto write = [&](std::uint32_t number) {
    mesh.positions[number] = positionOf(leaf, grid_.vertex(number).cast<double>()).cast<float>();
  };
  for (int i = 0; i < cells; ++i) write(leaf.base + static_cast<std::uint32_t>(i));
  for (std::size_t i = 0; i < leaf.extra.size(); ++i) write(leaf.extra_base + static_cast<std::uint32_t>(i));
}

void Extractor::writeSplits(const std::vector<LeafOutput>& outputs, TriMesh& mesh) const {
  std::map<std::array<int, 7>, std::uint32_t> at_face;
  const auto newVertex = [&](const Eigen::Vector3f& p) {
    mesh.positions.push_back(p);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (const LeafOutput& out : outputs) {
    for (const SplitQuad& split : out.split) {
      std::vector<std::uint32_t> ring;
      std::size_t next = 0;
      for (int i = 0; i < 4; ++i) {
        ring.push_back(split.quad.v[static_cast<std::size_t>(i)]);
        for (; next < split.faces.size() && split.faces[next].after == i; ++next) {
          const auto [it, fresh] = at_face.emplace(split.faces[next].key, 0);
          if (fresh) it->second = newVertex(split.faces[next].p);
          ring.push_back(it->second);
        }
      }
      const std::uint32_t middle = newVertex(split.middle);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        mesh.triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
        mesh.motion.push_back(split.quad.motion);
      }
    }
  }
}

Result<StockSurface> Extractor::run(Progress& progress) {
  progress.report("meshing", 0.0);
  grid_.build(progress);
  const Error interrupted{ErrorKind::kInterrupted, "interrupted"};
  if (progress.cancelled()) return interrupted;
  progress.report("meshing", 0.4);
  const auto& leaves = grid_.leaves();
  std::vector<LeafOutput> outputs(leaves.size());
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, leaves.size(), [&](std::size_t i) {
      if (!progress.cancelled()) body(leaves[i], outputs[i]);
    });
  };
  eachLeaf([&](const SurfaceLeaf& leaf, LeafOutput& out) { measureLeaf(leaf, out); });
  StockSurface surface;
  std::size_t triangles = 0;
  for (LeafOutput& out : outputs) {
    if (out.hole) return Error{ErrorKind::kInternal, "the stock's grid has a hole; please report this job"};
    out.first_triangle = triangles;
    triangles += static_cast<std::size_t>(out.triangles);
    surface.volume_mm3 += out.volume;
  }
  surface.volume_mm3 *= impl_.h * impl_.h * impl_.h;
  progress.report("meshing", 0.7);
  surface.mesh.positions.resize(grid_.vertexCount());
  surface.mesh.triangles.resize(triangles);
  surface.mesh.motion.resize(triangles);
  eachLeaf([&](const SurfaceLeaf& leaf, const LeafOutput& out) {
    writeVertices(leaf, surface.mesh);
    writeLeaf(leaf, out, surface.mesh);
  });
  if (progress.cancelled()) return interrupted;
  writeSplits(outputs, surface.mesh);
  progress.report("meshing", 1.0);
  return surface;
}

}  // namespace

Result<StockSurface> extractSurface(const Stock::Impl& impl, Progress& progress) {
  // Three crossings a vertex at most, and vertices of split quads: far from what 32 bits can number.
  std::size_t crossings = 0;
  for (const StockLeaf& leaf : impl.leaves) crossings += leaf.crossings.size();
  if (crossings > 0x60000000u) {
    return Error{ErrorKind::kResourceLimit,
                 "the surface has more vertices than a mesh can number; take a coarser resolution"};
  }
  return Extractor(impl).run(progress);
}

Result<StockSurface> Stock::surface(int threads, Progress& progress) const {
  const ThreadLimit limit(threads);
  try {
    return extractSurface(*impl_, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::kResourceLimit, "not enough memory for the surface; take a coarser resolution"};
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("extracting the surface failed: {}", e.what())};
  }
}

}  // namespace proveout
