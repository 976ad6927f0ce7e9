#include "removal/compare/nominal.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/geometry/box_tree.h"
#include "core/geometry/place_text.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "removal/compare/compare.h"
#include "removal/compare/join_bodies.h"

namespace proveout {

namespace {

/// The range of the job's own lengths, 1 km: beyond it a float is good to 0.06 mm at best.
constexpr double kLargestMm = 1e6;

}  // namespace

std::optional<Error> findBadElements(const TriMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) return inputError(name + ": the mesh has no triangles");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].allFinite()) continue;
    return inputError(
        fmt::format("{}: vertex {} is not a finite number; export the mesh again", name, i + 1));
  }
  const Box3 box = meshBounds(mesh);
  const double most = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  if (most > kLargestMm) {
    return inputError(
        fmt::format("{}: the mesh reaches as far as {:.4g} mm, and coordinates go up to {:g} mm: "
                    "is its unit right?",
                    name, most, kLargestMm));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (triangleIsProper(mesh.triangles[i], mesh.positions.size())) continue;
    return inputError(fmt::format(
        "{}: triangle {} names a vertex twice or one that is not there; export the mesh again", name, i + 1));
  }
  if (!mesh.motion.empty() && mesh.motion.size() != mesh.triangles.size()) {
    return Error{ErrorKind::kInternal, name + ": one motion per triangle is needed, or none"};
  }
  return std::nullopt;
}

OpenEdges findOpenEdges(const TriMesh& mesh) {
  OpenEdges out;
  Vec3 first_opposed = Vec3::Zero();
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    std::ptrdiff_t balance = 0;
    for (const HalfEdge* h = first; h < last; ++h) {
      balance += mesh.triangles[h->half_edge / 3][h->half_edge % 3] == low ? 1 : -1;
    }
    if (balance == 0) return;
    const Vec3 middle = 0.5 * (mesh.positions[low] + mesh.positions[first->other]).cast<double>();
    if ((last - first) % 2 != 0) {
      if (out.odd++ == 0) out.first = middle;
    } else if (out.opposed++ == 0) {
      first_opposed = middle;
    }
  });
  if (out.odd == 0) out.first = first_opposed;
  return out;
}

namespace nominal_detail {

using Indices = std::array<std::uint32_t, 3>;

void dropCollapsed(TriMesh& mesh, const std::vector<char>& drop) {
  const bool has_motion = !mesh.motion.empty();
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (drop[t]) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    if (has_motion) mesh.motion[kept] = mesh.motion[t];
    ++kept;
  }
  mesh.triangles.resize(kept);
  if (has_motion) mesh.motion.resize(kept);
}

/// Of triangles over the same three vertices keeps one, or none where two face each other.
std::size_t dropDoubled(TriMesh& mesh) {
  std::vector<std::pair<Indices, std::uint32_t>> keys(mesh.triangles.size());
  for (std::uint32_t t = 0; t < keys.size(); ++t) {
    keys[t] = {mesh.triangles[t], t};
    std::sort(keys[t].first.begin(), keys[t].first.end());
  }
  std::sort(keys.begin(), keys.end());
  const auto isEven = [&](std::uint32_t t) {  // same turning sense as the sorted indices
    const Indices& v = mesh.triangles[t];
    return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
  };
  std::vector<char> drop(mesh.triangles.size(), 0);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t j = i + 1;
    while (j < keys.size() && keys[j].first == keys[i].first) ++j;
    bool even = false, odd = false;
    for (std::size_t k = i; k < j; ++k) (isEven(keys[k].second) ? even : odd) = true;
    for (std::size_t k = i; k < j; ++k) {
      if (j - i < 2 || (k == i && !(even && odd))) continue;
      drop[keys[k].second] = 1;
      ++dropped;
    }
    i = j;
  }
  if (dropped > 0) dropCollapsed(mesh, drop);
  return dropped;
}

/// Merges border vertices that lie within `tolerance` of each other. Returns how many were merged.
std::size_t mergeNearBorders(TriMesh& mesh, double tolerance) {
  std::set<std::uint32_t> border;
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    if (last - first == 1) border.insert({low, first->other});
  });
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::map<Cell, std::vector<std::uint32_t>> cells;
  std::map<std::uint32_t, std::uint32_t> target;
  for (const std::uint32_t v : border) {
    const Vec3 p = mesh.positions[v].cast<double>();
    const Eigen::Array<std::int64_t, 3, 1> c = (p / tolerance).array().floor().cast<std::int64_t>();
    std::uint32_t found = v;
    for (int n = 0; n < 27 && found == v; ++n) {
      const auto cell = cells.find({c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1});
      if (cell == cells.end()) continue;
      for (const std::uint32_t w : cell->second) {
        if ((mesh.positions[w].cast<double>() - p).norm() <= tolerance) found = w;
      }
    }
    if (found == v) {
      cells[{c[0], c[1], c[2]}].push_back(v);
    } else {
      target[v] = found;
    }
  }
  if (target.empty()) return 0;
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (auto& v : mesh.triangles[t]) {
      if (const auto it = target.find(v); it != target.end()) v = it->second;
    }
    drop[t] = !triangleIsProper(mesh.triangles[t], mesh.positions.size());
  }
  dropCollapsed(mesh, drop);
  return target.size();
}

