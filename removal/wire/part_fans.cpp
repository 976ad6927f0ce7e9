#include "removal/wire/part_fans.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
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

  TriMesh& mesh_;
  DisjointSets corners_;
};

}  // namespace

void partFans(TriMesh& mesh) { FanParter(mesh).part(); }

}  // namespace proveout
