#include "tests/reference/reference_cut.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/triangle_tree.h"
#include "removal/grid/stock.h"
#include "tests/reference/reference_edges.h"
#include "tests/reference/swept_distance.h"
#include "tests/reference/thin_walls.h"

namespace proveout::reference {

namespace {

/// Edges that vertices are told apart by, and those that the engine must show (degrees between facets).
constexpr double kSomeEdge = 8.0, kSharpEdge = 25.0;

/// Edges nearer to each other than this are thinner than what the engine promises.
constexpr double kCrowdCells = 1.5;

/// Walls and gaps that are thinner than this are thin, and what is nearer to them than that may be off.
constexpr double kThinCells = 1.0, kBesideCells = 2.0;
/// Whether something is beside them is asked of what is farther off, mm.
constexpr double kOff = 2e-3;

/// Before the engine is said to be wrong the reference is cut again with facets half as large, and again, but
/// not with more than these around a tool: that two sizes agree may be chance.
constexpr int kMostFacets = 200;

struct Cut {
  StockSurface surface;
  RemovalSummary removal;
  double removed_mm3 = 0.0;
};

std::optional<Cut> cutByEngine(const SmallProgram& program, double grid_mm) {
  RemovalOptions options;
  options.resolution_mm = grid_mm;
  options.threads = 1;
  Progress progress;
  auto stock = Stock::create(program.block, options, progress);
  if (!stock) return std::nullopt;
  SurfaceOptions fine;
  fine.simplify_mm = 0.0;
  fine.threads = 1;
  const auto before = stock->volume(fine, progress);  // the same integral as after it
  if (!before) return std::nullopt;
  auto removal = stock->remove(program.path, program.tools, options, progress);
  if (!removal) return std::nullopt;
  auto surface = stock->surface(fine, progress);
  if (!surface) return std::nullopt;
  const double removed_mm3 = before->mm3 - surface->volume_mm3 - surface->unseen_mm3;
  return Cut{std::move(*surface), std::move(*removal), removed_mm3};
}

std::optional<ReferencePart> cutOnce(const SmallProgram& program, double step_rad) {
  ReferencePart part(program.block);
  for (std::size_t i = 0; i < program.path.motions.size(); ++i) {
    const Tool& tool = program.tools[static_cast<std::size_t>(program.path.motions[i].tool - 1)];
    for (const Section& section : sectionsOf(tool)) {
      for (const Polyhedron& solid : sweep(section, program.path, i, step_rad)) {
        if (!part.subtract(solid)) return std::nullopt;
      }
    }
  }
  return part;
}

std::optional<ReferencePart> cutByReference(const SmallProgram& program, int facets) {
  for (const double part : {1.0, 0.97, 0.93}) {
    auto cut = cutOnce(program, part * 2 * kPi / facets);
    if (cut) return cut;
  }
  return std::nullopt;
}

double volumeOf(const BoxShape& block) { return (block.max - block.min).prod(); }

struct Worst {
  double off = 0.0;
  Vec3 where = Vec3::Zero();
  void see(double distance, const Vec3& p) {
    constexpr double kSame = 1e-9;
    const bool first = std::lexicographical_compare(p.begin(), p.end(), where.begin(), where.end());
    if (distance > off + kSame || (distance > off - kSame && first)) off = distance, where = p;
  }
  std::string text() const {
    return fmt::format("{:.1f} um at {:.3f} {:.3f} {:.3f}", 1e3 * off, where.x(), where.y(), where.z());
  }
};

/// The worst of what is not beside thin walls.
class Judge {
 public:
  Judge(const std::vector<ReferencePart::Facet>& facets, double grid_mm)
      : walls_(facets, kThinCells * grid_mm), beside_(kBesideCells * grid_mm) {}

  void see(double distance, const Vec3& p, Worst& worst) {
    if (distance > kOff && walls_.isNear(p, beside_)) {
      ++beside_thin_;
    } else {
      worst.see(distance, p);
    }
  }
  std::size_t besideThin() const { return beside_thin_; }

 private:
  ThinWalls walls_;
  double beside_;
  std::size_t beside_thin_ = 0;
};

void compareSurfaces(const TriMesh& mesh, const std::vector<ReferencePart::Facet>& facets,
                     const ExactPart& exact, double grid_mm, Comparison& out) {
  const TriangleTree ours(toSurface(mesh));
  const std::vector<ReferenceEdge> edges = edgesOf(facets, kSomeEdge);
  const double crowd = kCrowdCells * grid_mm;
  const DistanceToEdges to_edges(segmentsOf(edges)), to_crowded(segmentsOf(sortEdges(edges, crowd).crowded));
  Judge judge(facets, grid_mm);
  Worst face, edge, missed;
  for (const auto& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    if (to_crowded.at(p) < crowd) {
      ++out.crowded;
      continue;
    }
    judge.see(exact.off(p), p, to_edges.at(p) < grid_mm ? edge : face);
    ++out.vertices;
  }
  for (const ReferenceEdge& e : sortEdges(edgesOf(facets, kSharpEdge), crowd).alone) {
    const Vec3 middle = exact.onEdge(0.5 * (e.ends[0] + e.ends[1]), e.normal);
    if (to_crowded.at(middle) > crowd) judge.see(std::sqrt(ours.nearest(middle).squared), middle, missed);
  }
  out.beside_thin = judge.besideThin();
  out.face_mm = face.off;
  out.edge_mm = edge.off;
  out.missed_mm = missed.off;
  out.places =
      fmt::format("faces {}, beside edges {}, edges missed {}", face.text(), edge.text(), missed.text());
}

}  // namespace

std::optional<double> removedByReference(const SmallProgram& program, int facets) {
  const auto part = cutByReference(program, facets);
  if (!part) return std::nullopt;
  return volumeOf(program.block) - part->volume();
}

std::optional<Comparison> compareWithReference(const SmallProgram& program, double grid_mm, int facets,
                                               double aim) {
  const std::optional<Cut> cut = cutByEngine(program, grid_mm);
  if (!cut) return std::nullopt;
  Comparison out;
  out.removed_mm3 = cut->removed_mm3;
  out.told = (cut->surface.volume_error_mm3 + cut->removal.lost_mm3) / cut->removed_mm3;
  out.thin_cells = cut->surface.thin_cells;
  out.film_mm2 = cut->removal.lost_film_mm2;
  std::optional<double> coarse = removedByReference(program, facets / 2);
  std::optional<ReferencePart> fine;
  const auto disagree = [&] { return std::abs(out.more) > aim + out.told; };
  do {
    if (fine) facets *= 2;
    fine = coarse ? cutByReference(program, facets) : std::nullopt;
    if (!fine) return std::nullopt;
    const double removed = volumeOf(program.block) - fine->volume();
    out.more = cut->removed_mm3 / removed - 1.0;
    out.unsure = std::abs(removed - *coarse) / removed / 2.0;
    coarse = removed;
  } while (2 * facets <= kMostFacets && disagree());
  out.facets = facets;
  compareSurfaces(cut->surface.mesh, fine->facets(), ExactPart(program), grid_mm, out);
  return out;
}

}  // namespace proveout::reference
