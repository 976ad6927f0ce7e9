// Dual contouring: one vertex per sheet and cell, one polygon per crossed grid edge.
#include "removal/surface/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/base/thread_limit.h"
#include "core/mesh/intersections.h"
#include "removal/surface/quad_volume.h"
#include "removal/surface/surface_faults.h"
#include "removal/surface/surface_mend.h"
#include "removal/surface/surface_merge.h"
#include "removal/surface/surface_quads.h"
#include "removal/surface/surface_sharpen.h"
#include "removal/surface/surface_splits.h"

namespace proveout {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Part of the tolerance that the heights of a merged patch may take: a triangle between the middles of
/// patches leaves the surface as much as each patch leaves its plane, and normals turn in between.
constexpr double kFlatnessShare = 0.5;
/// Part of it that edges between the vertices may be cut off by.
constexpr double kSharpShare = 0.5;
constexpr double kDefaultTolerance = 0.1;  ///< of the grid spacing
/// Quads are made finer where their crossing is off by half the tolerance, or by this part of the grid
/// spacing.
constexpr double kFanHeight = 0.005;
/// Rounds of taking merged cells apart where they spoil the mesh, before all merging is given up.
constexpr int kRepairRounds = 12;
/// Rounds of taking merged cells apart where triangles meet, before the mesh itself is changed.
constexpr int kPartRounds = 16;
/// Triangles of merged vertices that lean more than this (73 degrees) from the exact surface are refused.
constexpr double kLeastAgreement = 0.3;
/// Around triangles that lean more than this (60 degrees) the surface may run through itself.
constexpr double kPoorAgreement = 0.5;

/// A quad of corners that stand for themselves: its cut, or that it is made of more triangles. Any other is
/// judged where its corners ended up.
enum QuadState : std::uint8_t { kAt02 = 1, kPoor = 2, kMerged = 4, kApart = 8 };

struct LeafOutput {
  double volume = 0.0;        ///< of the cones from the centre, grid steps^3
  double volume_error = 0.0;  ///< see QuadVolume, grid steps^3
  std::uint32_t triangles = 0, vertices = 0;
  std::size_t first_triangle = 0;
  std::uint32_t first_vertex = 0;
  std::size_t old_triangle = 0;  ///< first_triangle and first_vertex in the mesh before
  std::uint32_t old_vertex = 0;
  bool changed = true;    ///< its triangles are to be made anew
  bool unchecked = true;  ///< and not yet looked at for intersections
  bool hole = false;      ///< a crossing without its four cells: a bug
  std::vector<SplitQuad> split;
  std::vector<std::uint8_t> cuts;     ///< what becomes of each quad, see QuadState
  std::vector<std::uint32_t> faults;  ///< merged vertices of triangles that face the wrong way
  std::vector<std::uint32_t> poor;    ///< triangles, from the first one, that lean far from the exact surface
};

/// A quad's corners after merging, without repeats.
struct Polygon {
  int count = 0;
  std::array<std::uint32_t, 4> v;
};

class Extractor {
 public:
  Extractor(const Stock::Impl& impl, double simplify_mm)
      : impl_(impl),
        grid_(impl, kFlatnessShare * simplify_mm / impl.h),
        merger_(grid_, kFlatnessShare * simplify_mm / impl.h),
        fan_height_(std::max(kFanHeight, 0.5 * simplify_mm / impl.h)),
        simplify_mm_(simplify_mm) {}

  Result<StockSurface> run(Progress& progress);
  Result<StockVolume> volume(Progress& progress);

