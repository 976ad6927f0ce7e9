#include "core/mesh/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {

namespace {

/// Seen from this many of its radii, a group of triangles is a dipole.
constexpr double kFar = 3.0;

/// Of the triangle seen from the origin, steradians (A. van Oosterom, J. Strackee, 1983).
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Along a ray from the origin: 1 where it leaves through the triangle, -1 where it enters, 0 where it
/// misses; nothing where rounding could decide which.
std::optional<int> crossing(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Of a product of three vectors, as a share of their lengths: some hundred times the rounding of doubles.
  constexpr double kRounding = 1e-13;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const std::array<double, 3> turn = {direction.dot(a.cross(b)), direction.dot(b.cross(c)),
                                      direction.dot(c.cross(a))};
  const std::array<double, 3> unsure = {kRounding * la * lb, kRounding * lb * lc, kRounding * lc * la};
  int sides = 0, doubts = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(turn[k]) <= unsure[k])
      ++doubts;
    else
      sides += turn[k] > 0.0 ? 1 : -1;
  }
  if (std::abs(sides) + doubts < 3) return 0;  // the line passes outside, whatever is in doubt
  const double volume = a.dot(b.cross(c));
  if (doubts > 0 || std::abs(volume) <= kRounding * la * lb * lc) return std::nullopt;
  const int way = sides > 0 ? 1 : -1;
  return (volume > 0.0) == (way > 0) ? way : 0;  // behind the origin else
}

/// Whether a ray meets a child's bounds; true in doubt. `inverse`: of the direction, which has no zeros.
bool rayMeets(const BoxTree::Node& node, int side, const Vec3& p, const Vec3& inverse) {
  constexpr double kOutwards = 1e-9;  // of the way
  double from = 0.0, to = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double low = (static_cast<double>(node.low[side][k]) - p[k]) * inverse[k],
                 high = (static_cast<double>(node.high[side][k]) - p[k]) * inverse[k];
    from = std::max(from, std::min(low, high) - kOutwards * std::abs(low));
    to = std::min(to, std::max(low, high) + kOutwards * std::abs(high));
  }
  return from <= to * (1.0 + kOutwards);
}

/// Rounded outwards.
std::vector<ShortBox> boxesOf(const SurfaceMesh& mesh) {
  std::vector<ShortBox> boxes(mesh.triangles.size());
  parallelFor(std::size_t{0}, boxes.size(), [&](std::size_t t) {
    Box3 box;
    for (const auto v : mesh.triangles[t]) box.extend(mesh.points[v]);
    boxes[t] = ShortBox::around(box);
  });
  return boxes;
}

}  // namespace

TrianglePoint nearestOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double ab_a = ab.dot(ap), ac_a = ac.dot(ap);
  if (ab_a <= 0.0 && ac_a <= 0.0) return {a, 0};
  const double ab_b = ab.dot(bp), ac_b = ac.dot(bp);
  if (ab_b >= 0.0 && ac_b <= ab_b) return {b, 1};
  const double ab_c = ab.dot(cp), ac_c = ac.dot(cp);
  if (ac_c >= 0.0 && ab_c <= ac_c) return {c, 2};
  const double wc = ab_a * ac_b - ab_b * ac_a;
  if (wc <= 0.0 && ab_a >= 0.0 && ab_b <= 0.0) return {a + ab * (ab_a / (ab_a - ab_b)), 3};
  const double wb = ab_c * ac_a - ab_a * ac_c;
  if (wb <= 0.0 && ac_a >= 0.0 && ac_c <= 0.0) return {a + ac * (ac_a / (ac_a - ac_c)), 5};
  const double wa = ab_b * ac_c - ab_c * ac_b;
  const double to_c = ac_b - ab_b, to_b = ab_c - ac_c;
  if (wa <= 0.0 && to_c >= 0.0 && to_b >= 0.0) return {b + (c - b) * (to_c / (to_c + to_b)), 4};
  const double sum = wa + wb + wc;
  return {a + ab * (wb / sum) + ac * (wc / sum), kFacePart};
}

TriangleTree::TriangleTree(const SurfaceMesh& mesh)
    : boxes_(boxesOf(mesh)), place_of_(mesh.triangles.size()) {
  keepCorners(mesh);
  dipoles_.resize(2 * boxes_.nodes().size());
  findDipoles(mesh, boxes_.root());
}

void TriangleTree::keepCorners(const SurfaceMesh& mesh) {
  const bool are_short =
      std::ranges::all_of(mesh.points, [](const Vec3& p) { return toFloat(p).cast<double>() == p; });
  if (are_short) {
    short_corners_.resize(mesh.triangles.size());
  } else {
    points_ = mesh.points;
    vertices_.resize(mesh.triangles.size());
  }
  parallelFor(std::size_t{0}, mesh.triangles.size(), [&](std::size_t i) {
    const auto& v = mesh.triangles[boxes_.order()[i]];
    place_of_[boxes_.order()[i]] = static_cast<std::uint32_t>(i);
    if (!are_short) {
      vertices_[i] = v;
      return;
    }
    for (std::size_t k = 0; k < 9; ++k)
      short_corners_[i][k] = toFloat(mesh.points[v[k / 3]][static_cast<Eigen::Index>(k % 3)]);
  });
}