/// Turns facets so that neighbours agree with the first triangle of their shell. False where they cannot (a
/// surface with one side only, or edges of more than two facets).
bool makeConsistent(TriMesh& mesh) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Link {
    std::uint32_t to = kNone;
    bool same_way = false;  ///< both use the edge in the same direction: one has to turn
  };
  std::vector<Link> links(3 * mesh.triangles.size());
  bool simple = true;
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    simple = simple && last - first == 2;
    if (!simple) return;
    const auto up = [&](std::uint32_t h) { return mesh.triangles[h / 3][h % 3] == low; };
    const std::uint32_t a = first[0].half_edge, b = first[1].half_edge;
    links[a] = {b / 3, up(a) == up(b)};
    links[b] = {a / 3, up(a) == up(b)};
  });
  if (!simple) return false;
  std::vector<signed char> turned(mesh.triangles.size(), -1);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < turned.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    turned[seed] = 0;
    open.push_back(seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (int c = 0; c < 3; ++c) {
        const Link& link = links[3 * t + c];
        const signed char wanted = link.same_way ? 1 - turned[t] : turned[t];
        if (turned[link.to] < 0) {
          turned[link.to] = wanted;
          open.push_back(link.to);
        } else if (turned[link.to] != wanted) {
          return false;
        }
      }
    }
  }
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] > 0) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  return true;
}

/// A shell as the others see it.
struct ShellProbe {
  explicit ShellProbe(const TriMesh& shell)
      : tree(toSurface(shell)), box(meshBounds(shell)), volume(meshVolume(shell)) {
    constexpr std::size_t kPlaces = 16;
    const std::size_t step = std::max<std::size_t>(1, shell.positions.size() / kPlaces);
    for (std::size_t i = 0; i < shell.positions.size(); i += step)
      places.push_back(shell.positions[i].cast<double>());
  }
  /// Whether it goes round all of the other.
  bool encloses(const ShellProbe& other) const {
    if ((other.box.min.array() < box.min.array()).any() || (other.box.max.array() > box.max.array()).any())
      return false;
    // A place on this shell is no evidence.
    constexpr double kInside = 0.75;
    return std::all_of(other.places.begin(), other.places.end(),
                       [&](const Vec3& p) { return std::abs(tree.windingNumber(p)) > kInside; });
  }
  TriangleTree tree;
  Box3 box;
  double volume;
  std::vector<Vec3> places;  ///< on it
};

/// Shells at even depth shall enclose material, those at odd depth a void. Returns how many were turned.
std::size_t orientShells(Shells& shells) {
  std::vector<ShellProbe> probes;
  std::vector<Box3> boxes;
  for (const TriMesh& shell : shellMeshes(shells)) boxes.push_back(probes.emplace_back(shell).box);
  const BoxTree near(boxes);
  std::vector<char> turn(shells.count, 0);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    int around = 0;
    near.forEachPlace(boxes[s], [&](std::uint32_t place) {
      const std::uint32_t other = near.order()[place];
      if (other != s && probes[other].encloses(probes[s])) ++around;
    });
    turn[s] = around % 2 == 1 ? probes[s].volume > 0.0 : probes[s].volume < 0.0;
  }
  for (std::size_t t = 0; t < shells.shell_of.size(); ++t) {
    if (turn[shells.shell_of[t]]) std::swap(shells.mesh.triangles[t][1], shells.mesh.triangles[t][2]);
  }
  return static_cast<std::size_t>(std::count(turn.begin(), turn.end(), 1));
}

Error holeError(const OpenEdges& open, const std::string& name) {
  return inputError(
      fmt::format("{}: the mesh is not closed: a hole or a wall without thickness at {} mm "
                  "({} open edges in all); repair it in the CAD system, or export it again as a closed solid",
                  name, placeText(open.first), open.odd));
}

}  // namespace nominal_detail

Result<PreparedMesh> prepareNominal(const TriMesh& mesh, const std::string& name) {
  using namespace nominal_detail;
  if (mesh.triangles.empty()) return inputError(name + ": the mesh has no triangles");
  PreparedMesh out;
  out.mesh = weldVertices(mesh);
  if (auto bad = findBadElements(out.mesh, name)) return *bad;
  if (const std::size_t n = dropDoubled(out.mesh); n > 0) {
    out.notes.push_back(fmt::format("{}: dropped {} doubled triangles", name, n));
  }
  OpenEdges open = findOpenEdges(out.mesh);
  if (open.odd > 0) {
    const double tolerance = 1e-4 + 1e-6 * meshBounds(out.mesh).size().norm();
    const OpenEdges before = open;
    const std::size_t merged = mergeNearBorders(out.mesh, tolerance);
    open = findOpenEdges(out.mesh);
    if (open.odd > 0 || out.mesh.triangles.empty()) return holeError(before, name);
    out.notes.push_back(fmt::format("{}: closed gaps up to {:.1e} mm by merging {} border vertices", name,
                                    tolerance, merged));
  }
  if (out.mesh.triangles.empty()) return inputError(name + ": no triangle is left that bounds a solid");
  if (open.opposed > 0) {
    if (!makeConsistent(out.mesh)) {
      return inputError(fmt::format(
          "{}: facets disagree about which side is outside at {} mm and cannot be turned to agree; "
          "export the mesh again as a closed solid",
          name, placeText(open.first)));
    }
    out.notes.push_back(fmt::format("{}: facets had mixed orientation; made consistent", name));
  }
  Shells shells = splitShells(out.mesh);
  if (const std::size_t n = orientShells(shells); n > 0) {
    out.notes.push_back(fmt::format("{}: {} inside out; turned", name,
                                    n == 1 ? "a shell was" : fmt::format("{} shells were", n)));
  }
  Result<JoinedBodies> joined = joinBodies(shells, name);
  if (!joined) return joined.error();
  out.mesh = std::move(joined->mesh);
  if (joined->joined > 0) {
    out.notes.push_back(fmt::format("{}: {} bodies that touch or overlap were joined", name, joined->joined));
  }
  if (!(meshVolume(out.mesh) > 0.0)) return inputError(name + ": the mesh encloses no volume");
  return out;
}

}  // namespace proveout
