// Dual contouring: one vertex per sheet and cell, one polygon per crossed grid edge.
#include "removal/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <map>

#include "core/base/parallel_for.h"
#include "removal/quad_volume.h"
#include "removal/surface_faults.h"
#include "removal/surface_merge.h"
#include "removal/surface_quads.h"
#include "removal/surface_splits.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Part of the tolerance that the heights of a merged patch may take: a triangle between the middles of
/// patches leaves the surface as much as each patch leaves its plane, and normals turn in between.
constexpr double kFlatnessShare = 0.5;
constexpr double kDefaultTolerance = 0.1;  ///< of the grid spacing
/// Rounds of taking merged cells apart where they spoil the mesh, before all merging is given up.
constexpr int kRepairRounds = 12;
/// Triangles of merged vertices that lean more than this (73 degrees) from the exact surface are refused.
constexpr double kLeastAgreement = 0.3;

struct LeafOutput {
  double volume = 0.0;  ///< of the cones from the centre, grid steps^3
  std::uint32_t triangles = 0, vertices = 0;
  std::size_t first_triangle = 0;
  std::uint32_t first_vertex = 0;
  bool hole = false;  ///< a crossing without its four cells: a bug
  std::vector<SplitQuad> split;
  std::vector<std::uint32_t> faults;  ///< merged vertices of triangles that face the wrong way
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
        merger_(grid_, kFlatnessShare * simplify_mm / impl.h) {}

  Result<StockSurface> run(Progress& progress);

 private:
  template <typename Body>
  void eachLeaf(Progress& progress, Body&& body);
  Polygon polygon(const std::array<std::uint32_t, 4>& v) const;
  void measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const;
  void countLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const;
  void numberVertices();
  void writeVertices(const SurfaceLeaf& leaf, const LeafOutput& out, TriMesh& mesh);
  void writeLeaf(const SurfaceLeaf& leaf, LeafOutput& out, TriMesh& mesh) const;
  void writeSplits(TriMesh& mesh) const;
  bool writeMesh(TriMesh& mesh, Progress& progress);
  std::uint32_t finalNumber(std::uint32_t v) const;

  const Stock::Impl& impl_;
  SurfaceGrid grid_;
  VertexMerger merger_;
  std::vector<LeafOutput> outputs_;
  std::unique_ptr<std::uint32_t[]> number_;  ///< a cell whose vertex stands for itself: its place in the mesh
  std::uint32_t cells_kept_ = 0;
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

/// Volume and split quads: they do not depend on what is merged.
void Extractor::measureLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const {
  const Vec3 center = (impl_.blank.center() - impl_.position(leaf.stock->origin)) / impl_.h;
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    if (!reader.read(axis, x, y, z, c, quad)) {
      out.hole = true;
      return;
    }
    out.volume += quadVolume(quad.p, quad.middle, quad.normal, center);
    if (quad.split != 0) {
      out.split.push_back(splitQuad(grid_, leaf, axis, x, y, z, quad, c));
      return;
    }
    if (const int corners = polygon(quad.v).count; corners > 0) {
      out.triangles += static_cast<std::uint32_t>(corners - 2);
    }
  });
}

void Extractor::countLeaf(const SurfaceLeaf& leaf, LeafOutput& out) const {
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  out.triangles = 0;
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    reader.read(axis, x, y, z, c, quad);
    if (quad.split != 0) return;
    if (const int corners = polygon(quad.v).count; corners > 0) {
      out.triangles += static_cast<std::uint32_t>(corners - 2);
    }
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
    const SurfaceLeaf& leaf = grid_.leaves()[i];
    outputs_[i].vertices = 0;
    for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k)
      outputs_[i].vertices += merger_.standIn(k) == k;
  });
  cells_kept_ = 0;
  for (LeafOutput& out : outputs_) {
    out.first_vertex = cells_kept_;
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
  std::uint32_t next = merger_.active() ? out.first_vertex : leaf.base;
  for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) {
    if (merger_.active()) {
      if (merger_.standIn(k) != k) continue;
      number_[k] = next;
    }
    write(next++, grid_.vertex(k));
  }
  for (std::uint32_t k = 0; k < leaf.extra.size(); ++k)
    write(finalNumber(leaf.extra_base + k), leaf.extra[k].p);
}