 private:
  template <typename Body>
  void eachLeaf(Progress& progress, Body&& body);
  Polygon polygon(const std::array<std::uint32_t, 4>& v) const;
  void measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const;
  bool levelCorners(const SurfaceLeaf& leaf, std::array<const SurfaceLeaf*, 4>& corners) const;
  double levelVolume(const SurfaceLeaf& leaf) const;
  bool countLevel(const SurfaceLeaf& leaf, const std::array<const SurfaceLeaf*, 4>& corners,
                  LeafOutput& out) const;
  StockVolume volumeOfLeaves() const;
  void countQuad(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c, const std::array<int, 4>& at,
                 LeafOutput& out) const;
  bool isFan(const Quad& quad) const;
  bool anyMerged(const Quad& quad) const;
  void countLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const;
  void numberVertices();
  void writeVertices(const SurfaceLeaf& leaf, const LeafOutput& out, TriMesh& mesh);
  void writeLeaf(const SurfaceLeaf& leaf, LeafOutput& out, TriMesh& mesh) const;
  std::size_t writeQuad(const std::array<std::uint32_t, 4>& v, bool at02, bool poor, const Crossing& c,
                        LeafOutput& out, std::size_t next, TriMesh& mesh) const;
  std::size_t writeMerged(const SurfaceLeaf& leaf, Quad& quad, const Crossing& c, LeafOutput& out,
                          std::size_t next, TriMesh& mesh) const;
  void copyVertices(const LeafOutput& out, TriMesh& mesh);
  void copyLeaf(const LeafOutput& out, TriMesh& mesh) const;
  void writeSplits(TriMesh& mesh);
  void writeMesh(TriMesh& mesh, Progress& progress);
  std::vector<std::uint8_t> verticesOf(const TriMesh& mesh, bool LeafOutput::*which) const;
  std::vector<std::uint32_t> findFaults(const TriMesh& mesh, const std::vector<std::uint8_t>& touched) const;
  std::vector<std::array<std::uint32_t, 2>> findMeetings(const TriMesh& mesh) const;
  void addCells(const std::array<std::uint32_t, 3>& triangle, std::vector<std::uint32_t>& cells) const;
  bool part(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs);
  void update(Progress& progress);
  bool repair(StockSurface& surface, Progress& progress);
  std::uint32_t finalNumber(std::uint32_t v) const;
  std::uint32_t cellAt(std::uint32_t number) const { return cell_at_.empty() ? number : cell_at_[number]; }

