#include "core/mesh/exact_meeting.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace proveout {
namespace {

/// A sum of doubles that do not overlap, the smallest first: differences and products of floats have room.
class Exact {
 public:
  Exact() = default;
  /// a - b
  Exact(double a, double b) {
    add(a);
    add(-b);
  }

  int sign() const { return parts_.empty() ? 0 : parts_.back() > 0.0 ? 1 : -1; }

  friend Exact operator+(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(part);
    return a;
  }
  friend Exact operator-(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(-part);
    return a;
  }
  friend Exact operator*(const Exact& a, const Exact& b) {
    Exact out;
    for (const double x : a.parts_) {
      for (const double y : b.parts_) {
        const double product = x * y;
        out.add(std::fma(x, y, -product));
        out.add(product);
      }
    }
    return out;
  }

 private:
  void add(double x) {
    std::vector<double> sum;
    sum.reserve(parts_.size() + 1);
    for (const double part : parts_) {
      // What x + part loses by rounding (Knuth's sum of two).
      const double both = x + part, of_part = both - x;
      const double lost = (x - (both - of_part)) + (part - of_part);
      if (lost != 0.0) sum.push_back(lost);
      x = both;
    }
    if (x != 0.0) sum.push_back(x);
    parts_ = std::move(sum);
  }

  std::vector<double> parts_;
};

using Point = Eigen::Vector3f;
using Points = std::array<Point, 3>;

/// The side of the plane through a, b and c that d is on.
int sideOf(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<Exact, 3>, 3> m;
  const std::array<const Point*, 3> ends = {&b, &c, &d};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      m[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = {(*ends[static_cast<std::size_t>(i)])[k],
                                                                     a[k]};
  }
  const auto minor = [&](std::size_t k, std::size_t l) { return m[0][k] * m[1][l] - m[0][l] * m[1][k]; };
  return (minor(0, 1) * m[2][2] + minor(1, 2) * m[2][0] + minor(2, 0) * m[2][1]).sign();
}

/// Seen along an axis: whether a, b and c turn left (1) or right (-1).
int turn(const Point& a, const Point& b, const Point& c, int axis) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  return (Exact(b[x], a[x]) * Exact(c[y], a[y]) - Exact(b[y], a[y]) * Exact(c[x], a[x])).sign();
}

/// An axis along which a triangle is none but a line; below 0: along all of them.
int axisOf(const Points& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (turn(t[0], t[1], t[2], axis) != 0) return axis;
  }
  return -1;
}

bool sameSide(int a, int b, int c) { return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0); }

/// A segment and a triangle of one plane.
bool meetInPlane(const Point& p, const Point& q, const Points& t) {
  const int axis = axisOf(t);
  if (axis < 0) return false;
  for (const Point* end : {&p, &q}) {
    if (sameSide(turn(t[0], t[1], *end, axis), turn(t[1], t[2], *end, axis), turn(t[2], t[0], *end, axis)))
      return true;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = t[i], &to = t[(i + 1) % 3];
    const int of_p = turn(from, to, p, axis), of_q = turn(from, to, q, axis);
    if (of_p == 0 && of_q == 0) continue;  // on one line: the other edges tell it, if they overlap
    if (of_p * of_q <= 0 && turn(p, q, from, axis) * turn(p, q, to, axis) <= 0) return true;
  }
  return false;
}

bool segmentMeets(const Point& p, const Point& q, const Points& t) {
  const int of_p = sideOf(t[0], t[1], t[2], p), of_q = sideOf(t[0], t[1], t[2], q);
  if (of_p * of_q > 0) return false;
  if (of_p == 0 && of_q == 0) return meetInPlane(p, q, t);
  return sameSide(sideOf(p, q, t[0], t[1]), sideOf(p, q, t[1], t[2]), sideOf(p, q, t[2], t[0]));
}

/// Triangles with an edge in common, each with one corner more.
bool folded(const Point& from, const Point& to, const Point& a, const Point& b) {
  if (sideOf(from, to, a, b) != 0) return false;
  const int axis = axisOf({from, to, a});
  return axis >= 0 && turn(from, to, a, axis) == turn(from, to, b, axis);
}

Points pointsOf(const TriMesh& mesh, std::uint32_t t) {
  const auto& v = mesh.triangles[t];
  return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

}  // namespace

bool meetExactly(const TriMesh& mesh, std::uint32_t s, std::uint32_t t) {
  const Points p = pointsOf(mesh, s), q = pointsOf(mesh, t);
  std::array<bool, 3> common_p{}, common_q{};
  int common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.triangles[s][i] != mesh.triangles[t][k]) continue;
      common_p[i] = common_q[k] = true;
      ++common;
    }
  }
  if (common >= 3) return true;
  const auto freeCorner = [](const std::array<bool, 3>& of) { return !of[0] ? 0u : !of[1] ? 1u : 2u; };
  if (common == 2) {
    const std::size_t i = freeCorner(common_p), k = freeCorner(common_q);
    return folded(p[(i + 1) % 3], p[(i + 2) % 3], p[i], q[k]);
  }
  // Edges at a common corner meet the other triangle there; what is beyond that the opposite ones show.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (!common_p[i] && !common_p[next] && segmentMeets(p[i], p[next], q)) return true;
    if (!common_q[i] && !common_q[next] && segmentMeets(q[i], q[next], p)) return true;
  }
  return false;
}

bool isFlat(const TriMesh& mesh, std::uint32_t t) { return axisOf(pointsOf(mesh, t)) < 0; }

int turnFromAbove(const TriMesh& mesh, std::uint32_t t) {
  const Points p = pointsOf(mesh, t);
  return turn(p[0], p[1], p[2], 2);
}

}  // namespace proveout
