#include "removal/compare/cracks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/place_text.h"
#include "core/mesh/edge_table.h"
#include "removal/compare/stray_facets.h"

namespace proveout {
namespace {

/// OpenBorders run along each other where the cosine of their angle is no smaller.
constexpr double kAlong = 0.5;

/// An edge of one facet, in the direction that this uses it.
struct OpenEdge {
  std::uint32_t half_edge, from, to;
};

std::vector<OpenEdge> bordersOf(const TriMesh& mesh) {
  std::vector<OpenEdge> out;
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
    if (last - first != 1) return;
    const std::uint32_t h = first->half_edge;
    out.push_back({h, mesh.triangles[h / 3][h % 3], mesh.triangles[h / 3][(h % 3 + 1) % 3]});
  });
  return out;
}

/// The border edges of a mesh and what is near to them.
class OpenBorders {
 public:
  explicit OpenBorders(const TriMesh& mesh) : mesh_(mesh), edges_(bordersOf(mesh)) {
    std::vector<Box3> boxes;
    for (const OpenEdge& edge : edges_) {
      for (int piece = 0; piece < kPieces; ++piece) {
        Box3& box = boxes.emplace_back();
        box.extend(at(edge, static_cast<double>(piece) / kPieces));
        box.extend(at(edge, static_cast<double>(piece + 1) / kPieces));
      }
    }
    tree_ = BoxTree(boxes);
  }

  const std::vector<OpenEdge>& edges() const { return edges_; }
  Vec3 point(std::uint32_t v) const { return mesh_.positions[v].cast<double>(); }
  Vec3 at(const OpenEdge& edge, double part) const {
    return (1.0 - part) * point(edge.from) + part * point(edge.to);
  }

  /// How wide the gap is from a place of an edge to a border of another facet that runs along it, no farther
  /// off than `reach`: the least where there are several. `against`: only to those that facets on both sides
  /// of a crack use in opposite directions.
  std::optional<double> gapAt(const OpenEdge& edge, double part, double reach, bool against) const {
    const Vec3 p = at(edge, part), along = (point(edge.to) - point(edge.from)).normalized();
    std::optional<double> least;
    tree_.forEachPlace(Box3{p, p}.inflated(reach), [&](std::uint32_t place) {
      const OpenEdge& other = edges_[tree_.order()[place] / kPieces];
      if (other.half_edge / 3 == edge.half_edge / 3) return;
      const Vec3 a = point(other.from), way = point(other.to) - a;
      const double cosine = way.normalized().dot(along);
      if (against ? cosine > -kAlong : std::abs(cosine) < kAlong) return;
      const double t = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
      const Vec3 gap = a + t * way - p;
      if (gap.norm() <= reach) least = std::min(least.value_or(reach), widthOf(gap, edge));
    });
    return least;
  }

 private:
  /// Across the border in the plane of its facet; of a mere step out of that, all of it but what is along it.
  double widthOf(const Vec3& gap, const OpenEdge& edge) const {
    constexpr double kStep = 0.1;
    const auto& t = mesh_.triangles[edge.half_edge / 3];
    const Vec3 normal = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
    const Vec3 along = (point(edge.to) - point(edge.from)).normalized();
    const double off = along.cross(gap).norm(), across = std::abs(along.cross(normal).normalized().dot(gap));
    return across < kStep * off ? off : across;
  }

  static constexpr int kPieces = 16;  ///< of an edge in the tree: the box of a slanting one is all around it

  const TriMesh& mesh_;
  std::vector<OpenEdge> edges_;
  BoxTree tree_;
};

void widen(BorderGaps& gaps, double width, const Vec3& at) {
  if (width < gaps.width_mm || (width == 0.0 && gaps.crack_edges > 0)) return;
  gaps.width_mm = width;
  gaps.widest = at;
}

/// Adds an edge: one of a crack has another border along all of it.
void addBorder(const OpenBorders& borders, const OpenEdge& edge, double reach, BorderGaps& gaps) {
  constexpr std::array<double, 3> kInside = {0.25, 0.5, 0.75};
  BorderGaps own;
  for (const double part : kInside) {
    const std::optional<double> gap = borders.gapAt(edge, part, reach, false);
    if (!gap) {
      if (gaps.hole_edges++ == 0) gaps.first_hole = borders.at(edge, 0.5);
      return;
    }
    widen(own, *gap, borders.at(edge, part));
  }
  for (const double end : {0.0, 1.0}) {  // there the border's next edge is near, too
    if (const auto gap = borders.gapAt(edge, end, reach, true)) widen(own, *gap, borders.at(edge, end));
  }
  widen(gaps, own.width_mm, own.widest);
  ++gaps.crack_edges;
}

/// For border vertices that lie within `reach` of one that stands before them: that one.
std::map<std::uint32_t, std::uint32_t> nearBorderVertices(const TriMesh& mesh, double reach) {
  PROVEOUT_ASSERT(reach > 0.0);
  std::set<std::uint32_t> border;
  for (const OpenEdge& edge : bordersOf(mesh)) border.insert({edge.from, edge.to});
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::map<Cell, std::vector<std::uint32_t>> cells;
  std::map<std::uint32_t, std::uint32_t> target;
  for (const std::uint32_t v : border) {
    const Vec3 p = mesh.positions[v].cast<double>();
    const Eigen::Array<std::int64_t, 3, 1> c = (p / reach).array().floor().cast<std::int64_t>();
    std::uint32_t found = v;
    for (int n = 0; n < 27 && found == v; ++n) {
      const auto cell = cells.find({c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1});
      if (cell == cells.end()) continue;
      for (const std::uint32_t w : cell->second) {
        if ((mesh.positions[w].cast<double>() - p).norm() <= reach) found = w;
      }
    }
    if (found == v) {
      cells[{c[0], c[1], c[2]}].push_back(v);
    } else {
      target[v] = found;
    }
  }
  return target;
}

