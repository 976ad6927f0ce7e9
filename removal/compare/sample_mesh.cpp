// Edges are divided evenly, the same way for both their triangles. A triangle is filled from outside to
// inside: while its incircle is large, a smaller triangle about the incentre is put into it and the three
// strips between the two are closed like a zip; the rest is closed between the longest side and the other
// two. Slivers so get points along their length only, which splitting at edge middles would not manage.
#include "removal/compare/sample_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/assert.h"

namespace proveout {
namespace sample_detail {

/// Point numbers from one corner of a triangle to another, both included.
using Chain = std::vector<std::uint32_t>;

/// A ring is as wide as the rows of equilateral triangles are high.
constexpr double kRowHeight = 0.8660254037844386;

/// Triangles after filling, estimated: by area, and by length for those that are thinner than the spacing.
double estimateTriangles(const TriMesh& mesh, double spacing) {
  double count = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 b = mesh.positions[t[1]].cast<double>();
    const Vec3 c = mesh.positions[t[2]].cast<double>();
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    count += 1.0 + 2.5 * area / (spacing * spacing) + 2.0 * longest / spacing;
  }
  return count;
}

class Filler {
 public:
  Filler(SampleMesh& mesh, double spacing) : mesh_(mesh), spacing_(spacing) {}

  void fill(const std::array<std::uint32_t, 3>& corners, std::uint32_t parent) {
    parent_ = parent;
    std::array<Chain, 3> sides;
    bool small = true;
    for (int i = 0; i < 3; ++i) {
      sides[i] = sharedEdge(corners[i], corners[(i + 1) % 3]);
      small = small && sides[i].size() == 2;
    }
    if (small) {
      add(corners[0], corners[1], corners[2]);
      return;
    }
    for (Incircle circle = incircle(sides); circle.radius > 0.6 * spacing_; circle = incircle(sides)) {
      sides = fillRing(sides, circle.center, std::min(1.0, kRowHeight * spacing_ / circle.radius));
      if (sides[0].empty()) return;
    }
    closeRest(sides);
  }

 private:
  struct Incircle {
    Vec3 center;
    double radius;
  };

  const Vec3& point(std::uint32_t i) const { return mesh_.surface.points[i]; }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.surface.triangles.push_back({a, b, c});
    mesh_.parent.push_back(parent_);
  }
  std::uint32_t addPoint(const Vec3& p) {
    mesh_.surface.points.push_back(p);
    return static_cast<std::uint32_t>(mesh_.surface.points.size() - 1);
  }

