#include "removal/compare/shell_sides.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/place_text.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {
namespace {

constexpr std::uint32_t kNoFacet = 0xFFFFFFFFu;
/// Of the area of a sheet: where more than this faces the other way, neither can be told to be meant.
constexpr double kDoubtful = 0.25;
/// On another shell, mm: some roundings of float coordinates.
constexpr double kOnShellMm = 1e-4;

/// The other triangle at a half-edge.
struct FacetLink {
  std::uint32_t to = kNoFacet;
  bool same_way = false;  ///< both use the edge in the same direction: one has to turn
};

class FacetLinks {
 public:
  explicit FacetLinks(const TriMesh& mesh) : mesh_(mesh), links_(3 * mesh.triangles.size()) {
    const EdgeTable edges(mesh.positions.size(), mesh.triangles);
    DisjointSets sheets(mesh.triangles.size());
    edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
      if (last - first != 2) return;
      link(low, first[0].half_edge, first[1].half_edge);
      sheets.join(first[0].half_edge / 3, first[1].half_edge / 3);
    });
    edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
      if (last - first > 2) linkWithinSheets(low, first, last, sheets);
    });
  }
  const FacetLink& at(std::uint32_t t, std::uint32_t corner) const { return links_[3 * t + corner]; }

 private:
  void link(std::uint32_t low, std::uint32_t a, std::uint32_t b) {
    const auto up = [&](std::uint32_t h) { return mesh_.triangles[h / 3][h % 3] == low; };
    links_[a] = {b / 3, up(a) == up(b)};
    links_[b] = {a / 3, up(a) == up(b)};
  }
  void linkWithinSheets(std::uint32_t low, const HalfEdge* first, const HalfEdge* last,
                        DisjointSets& sheets) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_sheet;
    for (const HalfEdge* h = first; h < last; ++h)
      of_sheet[sheets.find(h->half_edge / 3)].push_back(h->half_edge);
    for (const auto& [sheet, own] : of_sheet) {
      if (own.size() == 2) link(low, own[0], own[1]);
    }
  }

  const TriMesh& mesh_;
  std::vector<FacetLink> links_;
};

/// Triangles that hang together, and which of them have to turn to agree with the first.
struct Sheet {
  std::vector<std::uint32_t> triangles;
  bool two_sided = true;
};

Sheet walkSheet(const FacetLinks& links, std::uint32_t seed, std::vector<signed char>& turned) {
  Sheet sheet;
  turned[seed] = 0;
  sheet.triangles.push_back(seed);
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    const std::uint32_t t = sheet.triangles[i];
    for (std::uint32_t c = 0; c < 3; ++c) {
      const FacetLink& link = links.at(t, c);
      if (link.to == kNoFacet) continue;
      const signed char wanted = link.same_way ? 1 - turned[t] : turned[t];
      if (turned[link.to] < 0) {
        turned[link.to] = wanted;
        sheet.triangles.push_back(link.to);
      } else if (turned[link.to] != wanted) {
        sheet.two_sided = false;
      }
    }
  }
  return sheet;
}

/// A shell as the others see it.
struct ShellProbe {
  explicit ShellProbe(const TriMesh& shell) : ShellProbe(shell, toSurface(shell)) {}
  ShellProbe(const TriMesh& shell, const SurfaceMesh& surface)
      : tree(surface), box(meshBounds(shell)), volume(meshVolume(shell)) {
    constexpr std::size_t kPlaces = 16;
    const std::size_t step = std::max<std::size_t>(1, shell.positions.size() / kPlaces);
    for (std::size_t i = 0; i < shell.positions.size(); i += step) places.push_back(surface.points[i]);
    const std::size_t over = std::max<std::size_t>(1, shell.triangles.size() / kPlaces);
    for (std::size_t t = 0; t < shell.triangles.size(); t += over) places.push_back(surface.middle(t));
  }
  /// Whether it goes round all of the other. A place on this shell is no evidence.
  bool encloses(const ShellProbe& other) const {
    if ((other.box.min.array() < box.min.array()).any() || (other.box.max.array() > box.max.array()).any())
      return false;
    constexpr double kInside = 0.75;
    bool any = false;
    for (const Vec3& p : other.places) {
      if (tree.nearest(p, TriangleTree::kNone, kOnShellMm).triangle != TriangleTree::kNone) continue;
      if (std::abs(tree.windingNumber(p)) <= kInside) return false;
      any = true;
    }
    return any;
  }
  TriangleTree tree;
  Box3 box;
  double volume;
  std::vector<Vec3> places;  ///< on it
};