std::size_t mergeNearBorders(TriMesh& mesh, double reach) {
  const std::map<std::uint32_t, std::uint32_t> target = nearBorderVertices(mesh, reach);
  if (target.empty()) return 0;
  std::vector<char> drop(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (auto& v : mesh.triangles[t]) {
      if (const auto it = target.find(v); it != target.end()) v = it->second;
    }
    drop[t] = !triangleIsProper(mesh.triangles[t], mesh.positions.size());
  }
  dropTriangles(mesh, drop);
  return target.size();
}

/// Border vertices within `reach` of the inside of each border edge, in its direction.
class EdgeSplits {
 public:
  EdgeSplits(const TriMesh& mesh, double reach) : mesh_(mesh), borders_(mesh) {
    std::set<std::uint32_t> vertices;
    for (const OpenEdge& edge : borders_.edges()) vertices.insert({edge.from, edge.to});
    vertices_.assign(vertices.begin(), vertices.end());
    std::vector<Box3> boxes;
    for (const std::uint32_t v : vertices_) boxes.push_back({borders_.point(v), borders_.point(v)});
    tree_ = BoxTree(boxes);
    for (const OpenEdge& edge : borders_.edges()) add(edge, reach);
  }

  /// Splits each facet at the vertices of one of its edges. Returns how many.
  std::size_t apply(TriMesh& mesh) const {
    std::size_t split = 0;
    std::set<std::uint32_t> done;
    for (const auto& [half_edge, at] : at_) {
      const std::uint32_t t = half_edge / 3, c = half_edge % 3;
      if (!done.insert(t).second) continue;
      const auto corners = mesh.triangles[t];
      const std::uint32_t tip = corners[(c + 2) % 3];
      std::uint32_t last = corners[c];
      for (const std::uint32_t v : at) {
        mesh.triangles.push_back({last, v, tip});
        if (!mesh.motion.empty()) mesh.motion.push_back(mesh.motion[t]);
        last = v;
      }
      mesh.triangles[t] = {last, corners[(c + 1) % 3], tip};
      ++split;
    }
    return split;
  }

 private:
  void add(const OpenEdge& edge, double reach) {
    const Vec3 a = borders_.point(edge.from), way = borders_.point(edge.to) - a;
    const double length = way.norm();
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto near = [&](const BoxTree::Node& node, int side) { return passes(node, side, a, way, reach); };
    tree_.forEachPlaceWhere(near, [&](std::uint32_t place) {
      const std::uint32_t v = vertices_[tree_.order()[place]];
      const auto& corners = mesh_.triangles[edge.half_edge / 3];
      if (std::find(corners.begin(), corners.end(), v) != corners.end()) return;
      const double along = (borders_.point(v) - a).dot(way) / length;
      const double off = (a + along / length * way - borders_.point(v)).norm();
      if (off <= reach && along > reach && along < length - reach) found.emplace_back(along, v);
    });
    if (found.empty()) return;
    std::sort(found.begin(), found.end());
    for (const auto& [along, v] : found) at_[edge.half_edge].push_back(v);
  }

  /// Whether a stretch comes within `reach` of a child's bounds, axis by axis.
  static bool passes(const BoxTree::Node& node, int side, const Vec3& from, const Vec3& way, double reach) {
    double begin = 0.0, end = 1.0;
    for (int k = 0; k < 3; ++k) {
      const double low = node.low[side][k] - reach - from[k], high = node.high[side][k] + reach - from[k];
      if (way[k] == 0.0) {
        if (low > 0.0 || high < 0.0) return false;
        continue;
      }
      const double one = low / way[k], other = high / way[k];
      begin = std::max(begin, std::min(one, other));
      end = std::min(end, std::max(one, other));
    }
    return begin <= end;
  }

  const TriMesh& mesh_;
  OpenBorders borders_;
  std::vector<std::uint32_t> vertices_;
  BoxTree tree_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_;  ///< by half-edge
};

}  // namespace

BorderGaps findBorderGaps(const TriMesh& mesh) {
  constexpr double kPartOfSize = 0.01;
  BorderGaps gaps;
  const double reach = std::min(kWidestCrackMm, kPartOfSize * meshBounds(mesh).size().norm());
  const OpenBorders borders(mesh);
  for (const OpenEdge& edge : borders.edges()) addBorder(borders, edge, reach, gaps);
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    if (last - first == 1 || (last - first) % 2 == 0) return;
    if (gaps.hole_edges++ == 0) gaps.first_hole = 0.5 * (borders.point(low) + borders.point(first->other));
  });
  return gaps;
}

std::string crackText(const BorderGaps& gaps) {
  constexpr double kNone = 5e-7;
  const std::string width = gaps.width_mm < kNone ? "0" : fmt::format("{:.1g}", gaps.width_mm);
  return fmt::format("cracks of up to {} mm, the widest at {} mm", width, placeText(gaps.widest));
}

CrackRepair closeCracks(TriMesh& mesh, double reach) {
  constexpr int kMostRounds = 3;  // a facet is split at one of its edges a round
  CrackRepair out;
  out.merged = mergeNearBorders(mesh, reach);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t split = EdgeSplits(mesh, reach).apply(mesh);
    if (split == 0) break;
    out.split += split;
  }
  return out;
}

}  // namespace proveout
