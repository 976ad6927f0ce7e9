#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "core/mesh/edge_table.h"
#include "core/mesh/vertex_links.h"

namespace proveout {

DisjointSets::DisjointSets(std::size_t size) : parent_(size) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::size_t DisjointSets::setsOfSeveral() const {
  std::vector<bool> several(parent_.size());
  for (std::uint32_t i = 0; i < parent_.size(); ++i) {
    // Parents come before their children: a set of several is known by a child of its representative.
    if (parent_[i] != i && parent_[parent_[i]] == parent_[i]) several[parent_[i]] = true;
  }
  return static_cast<std::size_t>(std::ranges::count(several, true));
}

EdgeTable::EdgeTable(std::size_t vertices, const std::vector<TriangleIndices>& triangles)
    : start_(vertices + 1, 0) {
  const auto eachHalfEdge = [&](auto&& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (!triangleIsProper(triangles[t], vertices)) continue;
      const auto& v = triangles[t];
      for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t a = v[c], b = v[(c + 1) % 3];
        visit(std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(3 * t + c));
      }
    }
  };
  eachHalfEdge([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++start_[low + 1]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  entries_.resize(start_.back());
  std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
  eachHalfEdge([&](std::uint32_t low, std::uint32_t high, std::uint32_t half_edge) {
    entries_[fill[low]++] = {high, half_edge};
  });
  for (std::size_t v = 0; v + 1 < start_.size(); ++v) {
    std::sort(entries_.begin() + start_[v], entries_.begin() + start_[v + 1],
              [](const HalfEdge& a, const HalfEdge& b) {
                return a.other != b.other ? a.other < b.other : a.half_edge < b.half_edge;
              });
  }
}

namespace topology_detail {

/// Counts defects and remembers where the first one is.
struct DefectLog {
  MeshTopology result;
  bool located = false;

  void place(const Vec3& where) {
    if (located) return;
    located = true;
    for (int axis = 0; axis < 3; ++axis)
      result.first_defect[axis] = std::isfinite(where[axis]) ? where[axis] : 0.0;
  }
  void add(std::size_t& counter, const Vec3& where) {
    ++counter;
    place(where);
  }
};

Vec3 cornerOf(const TriMesh& mesh, std::uint32_t vertex) { return mesh.positions[vertex].cast<double>(); }

/// Corner of `half_edge`'s triangle that lies at `vertex`, which is an end of the half-edge.
std::uint32_t cornerAt(const TriMesh& mesh, std::uint32_t half_edge, std::uint32_t vertex) {
  const std::uint32_t t = half_edge / 3, c = half_edge % 3;
  return mesh.triangles[t][c] == vertex ? half_edge : 3 * t + (c + 1) % 3;
}

void logPositionsAndTriangles(const TriMesh& mesh, DefectLog& log) {
  for (const auto& p : mesh.positions) {
    if (!p.allFinite()) log.add(log.result.non_finite_positions, p.cast<double>());
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (triangleIsProper(mesh.triangles[t], mesh.positions.size())) continue;
    Vec3 where = Vec3::Zero();
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.positions.size()) where = cornerOf(mesh, v);
    }
    log.add(log.result.degenerate_triangles, where);
  }
}

void logEdge(const TriMesh& mesh, std::uint32_t low, const HalfEdge* first, const HalfEdge* last,
             DefectLog& log) {
  const auto count = last - first;
  if (count == 2) {
    const auto startsAtLow = [&](const HalfEdge& h) {
      return mesh.triangles[h.half_edge / 3][h.half_edge % 3] == low;
    };
    if (startsAtLow(first[0]) != startsAtLow(first[1])) return;
  }
  const Vec3 where = 0.5 * (cornerOf(mesh, low) + cornerOf(mesh, first->other));
  MeshTopology& r = log.result;
  log.add(count == 1 ? r.boundary_edges : count == 2 ? r.misoriented_edges : r.non_manifold_edges, where);
}