  const Stock::Impl& impl_;
  SurfaceGrid grid_;
  VertexMerger merger_;
  double fan_height_;  ///< see isFan; grid steps
  double simplify_mm_;
  std::vector<LeafOutput> outputs_;
  std::unique_ptr<std::uint32_t[]> number_;  ///< a cell whose vertex stands for itself: its place in the mesh
  std::uint32_t cells_kept_ = 0;
  std::vector<std::uint32_t> cell_at_;      ///< the cell of a vertex of the mesh; empty: each its own
  TriMesh old_mesh_;                        ///< before the last round; its memory serves the next one
  std::vector<std::uint32_t> old_cell_at_;  ///< of that mesh
  std::vector<const SplitQuad*> split_at_;  ///< quads of the vertices after those of the cells and sheets
  std::vector<std::int32_t> stale_;         ///< leaves whose cells changed, maybe repeatedly
};

template <typename Body>
void Extractor::eachLeaf(Progress& progress, Body&& body) {
  parallelFor(std::size_t{0}, outputs_.size(), [&](std::size_t i) {
    if (!progress.cancelled()) body(grid_.leaves()[i], outputs_[i]);
  });
}

Polygon Extractor::polygon(const std::array<std::uint32_t, 4>& v) const {
  Polygon out;
  if (!merger_.active()) {
    out.count = 4;
    out.v = v;
    return out;
  }
  for (const std::uint32_t corner : v) {
    const std::uint32_t s = merger_.standIn(corner);
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

/// Whether the quad is made of four triangles around its crossing, to keep to the tolerance.
bool Extractor::isFan(const Quad& quad) const { return bulges(quad, fan_height_) && !anyMerged(quad); }

bool Extractor::anyMerged(const Quad& quad) const {
  return std::any_of(quad.v.begin(), quad.v.end(), [&](std::uint32_t v) { return merger_.merged(v); });
}

/// Counts the triangles of the quad at `at` (axis, x, y, z), or keeps it to be split.
void Extractor::countQuad(const SurfaceLeaf& leaf, const Quad& quad, const Crossing& c,
                          const std::array<int, 4>& at, LeafOutput& out) const {
  if (quad.split != 0 || isFan(quad)) {
    out.split.push_back(splitQuad(grid_, leaf, at[0], at[1], at[2], at[3], quad, c));
    out.cuts.push_back(kApart);
    return;
  }
  const int corners = polygon(quad.v).count;
  if (corners > 0) out.triangles += static_cast<std::uint32_t>(corners - 2);
  if (corners != 4 || anyMerged(quad)) {
    out.cuts.push_back(kMerged);
    return;
  }
  const QuadCut cut = cutQuad(quad.p, quad.middle, quad.normal, quad.smooth_corners);
  out.cuts.push_back(static_cast<std::uint8_t>((cut.at02 ? kAt02 : 0) | (cut.poor ? kPoor : 0)));
}

/// Whether all quads of the leaf are of one level face, and the leaves that their corners are in.
bool Extractor::levelCorners(const SurfaceLeaf& leaf, std::array<const SurfaceLeaf*, 4>& corners) const {
  if (!grid_.isLevel(leaf, leaf.lower)) return false;
  const int axis = leaf.level.axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  for (int i = 0; i < 4; ++i) {
    const int place = (kRing[i][0] ? u : 0) | (kRing[i][1] ? v : 0);
    corners[i] = &grid_.leaves()[static_cast<std::size_t>(leaf.lower[place])];
    if (!corners[i]->all_level) return false;
  }
  return true;
}

/// The same, bit for bit, whatever is merged.
double Extractor::levelVolume(const SurfaceLeaf& leaf) const {
  const int axis = leaf.level.axis;
  const double height = leaf.level.layer + static_cast<double>(leaf.level.crossing.t);
  const double from =
      height - (impl_.blank.center()[axis] - impl_.position(leaf.stock->origin)[axis]) / impl_.h;
  double volume = 0.0;
  for (int i = 0; i < 64; ++i) volume += (leaf.level.material_below ? 2.0 : -2.0) * from / 6.0;
  return volume;
}

/// Counts the triangles of such a leaf. False where its quads are not merged whole or not at all.
bool Extractor::countLevel(const SurfaceLeaf& leaf, const std::array<const SurfaceLeaf*, 4>& corners,
                           LeafOutput& out) const {
  std::array<std::uint32_t, 4> base;
  for (int i = 0; i < 4; ++i) {
    if (merger_.active() && !corners[i]->clusters.eight) return false;
    base[i] = corners[i]->base;
  }
  out.cuts.assign(64, merger_.active() ? kMerged : kAt02);
  out.triangles = 128;
  if (!merger_.active()) return true;
  // Four vertices stand for all; only where they meet is there anything left of a quad.
  if (!leaf.level.material_below) std::reverse(base.begin(), base.end());
  const int count = polygon(base).count;
  out.triangles = count > 0 ? static_cast<std::uint32_t>(count - 2) : 0;
  return true;
}

/// The volume does not depend on what is merged.
void Extractor::measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const {
  std::array<const SurfaceLeaf*, 4> corners;
  const bool level = levelCorners(leaf, corners);
  if (level) out.volume = levelVolume(leaf);
  if (level && countLevel(leaf, corners, out)) return;
  const Vec3 center = (impl_.blank.center() - impl_.position(leaf.stock->origin)) / impl_.h;
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  out.cuts.reserve(leaf.edges.count);
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    if (!reader.read(axis, x, y, z, c, quad)) {
      out.hole = true;
      return;
    }
    if (!level) {
      const QuadVolume cone = quadVolume(quad.p, quad.middle, quad.normal, center);
      out.volume += cone.volume;
      out.volume_error += cone.error;
    }
    countQuad(leaf, quad, c, {axis, x, y, z}, out);
  });
}

/// The same, bit for bit, for the same leaves.
StockVolume Extractor::volumeOfLeaves() const {
  StockVolume sum;
  for (const LeafOutput& out : outputs_) {
    sum.mm3 += out.volume;
    sum.error_mm3 += out.volume_error;
  }
  const double cell = impl_.h * impl_.h * impl_.h;
  return {sum.mm3 * cell, sum.error_mm3 * cell};
}

void Extractor::countLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const {
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  out.triangles = 0;
  out.split.clear();
  out.cuts.clear();
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    reader.read(axis, x, y, z, c, quad);
    countQuad(leaf, quad, c, {axis, x, y, z}, out);
  });
}

