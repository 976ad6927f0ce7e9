#include "core/mesh/shells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"

namespace proveout {

namespace {

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;
/// Faces at an edge that differ by less than this lie on each other, rad: what float coordinates can tell.
constexpr double kSameAngle = 1e-5;

/// A triangle at an edge of many.
struct EdgeLeaf {
  std::uint32_t half_edge;
  double angle;  ///< of the triangle about the edge, over less than 2 pi
  bool upwards;  ///< uses the edge from the low to the high vertex: its material lies at lower angles
};

/// Finds for each half-edge the one of the triangle that goes on behind its edge.
class EdgePairs {
 public:
  explicit EdgePairs(const TriMesh& mesh)
      : mesh_(mesh), partner_(3 * mesh.triangles.size(), kNoPartner), sheets_(mesh.triangles.size()) {
    const EdgeTable edges(mesh.positions.size(), mesh.triangles);
    edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
      if (last - first == 2) {
        pair(first[0].half_edge, first[1].half_edge);
        return;
      }
      std::vector<EdgeLeaf> leaves = leavesAround(low, first, last);
      if (alternate(leaves)) {
        pairByAngle(leaves);
      } else {
        overlaps_.push_back(std::move(leaves));
      }
    });
    pairOverlaps();
  }
  std::vector<std::uint32_t> take() { return std::move(partner_); }

 private:
  void pair(std::uint32_t a, std::uint32_t b) {
    partner_[a] = b;
    partner_[b] = a;
    sheets_.join(a / 3, b / 3);
  }
  Vec3 point(std::uint32_t v) const { return mesh_.positions[v].cast<double>(); }

  /// By angle; where two lie on each other, the material that ends there ends before the other begins.
  std::vector<EdgeLeaf> leavesAround(std::uint32_t low, const HalfEdge* first, const HalfEdge* last) const {
    const Vec3 origin = point(low), along = (point(first->other) - origin).normalized();
    const Vec3 u = along.unitOrthogonal(), v = along.cross(u);
    std::vector<EdgeLeaf> leaves;
    for (const HalfEdge* h = first; h < last; ++h) {
      const auto& t = mesh_.triangles[h->half_edge / 3];
      const Vec3 to = point(t[(h->half_edge + 2) % 3]) - origin;
      leaves.push_back({h->half_edge, std::atan2(to.dot(v), to.dot(u)), t[h->half_edge % 3] == low});
    }
    std::sort(leaves.begin(), leaves.end(),
              [](const EdgeLeaf& a, const EdgeLeaf& b) { return a.angle < b.angle; });
    startBehindWidestGap(leaves);
    for (std::size_t i = 0; i + 1 < leaves.size(); ++i) {
      for (std::size_t j = i + 1; j < leaves.size() && leaves[j].angle - leaves[i].angle < kSameAngle; ++j) {
        if (!leaves[i].upwards && leaves[j].upwards) std::swap(leaves[i], leaves[j]);
      }
    }
    return leaves;
  }

  /// So that no two that lie on each other are first and last.
  static void startBehindWidestGap(std::vector<EdgeLeaf>& leaves) {
    std::size_t start = 0;
    double widest = leaves.front().angle + 2.0 * kPi - leaves.back().angle;
    for (std::size_t i = 1; i < leaves.size(); ++i) {
      const double gap = leaves[i].angle - leaves[i - 1].angle;
      if (gap > widest + kSameAngle) {
        widest = gap;
        start = i;
      }
    }
    for (std::size_t i = 0; i < start; ++i) leaves[i].angle += 2.0 * kPi;
    std::rotate(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(start), leaves.end());
  }