/// Which shells each one is in.
std::vector<std::vector<std::uint32_t>> findShellsAround(const std::vector<ShellProbe>& probes) {
  std::vector<Box3> boxes;
  for (const ShellProbe& probe : probes) boxes.push_back(probe.box);
  const BoxTree near(boxes);
  std::vector<std::vector<std::uint32_t>> around(probes.size());
  for (std::uint32_t s = 0; s < probes.size(); ++s) {
    near.forEachPlace(boxes[s], [&](std::uint32_t place) {
      const std::uint32_t other = near.order()[place];
      if (other == s || !probes[other].encloses(probes[s])) return;
      // Two of the same shape go round each other.
      if (probes[s].encloses(probes[other]) && other > s) return;
      around[s].push_back(other);
    });
  }
  return around;
}

/// 1: it shall enclose material, -1: a void.
struct Signs {
  std::vector<int> of;
  std::vector<char> doubtful;
};

Signs signsOf(const Shells& shells, const std::vector<ShellProbe>& probes,
              const std::vector<char>& doubtful) {
  PROVEOUT_ASSERT(doubtful.empty() || doubtful.size() == shells.shell_of.size());
  Signs signs;
  for (const ShellProbe& probe : probes) signs.of.push_back(probe.volume < 0.0 ? -1 : 1);
  signs.doubtful.assign(shells.count, 0);
  for (std::size_t t = 0; t < doubtful.size(); ++t) signs.doubtful[shells.shell_of[t]] |= doubtful[t];
  return signs;
}

}  // namespace

std::optional<TurnedFacets> makeConsistent(TriMesh& mesh) {
  const FacetLinks links(mesh);
  const SurfaceMesh surface = toSurface(mesh);
  std::vector<signed char> turned(mesh.triangles.size(), -1);
  TurnedFacets out;
  out.doubtful.assign(mesh.triangles.size(), 0);
  for (std::uint32_t seed = 0; seed < turned.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    const Sheet sheet = walkSheet(links, seed, turned);
    if (!sheet.two_sided) return std::nullopt;
    double as_first = 0.0, against = 0.0;
    for (const std::uint32_t t : sheet.triangles)
      (turned[t] > 0 ? against : as_first) += surface.areaVector(t).norm();
    const bool others = against > as_first;
    const bool doubtful = std::min(as_first, against) > kDoubtful * (as_first + against);
    for (const std::uint32_t t : sheet.triangles) {
      if (others) turned[t] = static_cast<signed char>(1 - turned[t]);
      out.doubtful[t] = doubtful;
    }
  }
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] == 0) continue;
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++out.turned;
  }
  return out;
}

Result<TurnedShells> orientShells(Shells& shells, const std::vector<char>& doubtful,
                                  const std::string& name) {
  std::vector<ShellProbe> probes;
  probes.reserve(shells.count);
  for (const TriMesh& shell : shellMeshes(shells)) probes.emplace_back(shell);
  PROVEOUT_ASSERT(probes.size() == shells.count);
  const auto around = findShellsAround(probes);
  std::vector<std::vector<std::uint32_t>> inside(shells.count);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    for (const std::uint32_t other : around[s]) inside[other].push_back(s);
  }
  std::vector<std::uint32_t> order(shells.count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return around[a].size() < around[b].size(); });
  Signs signs = signsOf(shells, probes, doubtful);
  TurnedShells out;
  for (const std::uint32_t s : order) {
    const int material = std::accumulate(around[s].begin(), around[s].end(), 0,
                                         [&](int sum, std::uint32_t other) { return sum + signs.of[other]; });
    if (signs.doubtful[s] && material > 0) {
      return inputError(fmt::format(
          "{}: the facets of a shell inside of a body, at {} mm, face both ways: it may be a body or a void; "
          "export the mesh again as a closed solid",
          name, placeText(probes[s].places.front())));
    }
    if (material <= 0 && signs.of[s] < 0) {
      signs.of[s] = 1;
      if (signs.doubtful[s]) continue;  // nothing is known of what is in it
      for (const std::uint32_t other : inside[s]) signs.of[other] = -signs.of[other];
    }
    if (material > 0 && signs.of[s] > 0 && out.within++ == 0) out.first_within = probes[s].places.front();
  }
  std::vector<char> turn(shells.count);
  for (std::uint32_t s = 0; s < shells.count; ++s) turn[s] = (probes[s].volume < 0.0) != (signs.of[s] < 0);
  for (std::size_t t = 0; t < shells.shell_of.size(); ++t) {
    if (turn[shells.shell_of[t]]) std::swap(shells.mesh.triangles[t][1], shells.mesh.triangles[t][2]);
  }
  out.turned = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), 1));
  return out;
}

}  // namespace proveout