/// Gives the vertices that stay their numbers in the mesh: cells leaf by leaf, then further sheets.
void Extractor::numberVertices() {
  if (!merger_.active()) {
    cells_kept_ = static_cast<std::uint32_t>(grid_.cellCount());
    return;
  }
  if (!number_) number_ = std::make_unique_for_overwrite<std::uint32_t[]>(grid_.cellCount());
  parallelFor(std::size_t{0}, outputs_.size(), [&](std::size_t i) {
    if (!outputs_[i].changed) return;
    const SurfaceLeaf& leaf = grid_.leaves()[i];
    std::uint32_t kept = 0;
    for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) kept += merger_.standIn(k) == k;
    outputs_[i].vertices = kept;
  });
  cells_kept_ = 0;
  for (LeafOutput& out : outputs_) {
    out.old_vertex = std::exchange(out.first_vertex, cells_kept_);
    cells_kept_ += out.vertices;
  }
}

std::uint32_t Extractor::finalNumber(std::uint32_t v) const {
  if (!merger_.active()) return v;
  if (v >= grid_.cellCount()) return v - static_cast<std::uint32_t>(grid_.cellCount()) + cells_kept_;
  return number_[v];
}

void Extractor::writeVertices(const SurfaceLeaf& leaf, const LeafOutput& out, TriMesh& mesh) {
  const Vec3 origin = impl_.position(leaf.stock->origin);
  const auto write = [&](std::uint32_t number, const Eigen::Vector3f& p) {
    mesh.positions[number] = (origin + impl_.h * p.cast<double>()).cast<float>();
  };
  for (std::uint32_t k = 0; k < leaf.extra.size(); ++k)
    write(finalNumber(leaf.extra_base + k), leaf.extra[k].p);
  if (merger_.active() && !out.changed) return copyVertices(out, mesh);
  std::uint32_t next = merger_.active() ? out.first_vertex : leaf.base;
  for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) {
    if (merger_.active()) {
      if (merger_.standIn(k) != k) continue;
      number_[k] = next;
      cell_at_[next] = k;
    }
    write(next++, grid_.vertex(k));
  }
}

void Extractor::writeLeaf(const SurfaceLeaf& leaf, LeafOutput& out, TriMesh& mesh) const {
  if (out.triangles == 0) return;
  std::size_t next = out.first_triangle;
  out.faults.clear();
  out.poor.clear();
  QuadReader reader(grid_);
  reader.load(leaf);
  const std::uint8_t* state = out.cuts.data();
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    const std::uint8_t cut = *state++;
    if (cut & kApart) return;
    Quad quad;
    reader.readCorners(axis, x, y, z, quad);
    if (cut & kMerged) {
      QuadReader::readCrossing(axis, x, y, z, c, quad);
      next = writeMerged(leaf, quad, c, out, next, mesh);
    } else {
      std::array<std::uint32_t, 4> v;
      for (int i = 0; i < 4; ++i) v[i] = finalNumber(quad.v[i]);
      next = writeQuad(v, cut & kAt02, cut & kPoor, c, out, next, mesh);
    }
  });
}

/// Writes the triangles of a quad from number `next` on; returns the number after them.
std::size_t Extractor::writeQuad(const std::array<std::uint32_t, 4>& v, bool at02, bool poor,
                                 const Crossing& c, LeafOutput& out, std::size_t next, TriMesh& mesh) const {
  mesh.triangles[next] = {v[0], v[1], v[at02 ? 2 : 3]};
  mesh.triangles[next + 1] = {v[at02 ? 0 : 1], v[2], v[3]};
  mesh.motion[next] = mesh.motion[next + 1] = knownMotion(c.motion);
  for (std::size_t t = next; poor && t < next + 2; ++t)
    out.poor.push_back(static_cast<std::uint32_t>(t - out.first_triangle));
  return next + 2;
}

