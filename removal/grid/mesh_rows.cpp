#include "removal/grid/mesh_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel_for.h"

namespace proveout {
namespace {

/// Above 0 left of the line from a to b; of b to a exactly the negative, so that of two triangles beside an
/// edge one holds a point, never both or none.
double sideOf(const Vec2& a, const Vec2& b, const Vec2& p) {
  const bool turned = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
  const Vec2 &from = turned ? b : a, &to = turned ? a : b;
  double side = (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
  if (side == 0.0) side = 1e-300;
  return turned ? -side : side;
}

struct Shadow {
  std::array<Vec2, 3> corner;
  std::array<double, 3> along;

  Shadow(const std::array<Vec3, 3>& p, int axis) {
    for (int k = 0; k < 3; ++k) {
      corner[k] = Vec2(p[k][(axis + 1) % 3], p[k][(axis + 2) % 3]);
      along[k] = p[k][axis];
    }
  }
  int low(int d) const {
    return static_cast<int>(std::ceil(std::min({corner[0][d], corner[1][d], corner[2][d]})));
  }
  int high(int d) const {
    return static_cast<int>(std::floor(std::max({corner[0][d], corner[1][d], corner[2][d]})));
  }
  /// Place along the axis, if the line through p meets the triangle.
  bool meets(const Vec2& p, double& at) const {
    const double a = sideOf(corner[1], corner[2], p), b = sideOf(corner[2], corner[0], p),
                 c = sideOf(corner[0], corner[1], p);
    if (!((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0))) return false;
    at = (a * along[0] + b * along[1] + c * along[2]) / (a + b + c);
    return true;
  }
};

}  // namespace

MeshRows::MeshRows(const TriMesh& mesh, const Vec3& origin, double h) : mesh_(mesh) {
  points_.reserve(mesh.positions.size());
  for (const Eigen::Vector3f& p : mesh.positions) points_.push_back((p.cast<double>() - origin) / h);
  parallelFor(0, 3, [&](int axis) { rows_[axis] = rowsAlong(axis); });
}

MeshRows::Rows MeshRows::rowsAlong(int axis) const {
  Rows rows;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& p : points_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  rows.first_u = static_cast<int>(std::floor(low[u]));
  rows.first_v = static_cast<int>(std::floor(low[v]));
  rows.count_u = static_cast<int>(std::ceil(high[u])) - rows.first_u + 1;
  rows.count_v = static_cast<int>(std::ceil(high[v])) - rows.first_v + 1;
  rows.start.assign(static_cast<std::size_t>(rows.count_u) * static_cast<std::size_t>(rows.count_v) + 1, 0);
  const auto forEach = [&](auto&& body) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& corners = mesh_.triangles[t];
      const Shadow shadow({points_[corners[0]], points_[corners[1]], points_[corners[2]]}, axis);
      for (int i = shadow.low(0); i <= shadow.high(0); ++i) {
        for (int j = shadow.low(1); j <= shadow.high(1); ++j) {
          double at;
          if (!shadow.meets(Vec2(i, j), at)) continue;
          body(static_cast<std::size_t>(i - rows.first_u) * static_cast<std::size_t>(rows.count_v) +
                   static_cast<std::size_t>(j - rows.first_v),
               Meeting{at, t});
        }
      }
    }
  };
  forEach([&](std::size_t line, const Meeting&) { ++rows.start[line + 1]; });
  for (std::size_t k = 1; k < rows.start.size(); ++k) rows.start[k] += rows.start[k - 1];
  rows.meetings.resize(rows.start.back());
  std::vector<std::uint32_t> next(rows.start.begin(), rows.start.end() - 1);
  forEach([&](std::size_t line, const Meeting& meeting) { rows.meetings[next[line]++] = meeting; });
  for (std::size_t k = 0; k + 1 < rows.start.size(); ++k) {
    std::sort(rows.meetings.begin() + rows.start[k], rows.meetings.begin() + rows.start[k + 1],
              [](const Meeting& a, const Meeting& b) {
                return a.at != b.at ? a.at < b.at : a.triangle < b.triangle;
              });
  }
  return rows;
}

std::span<const MeshRows::Meeting> MeshRows::Rows::line(int u, int v) const {
  const int i = u - first_u, j = v - first_v;
  if (i < 0 || j < 0 || i >= count_u || j >= count_v) return {};
  const std::size_t k =
      static_cast<std::size_t>(i) * static_cast<std::size_t>(count_v) + static_cast<std::size_t>(j);
  return {meetings.data() + start[k], start[k + 1] - start[k]};
}

LeafBits MeshRows::material(const Coord& first) const {
  LeafBits bits{};
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      const std::span<const Meeting> line = rows_[2].line(first.x() + x, first.y() + y);
      std::size_t below = 0;
      for (int z = 0; z < 8; ++z) {
        while (below < line.size() && line[below].at <= first.z() + z) ++below;
        if (below % 2 == 1) bits[z] |= 1ull << leafBit(x, y);
      }
    }
  }
  return bits;
}

const MeshRows::Meeting* MeshRows::onEdge(const Coord& start, int axis, bool nearest_to_start) const {
  const std::span<const Meeting> line = rows_[axis].line(start[(axis + 1) % 3], start[(axis + 2) % 3]);
  const double from = start[axis];
  const auto first =
      std::lower_bound(line.begin(), line.end(), from, [](const Meeting& m, double at) { return m.at < at; });
  auto last = first;
  while (last != line.end() && last->at <= from + 1.0) ++last;
  if (first == last) return nullptr;
  return nearest_to_start ? &*first : &*(last - 1);
}

Vec3 MeshRows::normal(std::uint32_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Vec3 n = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::UnitZ());
}

}  // namespace proveout
