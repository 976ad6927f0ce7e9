#include "removal/wire/part_fans.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "core/mesh/edge_table.h"

namespace proveout {
namespace {

/// An edge of a triangle, from its corner `corner` to the next.
struct Side {
  std::uint32_t low, high;  ///< its vertices, the lower number first
  std::uint32_t triangle;
  std::uint32_t corner;
  bool forward;  ///< it goes from low to high
};

std::vector<Side> sidesInOrder(const TriMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

class FanParter {
 public:
  explicit FanParter(TriMesh& mesh) : mesh_(mesh), corners_(3 * mesh.triangles.size()) {}

  void part() {
    const std::vector<Side> sides = sidesInOrder(mesh_);
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
      pair(sides, i, end);
      i = end;
    }
    renumber();
    divideShared();
  }

 private:
  void pair(const std::vector<Side>& sides, std::size_t first, std::size_t end) {
    if (end - first == 2) {
      join(sides[first], sides[first + 1]);
      return;
    }
    // About the edge, from low to high, counter-clockwise: behind a triangle that goes forward the material
    // lies in front of it, up to the next that goes back.
    std::vector<std::pair<double, const Side*>> around;
    for (std::size_t i = first; i < end; ++i) around.emplace_back(angleOf(sides[i]), &sides[i]);
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first < b.first;
      return a.second->triangle < b.second->triangle;
    });
    std::vector<bool> used(around.size(), false);
    for (std::size_t k = 0; k < around.size(); ++k) {
      if (!around[k].second->forward) continue;
      for (std::size_t step = 1; step < around.size(); ++step) {
        const std::size_t other = (k + around.size() - step) % around.size();
        if (around[other].second->forward || used[other]) continue;
        used[other] = true;
        join(*around[k].second, *around[other].second);
        of_several_.push_back({*around[k].second, *around[other].second});
        break;
      }
    }
  }

  double angleOf(const Side& side) const {
    const Vec3 a = at(side.low), axis = (at(side.high) - a).normalized();
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    const Vec3 d = at(mesh_.triangles[side.triangle][(side.corner + 2) % 3]) - a;
    return std::atan2(d.dot(v), d.dot(u));
  }
  Vec3 at(std::uint32_t vertex) const { return mesh_.positions[vertex].cast<double>(); }

  /// The corners of both triangles at both ends of their edge.
  void join(const Side& a, const Side& b) {
    const auto corner = [](const Side& s, bool low) {
      return 3 * s.triangle + (s.forward == low ? s.corner : (s.corner + 1) % 3);
    };
    corners_.join(corner(a, true), corner(b, true));
    corners_.join(corner(a, false), corner(b, false));
  }

  /// Two triangles that meet at an edge where there are more.
  struct Pair {
    Side a, b;
  };

  /// Where one fan passes an edge twice its vertices stay: there each pair of triangles gets a vertex of its
  /// own on the edge.
  void divideShared() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (const Pair& pair : of_several_) {
      const std::uint32_t from = mesh_.triangles[pair.a.triangle][pair.a.corner],
                          to = mesh_.triangles[pair.a.triangle][(pair.a.corner + 1) % 3];
      if (!taken.insert({std::min(from, to), std::max(from, to)}).second) shared_.push_back({pair, from, to});
    }
    for (const SharedEdge& edge : shared_) {
      const auto middle = static_cast<std::uint32_t>(mesh_.positions.size());
      const Eigen::Vector3f p = mesh_.positions[edge.from], q = mesh_.positions[edge.to];
      mesh_.positions.push_back(0.5f * (p + q));
      divide(edge.pair.a.triangle, edge.from, edge.to, middle);
      divide(edge.pair.b.triangle, edge.to, edge.from, middle);
    }
  }

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

  /// The first fan of a vertex keeps it.
  void renumber() {
    constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    std::vector<std::uint32_t> keeper(mesh_.positions.size(), kNone);
    std::vector<std::uint32_t> number(3 * mesh_.triangles.size(), kNone);
    for (std::uint32_t c = 0; c < number.size(); ++c) {
      const std::uint32_t fan = corners_.find(c);
      std::uint32_t& vertex = mesh_.triangles[c / 3][c % 3];
      if (number[fan] == kNone) {
        if (keeper[vertex] == kNone) {
          keeper[vertex] = fan;
          number[fan] = vertex;
        } else {
          number[fan] = static_cast<std::uint32_t>(mesh_.positions.size());
          mesh_.positions.push_back(mesh_.positions[vertex]);
        }
      }
      vertex = number[fan];
    }
  }

  struct SharedEdge {
    Pair pair;
    std::uint32_t from, to;  ///< as the first triangle has it
  };

  TriMesh& mesh_;
  DisjointSets corners_;
  std::vector<Pair> of_several_;
  std::vector<SharedEdge> shared_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> pieces_;
};

}  // namespace

void partFans(TriMesh& mesh) { FanParter(mesh).part(); }

}  // namespace proveout