/// The same for a quad with merged corners, judged where those are now. Wants its middle and normal.
std::size_t Extractor::writeMerged(const SurfaceLeaf& leaf, Quad& quad, const Crossing& c, LeafOutput& out,
                                   std::size_t next, TriMesh& mesh) const {
  const Polygon poly = polygon(quad.v);
  if (poly.count == 0) return next;
  std::array<std::uint32_t, 4> v;
  for (int i = 0; i < poly.count; ++i) {
    v[i] = finalNumber(poly.v[i]);
    quad.p[i] = mesh.positions[v[i]].cast<double>();
  }
  quad.middle = impl_.position(leaf.stock->origin) + impl_.h * quad.middle;
  const auto facing = [&](int a, int b, int d) {
    const Vec3 area = (quad.p[b] - quad.p[a]).cross(quad.p[d] - quad.p[a]);
    return quad.normal.dot(area) / (area.norm() + 1e-300);
  };
  double agreement;
  if (poly.count == 3) {
    agreement = facing(0, 1, 2);
    mesh.triangles[next] = {v[0], v[1], v[2]};
    mesh.motion[next] = knownMotion(c.motion);
    if (agreement < kPoorAgreement) out.poor.push_back(static_cast<std::uint32_t>(next - out.first_triangle));
    ++next;
  } else {
    const QuadCut cut = cutQuad(quad.p, quad.middle, quad.normal, 0u);
    agreement =
        cut.at02 ? std::min(facing(0, 1, 2), facing(0, 2, 3)) : std::min(facing(0, 1, 3), facing(1, 2, 3));
    next = writeQuad(v, cut.at02, cut.poor, c, out, next, mesh);
  }
  if (agreement > kLeastAgreement) return next;
  for (int i = 0; i < poly.count; ++i) {
    if (merger_.merged(poly.v[i])) out.faults.push_back(poly.v[i]);
  }
  return next;
}

/// Vertices of the cells of a leaf that did not change, from the mesh before.
void Extractor::copyVertices(const LeafOutput& out, TriMesh& mesh) {
  for (std::uint32_t i = 0; i < out.vertices; ++i) {
    const std::uint32_t cell = old_cell_at_[out.old_vertex + i], next = out.first_vertex + i;
    number_[cell] = next;
    cell_at_[next] = cell;
    mesh.positions[next] = old_mesh_.positions[out.old_vertex + i];
  }
}

/// Its triangles, with the vertices' new numbers.
void Extractor::copyLeaf(const LeafOutput& out, TriMesh& mesh) const {
  const auto old_kept = static_cast<std::uint32_t>(old_cell_at_.size());
  for (std::size_t k = 0; k < out.triangles; ++k) {
    Triangle t = old_mesh_.triangles[out.old_triangle + k];
    if (merger_.active()) {
      for (std::uint32_t& v : t) v = v < old_kept ? number_[old_cell_at_[v]] : v - old_kept + cells_kept_;
    }
    mesh.triangles[out.first_triangle + k] = t;
    mesh.motion[out.first_triangle + k] = old_mesh_.motion[out.old_triangle + k];
  }
}

void Extractor::writeSplits(TriMesh& mesh) {
  std::map<std::array<int, 7>, std::uint32_t> at_face;
  split_at_.clear();
  const SplitQuad* quad = nullptr;
  const auto newVertex = [&](const Eigen::Vector3f& p) {
    mesh.positions.push_back(p);
    split_at_.push_back(quad);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (const LeafOutput& out : outputs_) {
    for (const SplitQuad& split : out.split) {
      quad = &split;
      std::vector<std::uint32_t> ring;
      std::size_t next = 0;
      for (int i = 0; i < 4; ++i) {
        ring.push_back(finalNumber(merger_.standIn(split.v[i])));
        for (; next < split.faces.size() && split.faces[next].after == i; ++next) {
          const auto [it, fresh] = at_face.emplace(split.faces[next].key, 0);
          if (fresh) it->second = newVertex(split.faces[next].p);
          ring.push_back(it->second);
        }
      }
      const std::uint32_t middle = newVertex(split.middle);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
        if (a == b) continue;
        mesh.triangles.push_back({middle, a, b});
        mesh.motion.push_back(split.motion);
      }
    }
  }
}