/// A vertex is manifold when its corners, joined across shared edges, form one set.
void logVertices(const TriMesh& mesh, DisjointSets& corners, DefectLog& log) {
  std::vector<std::uint32_t> fans(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!triangleIsProper(mesh.triangles[t], mesh.positions.size())) continue;
    for (std::uint32_t c = 0; c < 3; ++c) {
      const auto corner = static_cast<std::uint32_t>(3 * t + c);
      if (corners.find(corner) == corner) ++fans[mesh.triangles[t][c]];
    }
  }
  for (std::uint32_t v = 0; v < fans.size(); ++v) {
    if (fans[v] > 1) log.add(log.result.non_manifold_vertices, cornerOf(mesh, v));
  }
}

std::vector<std::uint32_t> numberComponents(DisjointSets& sets, std::size_t triangles, std::uint32_t& count) {
  std::vector<std::uint32_t> number(triangles);
  count = 0;
  for (std::uint32_t t = 0; t < triangles;
       ++t) {  // the representative is the smallest, so it is numbered first
    const std::uint32_t root = sets.find(t);
    number[t] = root == t ? count++ : number[root];
  }
  return number;
}

/// Whether the mesh is closed, 2-manifold and oriented: around each vertex the triangles form one closed fan.
/// Half the work of naming defects, which the rare mesh that has any gets on top.
bool isClosedManifold(const TriMesh& mesh) {
  for (const auto& t : mesh.triangles) {
    if (!triangleIsProper(t, mesh.positions.size())) return false;
  }
  std::atomic<bool> closed{true};
  const auto any = [](std::uint32_t) { return true; };
  forEachLink(mesh, any, [&](std::size_t, std::uint32_t, std::span<LinkEdge> link) {
    if (!link.empty() && !isOneCycle(link)) closed.store(false, std::memory_order_relaxed);
  });
  return closed;
}

/// Sets of vertices that triangles connect. Where each vertex has one fan these are the components.
DisjointSets connectedVertices(const TriMesh& mesh) {
  DisjointSets sets(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  return sets;
}

std::vector<std::uint32_t> numberManifoldComponents(const TriMesh& mesh, std::uint32_t& count) {
  constexpr std::uint32_t kUnnumbered = 0xFFFFFFFF;
  DisjointSets sets = connectedVertices(mesh);
  std::vector<std::uint32_t> of_root(mesh.positions.size(), kUnnumbered);
  std::vector<std::uint32_t> number;
  number.reserve(mesh.triangles.size());
  count = 0;
  for (const auto& t : mesh.triangles) {
    std::uint32_t& n = of_root[sets.find(t[0])];
    if (n == kUnnumbered) n = count++;
    number.push_back(n);
  }
  return number;
}

MeshTopology nameDefects(const TriMesh& mesh) {
  DefectLog log;
  logPositionsAndTriangles(mesh, log);
  DisjointSets corners(3 * mesh.triangles.size());
  DisjointSets sheets(mesh.triangles.size());
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    logEdge(mesh, low, first, last, log);
    for (const HalfEdge* h = first + 1; h < last; ++h) {
      sheets.join(first->half_edge / 3, h->half_edge / 3);
      for (const std::uint32_t v : {low, h->other}) {
        corners.join(cornerAt(mesh, first->half_edge, v), cornerAt(mesh, h->half_edge, v));
      }
    }
  });
  logVertices(mesh, corners, log);
  std::uint32_t count = 0;
  numberComponents(sheets, mesh.triangles.size(), count);
  log.result.components = count;
  return log.result;
}

}  // namespace topology_detail

MeshTopology analyseTopology(const TriMesh& mesh) {
  using namespace topology_detail;
  const bool finite = std::ranges::all_of(mesh.positions, [](const auto& p) { return p.allFinite(); });
  if (!finite || !isClosedManifold(mesh)) return nameDefects(mesh);
  MeshTopology topology;
  topology.components = connectedVertices(mesh).setsOfSeveral();
  return topology;
}

std::vector<std::uint32_t> meshComponents(const TriMesh& mesh, std::uint32_t& count) {
  using namespace topology_detail;
  if (isClosedManifold(mesh)) return numberManifoldComponents(mesh, count);
  DisjointSets sheets(mesh.triangles.size());
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    for (const HalfEdge* h = first + 1; h < last; ++h) sheets.join(first->half_edge / 3, h->half_edge / 3);
  });
  return numberComponents(sheets, mesh.triangles.size(), count);
}

}  // namespace proveout
