#include "core/mesh/level_cut.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/geometry/polygon.h"

namespace proveout {
namespace {

/// An edge of the mesh, its lower number first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;
Edge edgeOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

Vec2 meetingOf(const TriMesh& mesh, const Edge& edge, double z) {
  const Vec3 a = mesh.positions[edge.first].cast<double>(), b = mesh.positions[edge.second].cast<double>();
  return (a + (b - a) * ((z - a.z()) / (b.z() - a.z()))).head<2>();
}

}  // namespace

std::vector<std::vector<Vec2>> cutAtHeight(const TriMesh& mesh, double z) {
  const auto above = [&](std::uint32_t corner) {
    return static_cast<double>(mesh.positions[corner].z()) >= z;
  };
  // In each triangle from the edge that goes down to the one that goes up: material lies to the left.
  std::map<Edge, Edge> next;
  for (const auto& t : mesh.triangles) {
    Edge down, up;
    bool crosses = false;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (above(a) == above(b)) continue;
      crosses = true;
      (above(a) ? down : up) = edgeOf(a, b);
    }
    if (crosses) next[down] = up;
  }
  std::vector<std::vector<Vec2>> polygons;
  while (!next.empty()) {
    const Edge first = next.begin()->first;
    std::vector<Vec2> polygon;
    Edge at = first;
    bool closed = false;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      polygon.push_back(meetingOf(mesh, at, z));
      at = found->second;
      next.erase(found);
      closed = at == first;
    }
    if (closed && polygon.size() > 2) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

double areaOf(const std::vector<std::vector<Vec2>>& polygons) {
  double sum = 0.0;
  for (const std::vector<Vec2>& polygon : polygons) sum += polygonArea(polygon);
  return sum;
}

}  // namespace proveout