void Extractor::writeLeaf(const SurfaceLeaf& leaf, LeafOutput& out, TriMesh& mesh) const {
  if (out.triangles == 0) return;
  std::size_t next = out.first_triangle;
  out.faults.clear();
  QuadReader reader(grid_);
  reader.load(leaf);
  Quad quad;
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    reader.read(axis, x, y, z, c, quad);
    if (quad.split != 0) return;
    const Polygon poly = polygon(quad.v);
    if (poly.count == 0) return;
    std::array<std::uint32_t, 4> v;
    bool merged = false;
    for (int i = 0; i < poly.count; ++i) {
      v[i] = finalNumber(poly.v[i]);
      merged = merged || merger_.merged(poly.v[i]);
    }
    double agreement = 1.0;
    const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
      mesh.triangles[next] = {a, b, d};
      mesh.motion[next++] = c.motion;
    };
    if (merged) {
      for (int i = 0; i < poly.count; ++i) quad.p[i] = mesh.positions[v[i]].cast<double>();
      quad.middle = impl_.position(leaf.stock->origin) + impl_.h * quad.middle;
    }
    if (poly.count == 3) {
      const Vec3 area = (quad.p[1] - quad.p[0]).cross(quad.p[2] - quad.p[0]);
      agreement = quad.normal.dot(area) / (area.norm() + 1e-300);
      put(v[0], v[1], v[2]);
    } else {
      const bool smooth = !merged && (quad.all_traits & CellTraits::kSmooth) != 0;
      const QuadCut cut = cutQuad(quad.p, quad.middle, quad.normal, smooth);
      const auto facing = [&](int a, int b, int d) {
        const Vec3 area = (quad.p[b] - quad.p[a]).cross(quad.p[d] - quad.p[a]);
        return quad.normal.dot(area) / (area.norm() + 1e-300);
      };
      if (merged) {
        agreement = cut.at02 ? std::min(facing(0, 1, 2), facing(0, 2, 3))
                             : std::min(facing(0, 1, 3), facing(1, 2, 3));
      }
      put(v[0], v[1], v[cut.at02 ? 2 : 3]);
      put(v[cut.at02 ? 0 : 1], v[2], v[3]);
    }
    if (!merged || agreement > kLeastAgreement) return;
    for (int i = 0; i < poly.count; ++i) {
      if (merger_.merged(poly.v[i])) out.faults.push_back(poly.v[i]);
    }
  });
}

void Extractor::writeSplits(TriMesh& mesh) const {
  std::map<std::array<int, 7>, std::uint32_t> at_face;
  const auto newVertex = [&](const Eigen::Vector3f& p) {
    mesh.positions.push_back(p);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (const LeafOutput& out : outputs_) {
    for (const SplitQuad& split : out.split) {
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

/// Writes the mesh with what is merged now; false if that spoils it, after taking the places apart.
bool Extractor::writeMesh(TriMesh& mesh, Progress& progress) {
  numberVertices();
  std::size_t triangles = 0;
  for (LeafOutput& out : outputs_) {
    out.first_triangle = triangles;
    triangles += out.triangles;
  }
  mesh.positions.resize(cells_kept_ + grid_.vertexCount() - grid_.cellCount());
  mesh.triangles.resize(triangles);
  mesh.motion.resize(triangles);
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { writeVertices(leaf, out, mesh); });
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { writeLeaf(leaf, out, mesh); });
  if (progress.cancelled()) return true;
  writeSplits(mesh);
  if (!merger_.active()) return true;
  std::vector<std::uint32_t> faults;
  for (const LeafOutput& out : outputs_) faults.insert(faults.end(), out.faults.begin(), out.faults.end());
  std::vector<std::uint32_t> cell_of(mesh.positions.size(), kNoWatch);
  parallelFor(std::size_t{0}, outputs_.size(), [&](std::size_t i) {
    const SurfaceLeaf& leaf = grid_.leaves()[i];
    for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) {
      if (merger_.standIn(k) == k && merger_.merged(k)) cell_of[number_[k]] = k;
    }
  });
  findBrokenFans(mesh, cell_of, faults);
  if (faults.empty()) return true;
  merger_.takeApart(std::move(faults));
  return false;
}

Result<StockSurface> Extractor::run(Progress& progress) {
  const Error interrupted{ErrorKind::kInterrupted, "interrupted"};
  const Error hole{ErrorKind::kInternal, "the stock's grid has a hole; please report this job"};
  progress.report("meshing", 0.0);
  if (!grid_.build(progress)) return hole;
  if (progress.cancelled()) return interrupted;
  unfoldVertices(grid_);
  merger_.mergeLeaves();
  merger_.assign();
  progress.report("meshing", 0.4);
  outputs_.resize(grid_.leaves().size());
  eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { measureLeaf(leaf, out); });
  if (progress.cancelled()) return interrupted;
  StockSurface surface;
  for (const LeafOutput& out : outputs_) {
    if (out.hole) return hole;
    surface.volume_mm3 += out.volume;
  }
  surface.volume_mm3 *= impl_.h * impl_.h * impl_.h;
  surface.thin_cells = grid_.thinCells();
  surface.first_thin_cell = grid_.firstThinCell();
  progress.report("meshing", 0.7);
  for (int round = 0; !writeMesh(surface.mesh, progress); ++round) {
    if (round == kRepairRounds) merger_.giveUp();
    merger_.assign();
    eachLeaf(progress, [&](const SurfaceLeaf& leaf, LeafOutput& out) { countLeaf(leaf, out); });
    if (progress.cancelled()) return interrupted;
  }
  if (progress.cancelled()) return interrupted;
  progress.report("meshing", 1.0);
  return surface;
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
  const double tolerance = options.simplify_mm < 0.0 ? kDefaultTolerance * impl.h : options.simplify_mm;
  return Extractor(impl, tolerance).run(progress);
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

Result<StockSurface> Stock::surface(int threads, Progress& progress) const {
  SurfaceOptions options;
  options.threads = threads;
  return surface(options, progress);
}

}  // namespace proveout