/// Resizes a vector, with room for `spare` more, whose contents are to be written anew. The system clears
/// fresh pages where they are first touched: by all threads here, and not by the one that fills the vector
/// with zeros.
template <typename T>
void resizeTouched(std::vector<T>& vector, std::size_t size, std::size_t spare) {
  constexpr std::size_t kPage = 4096, kStretch = std::size_t{1} << 21, kGrowth = 64;
  if (size + spare > vector.capacity()) {
    vector.clear();
    vector.reserve(size + spare + size / kGrowth);  // later rounds take a little more
    auto* const bytes = reinterpret_cast<volatile char*>(vector.data());
    const std::size_t count = (size + spare) * sizeof(T);
    parallelFor(std::size_t{0}, count / kStretch + 1, [&](std::size_t i) {
      for (std::size_t k = i * kStretch; k < std::min(count, (i + 1) * kStretch); k += kPage) bytes[k] = 0;
    });
  }
  vector.resize(size);
}

/// Writes the mesh with what is merged now; leaves that did not change are taken from what is in it.
void Extractor::writeMesh(TriMesh& mesh, Progress& progress) {
  std::swap(mesh, old_mesh_);
  std::swap(cell_at_, old_cell_at_);
  numberVertices();
  std::size_t triangles = 0, split_vertices = 0, split_triangles = 0;
  for (LeafOutput& out : outputs_) {
    out.old_triangle = std::exchange(out.first_triangle, triangles);
    triangles += out.triangles;
    for (const SplitQuad& split : out.split) {
      split_vertices += 1 + split.faces.size();
      split_triangles += 4 + split.faces.size();
    }
  }
  if (merger_.active()) resizeTouched(cell_at_, cells_kept_, 0);
  resizeTouched(mesh.positions, cells_kept_ + grid_.vertexCount() - grid_.cellCount(), split_vertices);
  resizeTouched(mesh.triangles, triangles, split_triangles);
  resizeTouched(mesh.motion, triangles, split_triangles);
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { writeVertices(leaf, out, mesh); });
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) {
    if (out.changed) {
      writeLeaf(leaf, out, mesh);
    } else {
      copyLeaf(out, mesh);
    }
  });
  if (!progress.cancelled()) writeSplits(mesh);
}

/// Flags of the vertices of triangles in leaves with this property, and of all fans.
std::vector<std::uint8_t> Extractor::verticesOf(const TriMesh& mesh, bool LeafOutput::*which) const {
  std::vector<std::uint8_t> touched(mesh.positions.size(), 0);
  const auto touch = [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      for (const std::uint32_t v : mesh.triangles[t])
        std::atomic_ref(touched[v]).store(1, std::memory_order_relaxed);
    }
  };
  parallelFor(std::size_t{0}, outputs_.size(), [&](std::size_t i) {
    const LeafOutput& out = outputs_[i];
    if (out.*which) touch(out.first_triangle, out.first_triangle + out.triangles);
  });
  const std::size_t end = outputs_.empty() ? 0 : outputs_.back().first_triangle + outputs_.back().triangles;
  touch(end, mesh.triangles.size());
  return touched;
}

/// Merged cells that spoil the mesh.
std::vector<std::uint32_t> Extractor::findFaults(const TriMesh& mesh,
                                                 const std::vector<std::uint8_t>& touched) const {
  std::vector<std::uint32_t> faults;
  if (!merger_.active()) return faults;
  for (const LeafOutput& out : outputs_) {
    if (out.changed) faults.insert(faults.end(), out.faults.begin(), out.faults.end());
  }
  std::vector<std::uint32_t> watched(mesh.positions.size(), kNoWatch);
  parallelFor(std::size_t{0}, outputs_.size(), [&](std::size_t i) {
    const LeafOutput& out = outputs_[i];
    for (std::uint32_t v = out.first_vertex; v < out.first_vertex + out.vertices; ++v) {
      if (touched[v] != 0 && merger_.merged(cell_at_[v])) watched[v] = cell_at_[v];
    }
  });
  findBrokenFans(mesh, watched, faults);
  return faults;
}