  Chain divide(std::uint32_t from, std::uint32_t to) {
    const Vec3 a = point(from), b = point(to);
    const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing_ - 1e-9)));
    Chain chain = {from};
    for (int i = 1; i < parts; ++i) chain.push_back(addPoint(a + (b - a) * (static_cast<double>(i) / parts)));
    chain.push_back(to);
    return chain;
  }

  Chain sharedEdge(std::uint32_t from, std::uint32_t to) {
    const std::uint32_t low = std::min(from, to), high = std::max(from, to);
    Chain chain;
    if ((point(low) - point(high)).norm() <= spacing_) {
      chain = {low, high};
    } else {
      const auto [place, is_new] = edges_.try_emplace(std::uint64_t{low} << 32 | high);
      if (is_new) place->second = divide(low, high);
      chain = place->second;
    }
    if (from != low) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  Incircle incircle(const std::array<Chain, 3>& sides) const {
    const Vec3 &a = point(sides[0][0]), &b = point(sides[1][0]), &c = point(sides[2][0]);
    const double la = (c - b).norm(), lb = (a - c).norm(), lc = (b - a).norm(), sum = la + lb + lc;
    return {(la * a + lb * b + lc * c) / sum, (b - a).cross(c - a).norm() / sum};
  }

  /// Puts a triangle that is smaller by `step` (0..1] about `center` into the one with these sides and fills
  /// what is between. Returns the sides of the inner one; empty where it has shrunk to its centre.
  std::array<Chain, 3> fillRing(const std::array<Chain, 3>& sides, const Vec3& center, double step) {
    std::array<std::uint32_t, 3> inner;
    std::array<Chain, 3> spokes;
    const bool to_center = step >= 1.0;
    const std::uint32_t middle = to_center ? addPoint(center) : 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 corner = point(sides[i][0]);
      inner[i] = to_center ? middle : addPoint(corner + step * (center - corner));
      spokes[i] = divide(sides[i][0], inner[i]);
    }
    std::array<Chain, 3> result;
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      if (!to_center) result[i] = divide(inner[i], inner[next]);
      Chain upper(spokes[i].begin() + 1, spokes[i].end());
      if (!to_center) upper.insert(upper.end(), result[i].begin() + 1, result[i].end());
      upper.insert(upper.end(), spokes[next].rbegin() + 1, spokes[next].rend() - 1);
      zip(sides[i], upper);
    }
    return result;
  }

  void closeRest(const std::array<Chain, 3>& sides) {
    int base = 0;
    const auto length = [&](int i) {
      return (point(sides[i].front()) - point(sides[i].back())).squaredNorm();
    };
    for (int i = 1; i < 3; ++i) {
      if (length(i) > length(base)) base = i;
    }
    const Chain &right = sides[(base + 1) % 3], &left = sides[(base + 2) % 3];
    Chain upper(left.rbegin() + 1, left.rend());
    upper.insert(upper.end(), right.rbegin() + 1, right.rend() - 1);
    zip(sides[base], upper);
  }

  /// Closes the area between a straight chain and one to its left that starts and ends beside the ends of the
  /// first and goes the same way: always goes on where the next point is nearer along the straight chain. The
  /// first and the last piece of the straight chain keep to the ends of the other, where three points may lie
  /// in line.
  void zip(const Chain& straight, const Chain& upper) {
    PROVEOUT_ASSERT(straight.size() >= 2 && !upper.empty());
    const Vec3 direction = point(straight.back()) - point(straight.front());
    const std::size_t pieces = straight.size() - 1;
    std::size_t i = 0, j = 0;
    while (i < pieces || j + 1 < upper.size()) {
      bool along_straight = j + 1 == upper.size();
      if (!along_straight && i < pieces) {
        const bool first = i == 0, last = i + 1 == pieces;
        along_straight =
            !last && (first || direction.dot(point(straight[i + 1]) - point(upper[j + 1])) < 0.0);
      }
      if (along_straight) {
        add(straight[i], straight[i + 1], upper[j]);
        ++i;
      } else {
        add(straight[i], upper[j + 1], upper[j]);
        ++j;
      }
    }
  }

  SampleMesh& mesh_;
  double spacing_;
  std::uint32_t parent_ = 0;
  std::unordered_map<std::uint64_t, Chain> edges_;
};

}  // namespace sample_detail

SampleMesh makeSampleMesh(const TriMesh& mesh, double spacing_mm, std::size_t max_triangles) {
  PROVEOUT_ASSERT(spacing_mm > 0.0);
  SampleMesh out;
  out.spacing_mm = spacing_mm;
  const double limit =
      std::max(static_cast<double>(max_triangles), 4.0 * static_cast<double>(mesh.triangles.size()));
  while (sample_detail::estimateTriangles(mesh, out.spacing_mm) > limit) out.spacing_mm *= 1.25;
  out.surface.points.reserve(mesh.positions.size());
  out.surface.triangles.reserve(mesh.triangles.size());
  out.parent.reserve(mesh.triangles.size());
  for (const auto& p : mesh.positions) out.surface.points.push_back(p.cast<double>());
  sample_detail::Filler filler(out, out.spacing_mm);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) filler.fill(mesh.triangles[t], t);
  PROVEOUT_ASSERT(out.parent.size() == out.surface.triangles.size());
  return out;
}

}  // namespace proveout
