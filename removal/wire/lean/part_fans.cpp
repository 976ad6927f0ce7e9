#include "removal/wire/lean/part_fans.h"

#include <array>
#include <map>
#include <vector>

#include "core/geometry/to_float.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/shells.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

/// Two triangles that belong together at a non-manifold edge.
struct SharedEdge {
  std::uint32_t triangle, other;
  std::uint32_t from, to;  ///< as `triangle` has it
};

/// All pairs but one at each non-manifold edge, one that more than two triangles share.
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

/// Gives each pair of triangles its own vertex on the edge.
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

/// Corners at which several fans of triangles touch stand back from each other by some steps of a mesh, in a
/// level plane: a mesh that only touches itself would be reported as self-intersecting.
class FansApart {
 public:
  explicit FansApart(TriMesh& mesh) : mesh_(mesh) {
    std::map<std::array<float, 3>, std::vector<std::uint32_t>> at;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      at[{mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z()}].push_back(v);
    for (auto& [place, corners] : at) {
      if (corners.size() < 2) continue;
      for (const std::uint32_t v : corners) way_[v] = Vec2::Zero();
      shared_.push_back(std::move(corners));
    }
    if (shared_.empty()) return;
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) {
        const auto found = way_.find(v);
        if (found != way_.end()) found->second += toMiddle(t, v);
      }
    }
  }

  void part() {
    for (const std::vector<std::uint32_t>& corners : shared_) {
      Vec2 mean = Vec2::Zero();
      for (const std::uint32_t v : corners) mean += unit(way_[v]) / static_cast<double>(corners.size());
      for (const std::uint32_t v : corners) {
        const Vec2 p = levelOf(v), off = unit(unit(way_[v]) - mean);
        mesh_.positions[v].head<2>() = toFloat(p + kSteps * meshStep(p) * off);
      }
    }
  }

 private:
  /// Less than the distance within which corners are merged where walls meet.
  static constexpr double kSteps = 1.0;

  Vec2 levelOf(std::uint32_t v) const { return mesh_.positions[v].head<2>().cast<double>(); }
  static Vec2 unit(const Vec2& v) {
    const double length = v.norm();
    return length > 1e-9 ? Vec2(v / length) : Vec2(0.0, 0.0);
  }
  Vec2 toMiddle(const std::array<std::uint32_t, 3>& t, std::uint32_t v) const {
    return unit((levelOf(t[0]) + levelOf(t[1]) + levelOf(t[2])) / 3.0 - levelOf(v));
  }

  TriMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> shared_;  ///< corners in one place
  std::map<std::uint32_t, Vec2> way_;               ///< of those: to the middle of their triangles
};

}  // namespace

void partFans(TriMesh& mesh) {
  mesh = splitShells(mesh).mesh;
  const std::vector<SharedEdge> shared = sharedEdges(mesh);
  if (!shared.empty()) {
    EdgeDivider divider(mesh);
    for (const SharedEdge& edge : shared) divider.divide(edge);
    mesh = splitShells(mesh).mesh;  // what the edges held together may be several fans now
  }
  FansApart(mesh).part();
}

}  // namespace proveout
