#include "tests/reference/reference_cut.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/triangle_tree.h"
#include "removal/grid/stock.h"
#include "tests/reference/reference_part.h"
#include "tests/reference/swept_distance.h"

namespace proveout::reference {

namespace {

/// Edges that vertices are told apart by, and those that the engine must show (degrees between facets).
constexpr double kSomeEdge = 8.0, kSharpEdge = 25.0;

/// Edges nearer to each other than this are thinner than what the engine promises.
constexpr double kCrowdCells = 1.5;

struct Cut {
  StockSurface surface;
  double removed_mm3 = 0.0;
};

std::optional<Cut> cutByEngine(const SmallProgram& program, double grid_mm) {
  RemovalOptions options;
  options.resolution_mm = grid_mm;
  options.threads = 1;
  Progress progress;
  auto stock = Stock::create(program.block, options, progress);
  if (!stock || !stock->remove(program.path, program.tools, options, progress).ok()) return std::nullopt;
  SurfaceOptions fine;
  fine.simplify_mm = 0.0;
  fine.threads = 1;
  auto surface = stock->surface(fine, progress);
  if (!surface) return std::nullopt;
  const double removed_mm3 = stock->initialVolume() - surface->volume_mm3;
  return Cut{std::move(*surface), removed_mm3};
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

using Facets = std::vector<ReferencePart::Facet>;

Vec3 normalOf(const ReferencePart::Facet& f) {
  constexpr double kThinnest = 1e-4;  // normals of slivers say nothing
  const auto& [a, b, c] = f.corners;
  const Vec3 n = (b - a).cross(c - a);
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return n.norm() > kThinnest * longest ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
}

struct Edge {
  std::array<Vec3, 2> ends;
  Vec3 normal;  ///< mean of its facets'
};

std::vector<std::array<Vec3, 2>> segmentsOf(const std::vector<Edge>& edges) {
  std::vector<std::array<Vec3, 2>> out;
  for (const Edge& e : edges) out.push_back(e.ends);
  return out;
}

std::vector<Edge> edgesOf(const Facets& facets, double least_deg) {
  std::vector<Vec3> normals;
  for (const auto& f : facets) normals.push_back(normalOf(f));
  std::vector<Edge> out;
  const double most = std::cos(degToRad(least_deg));
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = static_cast<std::size_t>(facets[i].beside[k]);
      if (other < i || normals[i].isZero() || normals[other].isZero()) continue;
      if (normals[i].dot(normals[other]) < most)
        out.push_back({{facets[i].corners[k], facets[i].corners[(k + 1) % 3]},
                       (normals[i] + normals[other]).normalized()});
    }
  }
  return out;
}

/// Edges farther from others than the grid can tell apart, and the rest. Pieces of one curve do not count:
/// they turn no more than a circle of this radius does.
struct SortedEdges {
  std::vector<Edge> alone, crowded;
};

bool isOneCurve(const std::array<Vec3, 2>& edge, const std::array<Vec3, 2>& other) {
  constexpr double kLeastRadius = 1.5, kSame = 5e-3, kParallel = 0.9;
  const Vec3 along = (edge[1] - edge[0]).normalized(), to = 0.5 * (other[0] + other[1] - edge[0] - edge[1]);
  const double way = along.dot(to), beside = (to - way * along).norm();
  return std::abs(along.dot((other[1] - other[0]).normalized())) > kParallel &&
         beside < kSame + way * way / (2.0 * kLeastRadius);
}

SortedEdges sortEdges(const std::vector<Edge>& edges, double within) {
  constexpr double kShortest = 1e-4;  // shorter ones have no direction
  std::vector<Edge> sorted;
  double longest = 0.0;
  for (const Edge& e : edges) {
    const double length = (e.ends[1] - e.ends[0]).norm();
    if (length > kShortest) sorted.push_back(e);
    longest = std::max(longest, length);
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Edge& a, const Edge& b) { return a.ends[0].x() < b.ends[0].x(); });
  SortedEdges out;
  for (const Edge& edge : sorted) {
    const auto& e = edge.ends;
    auto other = std::lower_bound(sorted.begin(), sorted.end(), e[0].x() - within - longest,
                                  [](const Edge& s, double x) { return s.ends[0].x() < x; });
    bool alone = true;
    for (; alone && other != sorted.end() && other->ends[0].x() < e[0].x() + within + longest; ++other) {
      const auto& o = other->ends;
      const double apart = std::min((o[0] - e[0]).norm(), (o[1] - e[1]).norm());
      alone = apart > within || isOneCurve(e, o);
    }
    (alone ? out.alone : out.crowded).push_back(edge);
  }
  return out;
}

struct Worst {
  double off = 0.0;
  Vec3 where = Vec3::Zero();
  void see(double distance, const Vec3& p) {
    if (distance > off) off = distance, where = p;
  }
  std::string text() const {
    return fmt::format("{:.1f} um at {:.3f} {:.3f} {:.3f}", 1e3 * off, where.x(), where.y(), where.z());
  }
};

void compareSurfaces(const TriMesh& mesh, const Facets& facets, const ExactPart& exact, double grid_mm,
                     Comparison& out) {
  const TriangleTree ours(toSurface(mesh));
  const std::vector<Edge> edges = edgesOf(facets, kSomeEdge);
  const double crowd = kCrowdCells * grid_mm;
  const DistanceToEdges to_edges(segmentsOf(edges)), to_crowded(segmentsOf(sortEdges(edges, crowd).crowded));
  Worst face, edge, missed;
  for (const auto& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    if (to_crowded.at(p) < crowd) {
      ++out.crowded;
      continue;
    }
    (to_edges.at(p) < grid_mm ? edge : face).see(exact.off(p), p);
    ++out.vertices;
  }
  for (const Edge& e : sortEdges(edgesOf(facets, kSharpEdge), crowd).alone) {
    const Vec3 middle = exact.onEdge(0.5 * (e.ends[0] + e.ends[1]), e.normal);
    if (to_crowded.at(middle) > crowd) missed.see(std::sqrt(ours.nearest(middle).squared), middle);
  }
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

std::optional<Comparison> compareWithReference(const SmallProgram& program, double grid_mm, int facets) {
  const std::optional<Cut> cut = cutByEngine(program, grid_mm);
  if (!cut) return std::nullopt;
  const auto coarse = removedByReference(program, facets / 2);
  const auto fine = coarse ? cutByReference(program, facets) : std::nullopt;
  if (!fine) return std::nullopt;
  Comparison out;
  out.removed_mm3 = cut->removed_mm3;
  out.told = cut->surface.volume_error_mm3 / cut->removed_mm3;
  out.thin_cells = cut->surface.thin_cells;
  const double removed = volumeOf(program.block) - fine->volume();
  out.more = cut->removed_mm3 / removed - 1.0;
  out.unsure = std::abs(removed - *coarse) / removed / 2.0;
  compareSurfaces(cut->surface.mesh, fine->facets(), ExactPart(program), grid_mm, out);
  return out;
}

}  // namespace proveout::reference