/// Triangles that run through each other. Where the triangles face like the exact surface it does not fold:
/// looked at is what is around those that do not, around fans, and around cells of several sheets.
std::vector<std::array<std::uint32_t, 2>> Extractor::findMeetings(const TriMesh& mesh) const {
  std::vector<std::uint8_t> suspect(mesh.positions.size(), 0);
  const auto mark = [&](std::size_t t) {
    for (const std::uint32_t v : mesh.triangles[t]) suspect[v] = 1;
  };
  std::size_t end = 0;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const LeafOutput& out = outputs_[i];
    end = out.first_triangle + out.triangles;
    if (!out.unchecked) continue;
    for (const std::uint32_t k : out.poor) mark(out.first_triangle + k);
    const SurfaceLeaf& leaf = grid_.leaves()[i];
    for (std::uint32_t k = 0; k < leaf.extra.size(); ++k) {
      suspect[finalNumber(leaf.extra_base + k)] = 1;
      suspect[finalNumber(leaf.base + leaf.extra[k].cell)] = 1;
    }
  }
  // Fans start at their middle; those without places where sheets touch face like the surface.
  const std::size_t first_split = cells_kept_ + grid_.vertexCount() - grid_.cellCount();
  for (std::size_t t = end; t < mesh.triangles.size(); ++t) {
    if (!split_at_[mesh.triangles[t][0] - first_split]->faces.empty()) mark(t);
  }
  return findIntersections(mesh, suspect);
}

/// Cells that a triangle depends on.
void Extractor::addCells(const Triangle& triangle, std::vector<std::uint32_t>& cells) const {
  const std::size_t sheets = grid_.vertexCount() - grid_.cellCount();
  for (const std::uint32_t v : triangle) {
    if (v < cells_kept_) {
      cells.push_back(cellAt(v));
    } else if (v < cells_kept_ + sheets) {
      cells.push_back(grid_.cellOf(v - cells_kept_ + static_cast<std::uint32_t>(grid_.cellCount())));
    } else {
      for (const std::uint32_t corner : split_at_[v - cells_kept_ - sheets]->v)
        cells.push_back(merger_.standIn(grid_.cellOf(corner)));
    }
  }
}

/// Takes merged cells apart whose triangles meet others. False if none is merged.
bool Extractor::part(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  std::vector<std::uint32_t> merged;
  for (const auto& pair : pairs) {
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t t : pair) addCells(mesh.triangles[t], cells);
    std::erase_if(cells, [&](std::uint32_t cell) { return !merger_.merged(cell); });
    merged.insert(merged.end(), cells.begin(), cells.end());
  }
  if (merged.empty()) return false;
  // Triangles that meet and stay as they are must be found again.
  const auto after = [](std::uint32_t t, const LeafOutput& out) { return t < out.first_triangle; };
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const auto next = std::upper_bound(outputs_.begin(), outputs_.end(), t, after);
      (next - 1)->unchecked = true;
    }
  }
  merger_.takeApart(std::move(merged), stale_);
  return true;
}

/// Makes the leaves anew that the stale ones and the surface between them and their neighbours belong to.
void Extractor::update(Progress& progress) {
  std::sort(stale_.begin(), stale_.end());
  stale_.erase(std::unique(stale_.begin(), stale_.end()), stale_.end());
  merger_.assign(stale_);
  for (LeafOutput& out : outputs_) out.changed = false;
  for (const std::int32_t n : stale_) {
    for (int i = 0; i < 7; ++i) {
      const std::int32_t reader = grid_.leaves()[static_cast<std::size_t>(n)].upper[i];
      if (reader >= 0) {
        LeafOutput& out = outputs_[static_cast<std::size_t>(reader)];
        out.changed = out.unchecked = true;
      }
    }
  }
  stale_.clear();
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) {
    if (out.changed) countLeaf(leaf, out);
  });
}

/// Writes the mesh, and again as long as what is merged or placed spoils it. False if cancelled.
bool Extractor::repair(StockSurface& surface, Progress& progress) {
  for (int fault_rounds = 0, part_rounds = 0;; update(progress)) {
    if (progress.cancelled()) return false;
    writeMesh(surface.mesh, progress);
    if (progress.cancelled()) return false;
    std::vector<std::uint32_t> faults =
        findFaults(surface.mesh, verticesOf(surface.mesh, &LeafOutput::changed));
    if (!faults.empty() && ++fault_rounds > kRepairRounds) {
      merger_.giveUp();
      stale_.resize(outputs_.size());
      std::iota(stale_.begin(), stale_.end(), 0);
      continue;
    }
    if (!faults.empty()) {
      merger_.takeApart(std::move(faults), stale_);
      continue;
    }
    const auto pairs = findMeetings(surface.mesh);
    for (LeafOutput& out : outputs_) out.unchecked = false;
    if (pairs.empty()) return true;
    if (++part_rounds <= kPartRounds && part(surface.mesh, pairs)) continue;
    surface.self_intersections = mendIntersections(surface.mesh, pairs, impl_.h);
    return true;
  }
}