TriangleTree::AreaSum TriangleTree::findDipoles(const SurfaceMesh& mesh, std::uint32_t child) {
  AreaSum sum;
  if (BoxTree::isLeaf(child)) {
    for (std::uint32_t i = BoxTree::leafBegin(child); i < BoxTree::leafEnd(child); ++i) {
      const Vec3 area = 0.5 * mesh.areaVector(boxes_.order()[i]);
      sum.add({area, area.norm() * mesh.middle(boxes_.order()[i]), area.norm()});
    }
    return sum;
  }
  const BoxTree::Node& node = boxes_.nodes()[child];
  for (std::size_t side = 0; side < 2; ++side) {
    const AreaSum group = findDipoles(mesh, node.child[side]);
    sum.add(group);
    dipoles_[2 * child + side] = dipoleOf(group, node, side);
  }
  return sum;
}

TriangleTree::Dipole TriangleTree::dipoleOf(const AreaSum& group, const BoxTree::Node& node,
                                            std::size_t side) {
  Vec3 low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = node.low[side][k];
    high[k] = node.high[side][k];
  }
  const Vec3 center = group.area > 0.0 ? Vec3(group.moment / group.area) : Vec3(0.5 * (low + high));
  Dipole dipole;
  for (int k = 0; k < 3; ++k) {
    dipole.center[k] = toFloat(center[k]);
    dipole.normal[k] = toFloat(group.normal[k]);
  }
  dipole.reach = toFloat(kFar * (high - center).cwiseMax(center - low).norm());
  return dipole;
}

void TriangleTree::tryPlace(std::uint32_t place, const Vec3& p, Nearest& best) const {
  const Corners t = cornersAt(place);
  const TrianglePoint at = nearestOfTriangle(p, t.a, t.b, t.c);
  const double squared = (p - at.point).squaredNorm();
  const std::uint32_t triangle = boxes_.order()[place];
  // Of a triangle without extent the distance may be no number.
  if (squared < best.squared || (squared == best.squared && triangle < best.triangle))
    best = {squared, triangle, at.part, at.point};
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& p, std::uint32_t hint, double within) const {
  Nearest best;
  best.squared = within * within;
  PROVEOUT_ASSERT_DEAR(hint == kNone || hint < place_of_.size());
  if (hint != kNone) tryPlace(place_of_[hint], p, best);
  struct Open {
    double squared;
    std::uint32_t child;
  };
  std::array<Open, BoxTree::kStack> stack;
  int size = 0;
  stack[size++] = {0.0, boxes_.root()};
  while (size > 0) {
    const Open open = stack[--size];
    if (open.squared > best.squared) continue;
    std::uint32_t at = open.child;
    while (!BoxTree::isLeaf(at)) {
      const BoxTree::Node& node = boxes_.nodes()[at];
      const double d[2] = {node.distance2(0, p), node.distance2(1, p)};
      const int near = d[1] < d[0] ? 1 : 0;
      if (d[1 - near] <= best.squared) stack[size++] = {d[1 - near], node.child[1 - near]};
      at = d[near] <= best.squared ? node.child[near] : BoxTree::kEmptyLeaf;
    }
    for (std::uint32_t i = BoxTree::leafBegin(at); i < BoxTree::leafEnd(at); ++i) tryPlace(i, p, best);
  }
  return best;
}

double TriangleTree::windingNumber(const Vec3& p) const {
  double sum = 0.0;
  std::array<std::uint32_t, BoxTree::kStack> stack;
  int size = 0;
  stack[size++] = boxes_.root();
  while (size > 0) {
    const std::uint32_t at = stack[--size];
    if (BoxTree::isLeaf(at)) {
      for (std::uint32_t i = BoxTree::leafBegin(at); i < BoxTree::leafEnd(at); ++i) {
        const Corners t = cornersAt(i);
        sum += solidAngle(t.a - p, t.b - p, t.c - p);
      }
      continue;
    }
    for (std::uint32_t side = 0; side < 2; ++side) {
      const Dipole& d = dipoles_[2 * at + side];
      const Vec3 to(d.center[0] - p.x(), d.center[1] - p.y(), d.center[2] - p.z());
      const double distance2 = to.squaredNorm();
      if (distance2 <= static_cast<double>(d.reach) * d.reach) {
        stack[size++] = boxes_.nodes()[at].child[side];
      } else {
        sum += to.dot(Vec3(d.normal[0], d.normal[1], d.normal[2])) / (distance2 * std::sqrt(distance2));
      }
    }
  }
  return sum / (4.0 * kPi);
}

std::optional<int> TriangleTree::crossingsAlong(const Vec3& p, const Vec3& direction) const {
  const Vec3 inverse = direction.cwiseInverse();
  int sum = 0;
  bool sure = true;
  boxes_.forEachPlaceWhere(
      [&](const BoxTree::Node& node, int side) { return sure && rayMeets(node, side, p, inverse); },
      [&](std::uint32_t place) {
        const Corners t = cornersAt(place);
        const std::optional<int> one = crossing(direction, t.a - p, t.b - p, t.c - p);
        sure = sure && one;
        sum += one.value_or(0);
      });
  return sure ? std::optional(sum) : std::nullopt;
}

std::optional<int> TriangleTree::crossings(const Vec3& p) const {
  // Along no axis, plane or diagonal that parts are drawn by.
  static const std::array<Vec3, 3> kDirections = {Vec3(0.2718, 0.3142, 0.9097).normalized(),
                                                  Vec3(-0.8931, 0.1973, 0.4043).normalized(),
                                                  Vec3(0.4271, -0.8617, -0.2739).normalized()};
  for (const Vec3& direction : kDirections) {
    if (const std::optional<int> sum = crossingsAlong(p, direction)) return sum;
  }
  return std::nullopt;
}

}  // namespace proveout