  /// Whether material begins and ends in turns around the edge: nothing overlaps there.
  static bool alternate(const std::vector<EdgeLeaf>& leaves) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (leaves[i].upwards == leaves[(i + 1) % leaves.size()].upwards) return false;
    }
    return true;
  }

  /// A triangle that uses the edge upwards has its material at lower angles, the others at higher ones: each
  /// of the others goes with the next upward one.
  void pairByAngle(const std::vector<EdgeLeaf>& leaves) {
    std::vector<std::uint32_t> open;
    for (int round = 0; round < 2; ++round) {  // the second one closes what began at the end of the first
      for (const EdgeLeaf& leaf : leaves) {
        if (partner_[leaf.half_edge] != kNoPartner) continue;
        if (!leaf.upwards) {
          if (round == 0) open.push_back(leaf.half_edge);
        } else if (!open.empty()) {
          pair(open.back(), leaf.half_edge);
          open.pop_back();
        }
      }
    }
  }

  /// Pairs at an edge the triangles that hang together elsewhere. Whether any were.
  bool pairWithinSheets(const std::vector<EdgeLeaf>& leaves) {
    std::map<std::uint32_t, std::vector<EdgeLeaf>> of_sheet;
    for (const EdgeLeaf& leaf : leaves) {
      if (partner_[leaf.half_edge] == kNoPartner) of_sheet[sheets_.find(leaf.half_edge / 3)].push_back(leaf);
    }
    bool paired = false;
    for (const auto& [sheet, own] : of_sheet) {
      const auto up =
          std::count_if(own.begin(), own.end(), [](const EdgeLeaf& leaf) { return leaf.upwards; });
      if (up == 0 || up == std::ssize(own)) continue;
      pairByAngle(own);
      paired = true;
    }
    return paired;
  }

  /// Where solids overlap at a common edge, angles do not tell whose a triangle is; what hangs together at
  /// other edges does. Where that leaves a choice, one edge is paired by angle, and the others follow it.
  void pairOverlaps() {
    const auto isOpen = [&](const EdgeLeaf& leaf) { return partner_[leaf.half_edge] == kNoPartner; };
    while (!overlaps_.empty()) {
      bool paired = false;
      for (const auto& leaves : overlaps_) paired = pairWithinSheets(leaves) || paired;
      if (!paired) {
        pairByAngle(overlaps_.back());
        overlaps_.pop_back();
      }
      std::erase_if(overlaps_, [&](const auto& leaves) { return std::ranges::none_of(leaves, isOpen); });
    }
  }

  const TriMesh& mesh_;
  std::vector<std::uint32_t> partner_;
  DisjointSets sheets_;                          ///< triangles that hang together by what is paired
  std::vector<std::vector<EdgeLeaf>> overlaps_;  ///< edges where solids overlap
};

}  // namespace

std::vector<std::uint32_t> edgePartners(const TriMesh& mesh) { return EdgePairs(mesh).take(); }

Shells splitShells(const TriMesh& mesh) {
  PROVEOUT_ASSERT(mesh.motion.empty() || mesh.motion.size() == mesh.triangles.size());
  const std::vector<std::uint32_t> partner = edgePartners(mesh);
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
  DisjointSets fans(corners), shells(mesh.triangles.size());
  for (std::uint32_t h = 0; h < corners; ++h) {
    const std::uint32_t other = partner[h];
    if (other == kNoPartner) continue;
    // The start of one is the end of the other.
    fans.join(h, next(other));
    fans.join(next(h), other);
    shells.join(h / 3, other / 3);
  }
  Shells out;
  out.mesh.motion = mesh.motion;
  out.mesh.triangles.resize(mesh.triangles.size());
  std::vector<std::uint32_t> vertex_of(corners, kNoVertex), number(mesh.triangles.size(), kNoVertex);
  for (std::uint32_t h = 0; h < corners; ++h) {
    std::uint32_t& vertex = vertex_of[fans.find(h)];
    if (vertex == kNoVertex) {
      vertex = static_cast<std::uint32_t>(out.mesh.positions.size());
      out.mesh.positions.push_back(mesh.positions[mesh.triangles[h / 3][h % 3]]);
    }
    out.mesh.triangles[h / 3][h % 3] = vertex;
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& shell = number[shells.find(t)];
    if (shell == kNoVertex) shell = out.count++;
    out.shell_of.push_back(shell);
  }
  return out;
}

std::vector<TriMesh> shellMeshes(const Shells& shells) {
  PROVEOUT_ASSERT(shells.shell_of.size() == shells.mesh.triangles.size());
  std::vector<TriMesh> out(shells.count);
  std::vector<std::uint32_t> vertex_of(shells.mesh.positions.size(), kNoVertex);  // each is of one shell
  for (std::size_t t = 0; t < shells.shell_of.size(); ++t) {
    TriMesh& shell = out[shells.shell_of[t]];
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t old = shells.mesh.triangles[t][c];
      if (vertex_of[old] == kNoVertex) {
        vertex_of[old] = static_cast<std::uint32_t>(shell.positions.size());
        shell.positions.push_back(shells.mesh.positions[old]);
      }
      triangle[c] = vertex_of[old];
    }
    shell.triangles.push_back(triangle);
    if (!shells.mesh.motion.empty()) shell.motion.push_back(shells.mesh.motion[t]);
  }
  return out;
}

void append(TriMesh& mesh, const TriMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const bool motions =
      mesh.motion.size() == mesh.triangles.size() && more.motion.size() == more.triangles.size();
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  if (motions) {
    mesh.motion.insert(mesh.motion.end(), more.motion.begin(), more.motion.end());
  } else {
    mesh.motion.clear();
  }
}

}  // namespace proveout
