#include "removal/wire/part_fans.h"

#include <array>
#include <map>
#include <vector>

#include "core/geometry/to_float.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/shells.h"
#include "removal/wire/plane_region.h"

namespace proveout {
namespace {

/// Two triangles that go on behind an edge at which there are more.
struct SharedEdge {
  std::uint32_t triangle, other;
  std::uint32_t from, to;  ///< as `triangle` has it
};

/// All but one pair at each edge of more than two triangles.
std::vector<SharedEdge> sharedEdges(const TriMesh& mesh) {
  std::vector<SharedEdge> shared;
  std::vector<std::uint32_t> partner;  // made where it is needed
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    if (last - first <= 2) return;
    if (partner.empty()) partner = edgePartners(mesh);
    bool kept = false;
    for (const HalfEdge* h = first; h < last; ++h) {
      const std::uint32_t at = h->half_edge, other = partner[at];
      if (other == kNoPartner || other < at) continue;
      const auto& t = mesh.triangles[at / 3];
      if (kept) shared.push_back({at / 3, other / 3, t[at % 3], t[(at + 1) % 3]});
      kept = true;
    }
  });
  return shared;
}

/// Gives pairs of triangles a vertex of their own on their edge.
class EdgeDivider {
 public:
  explicit EdgeDivider(TriMesh& mesh) : mesh_(mesh) {}

  void divide(const SharedEdge& edge) {
    const auto middle = static_cast<std::uint32_t>(mesh_.positions.size());
    const Eigen::Vector3f p = mesh_.positions[edge.from], q = mesh_.positions[edge.to];
    mesh_.positions.push_back(0.5f * (p + q));
    divide(edge.triangle, edge.from, edge.to, middle);
    divide(edge.other, edge.to, edge.from, middle);
  }

 private:
  /// Of a triangle, or of what it was divided into, the one with the edge from `a` to `b`.
  void divide(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, std::uint32_t middle) {
    std::vector<std::uint32_t>& pieces = pieces_.try_emplace(triangle, 1, triangle).first->second;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        auto& corners = mesh_.triangles[pieces[i]];
        if (corners[k] != a || corners[(k + 1) % 3] != b) continue;
        const std::uint32_t c = corners[(k + 2) % 3];
        corners = {a, middle, c};
        const auto added = static_cast<std::uint32_t>(mesh_.triangles.size());
        mesh_.triangles.push_back({middle, b, c});
        if (!mesh_.motion.empty()) mesh_.motion.push_back(mesh_.motion[pieces[i]]);
        pieces.push_back(added);
        return;
      }
    }
  }

  TriMesh& mesh_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> pieces_;
};

/// Corners that several fans have, each for itself, stand back from each other by some steps of a mesh,
/// level: what only touches would be told as running through itself.
void standBack(TriMesh& mesh) {
  std::map<std::array<float, 3>, std::vector<std::uint32_t>> at;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    at[{mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z()}].push_back(v);
  std::map<std::uint32_t, Vec2> way;  // of corners that are not alone
  for (const auto& [place, corners] : at) {
    for (const std::uint32_t v : corners)
      if (corners.size() > 1) way[v] = Vec2::Zero();
  }
  if (way.empty()) return;
  const auto levelOf = [&](std::uint32_t v) -> Vec2 { return mesh.positions[v].head<2>().cast<double>(); };
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = way.find(t[k]);
      if (found == way.end()) continue;
      const Vec2 middle = (levelOf(t[0]) + levelOf(t[1]) + levelOf(t[2])) / 3.0, off = middle - levelOf(t[k]);
      if (off.norm() > meshStep(middle)) found->second += off.normalized();
    }
  }
  constexpr double kSteps = 2.0;
  for (const auto& [v, sum] : way) {
    if (sum.norm() < 1e-3) continue;
    const Vec2 p = levelOf(v) + kSteps * meshStep(levelOf(v)) * sum.normalized();
    mesh.positions[v].head<2>() = toFloat(p);
  }
}

}  // namespace

void partFans(TriMesh& mesh) {
  mesh = splitShells(mesh).mesh;
  const std::vector<SharedEdge> shared = sharedEdges(mesh);
  if (!shared.empty()) {
    EdgeDivider divider(mesh);
    for (const SharedEdge& edge : shared) divider.divide(edge);
    mesh = splitShells(mesh).mesh;  // what the edges held together may be several fans now
  }
  standBack(mesh);
}

}  // namespace proveout