Result<StockVolume> Extractor::volume(Progress& progress) {
  const Error hole{ErrorKind::kInternal, "the stock's grid has a hole; please report this job"};
  if (!grid_.build(progress)) return hole;
  if (!progress.cancelled()) unfoldVertices(grid_);
  outputs_.resize(grid_.leaves().size());
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { measureLeaf(leaf, out); });
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  for (const LeafOutput& out : outputs_) {
    if (out.hole) return hole;
  }
  return volumeOfLeaves();
}

Result<StockSurface> Extractor::run(Progress& progress) {
  const Error interrupted{ErrorKind::kInterrupted, "interrupted"};
  const Error hole{ErrorKind::kInternal, "the stock's grid has a hole; please report this job"};
  progress.report("meshing", 0.0);
  if (!grid_.build(progress)) return hole;
  if (progress.cancelled()) return interrupted;
  unfoldVertices(grid_);
  grid_.countThin();
  merger_.mergeLeaves();
  merger_.assign();
  progress.report("meshing", 0.4);
  outputs_.resize(grid_.leaves().size());
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { measureLeaf(leaf, out); });
  if (progress.cancelled()) return interrupted;
  StockSurface surface;
  for (const LeafOutput& out : outputs_) {
    if (out.hole) return hole;
  }
  const StockVolume volume = volumeOfLeaves();
  surface.volume_mm3 = volume.mm3;
  surface.volume_error_mm3 = volume.error_mm3;
  surface.thin_cells = grid_.thinCells();
  surface.first_thin_cell = grid_.firstThinCell();
  progress.report("meshing", 0.7);
  if (!repair(surface, progress)) return interrupted;
  if (impl_.field != nullptr)
    sharpenMesh(surface.mesh, *impl_.field, impl_.h, kSharpShare * simplify_mm_, progress);
  if (progress.cancelled()) return interrupted;
  progress.report("meshing", 1.0);
  return surface;
}

double toleranceOf(const Stock::Impl& impl, const SurfaceOptions& options) {
  return options.simplify_mm < 0.0 ? kDefaultTolerance * impl.h : options.simplify_mm;
}

}  // namespace

Result<StockSurface> extractSurface(const Stock::Impl& impl, const SurfaceOptions& options,
                                    Progress& progress) {
  // A crossing each has two triangles at most, and vertices fewer: far from what 31 bits can number.
  std::size_t crossings = 0;
  for (const StockLeaf& leaf : impl.leaves) crossings += leaf.crossings.size();
  if (crossings > 0x60000000u) {
    return Error{ErrorKind::kResourceLimit,
                 "the surface has more vertices than a mesh can number; take a coarser resolution"};
  }
  return Extractor(impl, toleranceOf(impl, options)).run(progress);
}

Result<StockSurface> Stock::surface(const SurfaceOptions& options, Progress& progress) const {
  const ThreadLimit limit(options.threads);
  try {
    return extractSurface(*impl_, options, progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::kResourceLimit, "not enough memory for the surface; take a coarser resolution"};
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("extracting the surface failed: {}", e.what())};
  }
}

Result<StockVolume> Stock::volume(const SurfaceOptions& options, Progress& progress) const {
  const ThreadLimit limit(options.threads);
  try {
    return Extractor(*impl_, toleranceOf(*impl_, options)).volume(progress);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::kResourceLimit, "not enough memory for the volume; take a coarser resolution"};
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("measuring the stock failed: {}", e.what())};
  }
}

Result<StockSurface> Stock::surface(int threads, Progress& progress) const {
  SurfaceOptions options;
  options.threads = threads;
  return surface(options, progress);
}

}  // namespace proveout
