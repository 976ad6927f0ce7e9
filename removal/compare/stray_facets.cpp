#include "removal/compare/stray_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/intersections.h"

namespace proveout {
namespace {

using Indices = std::array<std::uint32_t, 3>;

/// A facet lower than this is a line to whoever made it: some roundings of float coordinates, mm.
constexpr double kFlatMm = 1e-4;

/// Facets over the same three vertices.
struct Copies {
  std::vector<std::uint32_t> even, odd;  ///< with the turning sense of the sorted indices, and against it
  std::size_t count() const { return even.size() + odd.size(); }
};

/// Those of several, and which of them a triangle is of.
struct DoubledFacets {
  explicit DoubledFacets(const TriMesh& mesh) : group_of(mesh.triangles.size(), kNone) {
    std::vector<std::pair<Indices, std::uint32_t>> keys(mesh.triangles.size());
    for (std::uint32_t t = 0; t < keys.size(); ++t) {
      keys[t] = {mesh.triangles[t], t};
      std::sort(keys[t].first.begin(), keys[t].first.end());
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0, j = 0; i < keys.size(); i = j) {
      for (j = i + 1; j < keys.size() && keys[j].first == keys[i].first;) ++j;
      if (j - i < 2) continue;
      Copies copies;
      for (std::size_t k = i; k < j; ++k) {
        const std::uint32_t t = keys[k].second;
        const Indices& v = mesh.triangles[t];
        const bool is_even = (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;
        (is_even ? copies.even : copies.odd).push_back(t);
        group_of[t] = static_cast<std::uint32_t>(groups.size());
      }
      groups.push_back(std::move(copies));
    }
  }
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<Copies> groups;
  std::vector<std::uint32_t> group_of;
};

/// For each group how many edges are open with an odd number of its facets, less those with an even number,
/// when all groups that hang together are treated alike.
std::vector<std::ptrdiff_t> opensMoreByOne(const TriMesh& mesh, const DoubledFacets& doubled) {
  const std::size_t groups = doubled.groups.size();
  DisjointSets patches(groups);
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  const auto groupAt = [&](const HalfEdge& h) { return doubled.group_of[h.half_edge / 3]; };
  std::vector<std::uint32_t> here;
  const auto groupsOf = [&](const HalfEdge* first, const HalfEdge* last) {
    here.clear();
    for (const HalfEdge* h = first; h < last; ++h) {
      if (groupAt(*h) != DoubledFacets::kNone) here.push_back(groupAt(*h));
    }
    const auto single = (last - first) - std::ssize(here);
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    return single;
  };
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    groupsOf(first, last);
    for (const std::uint32_t group : here) patches.join(here.front(), group);
  });
  std::vector<std::ptrdiff_t> more(groups, 0);
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    const auto single = groupsOf(first, last);
    if (here.empty()) return;
    more[patches.find(here.front())] += (single + std::ssize(here)) % 2 - single % 2;
  });
  for (std::uint32_t group = 0; group < groups; ++group) more[group] = more[patches.find(group)];
  return more;
}

/// Keeps the first `even` and `odd` facets of a group.
void keepOnly(const Copies& copies, std::size_t even, std::size_t odd, std::vector<char>& drop) {
  for (std::size_t i = even; i < copies.even.size(); ++i) drop[copies.even[i]] = 1;
  for (std::size_t i = odd; i < copies.odd.size(); ++i) drop[copies.odd[i]] = 1;
}

double heightOf(const TriMesh& mesh, std::uint32_t t) {
  const std::array<Vec3, 3> p = cornersOf(mesh, t);
  const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  return longest > 0.0 ? (p[1] - p[0]).cross(p[2] - p[0]).norm() / longest : 0.0;
}

}  // namespace

void dropTriangles(TriMesh& mesh, const std::vector<char>& drop) {
  PROVEOUT_ASSERT(drop.size() == mesh.triangles.size());
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

std::size_t dropDoubledFacets(TriMesh& mesh) {
  const DoubledFacets doubled(mesh);
  if (doubled.groups.empty()) return 0;
  const std::vector<std::ptrdiff_t> more = opensMoreByOne(mesh, doubled);
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t g = 0; g < doubled.groups.size(); ++g) {
    const Copies& copies = doubled.groups[g];
    const std::size_t facing = std::min(copies.even.size(), copies.odd.size());
    const std::size_t even = copies.even.size() - facing, odd = copies.odd.size() - facing;
    const bool one = more[g] < 0 || (more[g] == 0 && even + odd > 0);
    if (!one) {
      const std::size_t rest = (even + odd) / 2 * 2;  // an even number closes
      keepOnly(copies, even > 0 ? rest : 0, odd > 0 ? rest : 0, drop);
    } else {
      const bool is_even = even > 0 || (odd == 0 && !copies.even.empty());
      keepOnly(copies, is_even ? 1 : 0, is_even ? 0 : 1, drop);
    }
  }
  dropTriangles(mesh, drop);
  return static_cast<std::size_t>(std::count(drop.begin(), drop.end(), 1));
}

std::size_t dropFlatStrays(TriMesh& mesh) {
  constexpr int kMostRounds = 64;
  std::size_t dropped = 0;
  for (int round = 0; round < kMostRounds; ++round) {  // what is left of a row of them is open at its ends
    std::vector<std::uint8_t> open(mesh.triangles.size(), 0);
    const EdgeTable edges(mesh.positions.size(), mesh.triangles);
    edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
      if ((last - first) % 2 == 0) return;
      for (const HalfEdge* h = first; h < last; ++h) ++open[h->half_edge / 3];
    });
    std::vector<char> drop(mesh.triangles.size(), 0);
    std::size_t now = 0;
    for (std::uint32_t t = 0; t < open.size(); ++t) {
      if (open[t] < 2 || heightOf(mesh, t) > kFlatMm) continue;
      drop[t] = 1;
      ++now;
    }
    if (now == 0) break;
    dropTriangles(mesh, drop);
    dropped += now;
  }
  return dropped;
}

}  // namespace proveout
