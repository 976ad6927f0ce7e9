#include "core/mesh/flat_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/exact_meeting.h"
#include "core/mesh/intersections.h"

namespace proveout {
namespace {

constexpr std::uint32_t kNoTwin = 0xFFFFFFFFu;

/// Turns edges of a mesh, one beside the other, as long as none of their triangles was touched before.
class EdgeTurner {
 public:
  explicit EdgeTurner(TriMesh& mesh) : mesh_(mesh) {
    const EdgeTable edges(mesh.positions.size(), mesh.triangles);
    twin_.assign(3 * mesh.triangles.size(), kNoTwin);
    edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
      edges_.emplace_back(low, first->other);
      if (last - first != 2) return;
      twin_[first[0].half_edge] = first[1].half_edge;
      twin_[first[1].half_edge] = first[0].half_edge;
    });
    touched_.assign(mesh.triangles.size(), 0);
  }

  /// Whether the half-edge could be turned.
  bool turn(std::uint32_t h, const std::vector<char>& flat) {
    const std::uint32_t other = twin_[h];
    if (other == kNoTwin || flat[other / 3] || touched_[h / 3] || touched_[other / 3]) return false;
    const std::uint32_t a = corner(h, 0), b = corner(h, 1), m = corner(h, 2), x = corner(other, 2);
    if (m == x || areJoined(std::minmax(m, x))) return false;
    mesh_.triangles[h / 3] = {m, a, x};
    mesh_.triangles[other / 3] = {m, x, b};
    added_.insert(std::minmax(m, x));
    touched_[h / 3] = touched_[other / 3] = 1;
    return true;
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  ///< its lower vertex first
  std::uint32_t corner(std::uint32_t h, std::uint32_t step) const {
    return mesh_.triangles[h / 3][(h % 3 + step) % 3];
  }

  bool areJoined(const Edge& edge) const {
    return std::binary_search(edges_.begin(), edges_.end(), edge) || added_.contains(edge);
  }

  TriMesh& mesh_;
  std::vector<std::uint32_t> twin_;
  std::vector<char> touched_;
  std::vector<Edge> edges_;  ///< in order
  std::set<Edge> added_;     ///< by turning
};

/// Across from the corner between the other two.
std::uint32_t longestEdge(const TriMesh& mesh, std::uint32_t t) {
  const std::array<Vec3, 3> p = cornersOf(mesh, t);
  std::uint32_t longest = 0;
  double most = -1.0;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const double length = (p[(c + 1) % 3] - p[c]).squaredNorm();
    if (length <= most) continue;
    most = length;
    longest = c;
  }
  return 3 * t + longest;
}

}  // namespace

TriMesh withoutFlatTriangles(TriMesh mesh) {
  constexpr int kMostRounds = 64;  // each turns at least one in a row of them
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<std::uint32_t> flats;
    std::vector<char> flat(mesh.triangles.size(), 0);
    for (std::uint32_t t = 0; t < flat.size(); ++t) {
      flat[t] = isNeedle(mesh, t) && isFlat(mesh, t);
      if (flat[t]) flats.push_back(t);
    }
    if (flats.empty()) break;
    EdgeTurner turner(mesh);
    bool any = false;
    for (const std::uint32_t t : flats) any = turner.turn(longestEdge(mesh, t), flat) || any;
    if (!any) break;
  }
  return mesh;
}

}  // namespace proveout
