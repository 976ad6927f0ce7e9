#include "removal/signed_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/blocked_range.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "core/base/parallel_for.h"
#include "core/mesh/edge_table.h"

namespace proveout {

const std::array<Vec3, 3>& oddDirections() {
  static const std::array<Vec3, 3> directions = {Vec3(0.5377, 0.3189, 0.7807).normalized(),
                                                 Vec3(-0.2843, 0.8317, -0.4771).normalized(),
                                                 Vec3(0.1931, -0.6473, -0.7374).normalized()};
  return directions;
}

namespace distance_detail {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr std::uint32_t kNoNeighbour = 0xFFFFFFFFu;
/// Faces lower than this have no normal to trust: coordinates come as float, whose rounding is of that size,
/// mm.
constexpr double kSliverHeight = 2e-5;
/// Cosine between the direction to the nearest point and its normal under which rays decide.
constexpr double kTangential = 1e-3;

Kernel::Point_3 toCgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 fromCgal(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Part of a triangle that holds the point nearest to another point: corner 0..2, edge 3..5 (from corner
/// i - 3 to the next), or the face.
constexpr int kFace = 6;
struct Feature {
  Vec3 point;
  int part = kFace;
};

/// Nearest point of triangle abc to p by the signs of its barycentric coordinates and of the projections on
/// its edges.
Feature nearestOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
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
  return {a + ab * (wb / sum) + ac * (wc / sum), kFace};
}

}  // namespace distance_detail

using distance_detail::Feature;
using distance_detail::Tree;

struct SignedDistance::Impl {
  explicit Impl(const SurfaceMesh& surface);
  void computeNormals();
  void findNeighbours();
  Vec3 featureNormal(std::uint32_t triangle, int part) const;
  SurfaceDistance judge(const Vec3& query, const Tree::Point_and_primitive_id& nearest) const;
  bool inside(const Vec3& point) const;

  std::uint32_t indexOf(distance_detail::Triangles::const_iterator it) const {
    return static_cast<std::uint32_t>(it - triangles.begin());
  }

  const SurfaceMesh& mesh;
  distance_detail::Triangles triangles;
  Tree tree;
  std::vector<Vec3> face_normal;         ///< unit; zero: not to be trusted
  std::vector<Vec3> vertex_normal;       ///< angle-weighted, not unit; zero: not to be trusted
  std::vector<std::uint32_t> neighbour;  ///< per half-edge: the triangle beyond
};

SignedDistance::Impl::Impl(const SurfaceMesh& surface) : mesh(surface) {
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(distance_detail::toCgal(mesh.points[t[0]]),
                           distance_detail::toCgal(mesh.points[t[1]]),
                           distance_detail::toCgal(mesh.points[t[2]]));
  }
  tree.insert(triangles.cbegin(), triangles.cend());
  tree.build();
  tree.accelerate_distance_queries();
  tree.closest_point_and_primitive(
      triangles.front().vertex(0));  // builds what is built lazily, before threads come
  computeNormals();
  findNeighbours();
}

void SignedDistance::Impl::computeNormals() {
  face_normal.assign(mesh.triangles.size(), Vec3::Zero());
  vertex_normal.assign(mesh.points.size(), Vec3::Zero());
  std::vector<char> doubtful(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const std::array<Vec3, 3> p = {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    if (normal.norm() <= distance_detail::kSliverHeight * longest) {
      for (const auto i : v) doubtful[i] = 1;
      continue;
    }
    face_normal[t] = normal.normalized();
    for (int c = 0; c < 3; ++c) {
      const Vec3 e = p[(c + 1) % 3] - p[c], f = p[(c + 2) % 3] - p[c];
      vertex_normal[v[c]] += face_normal[t] * std::atan2(e.cross(f).norm(), e.dot(f));
    }
  }
  for (std::size_t i = 0; i < doubtful.size(); ++i) {
    if (doubtful[i]) vertex_normal[i] = Vec3::Zero();
  }
}

void SignedDistance::Impl::findNeighbours() {
  neighbour.assign(3 * mesh.triangles.size(), distance_detail::kNoNeighbour);
  const EdgeTable edges(mesh.points.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    if (last - first == 2) {
      neighbour[first[0].half_edge] = first[1].half_edge / 3;
      neighbour[first[1].half_edge] = first[0].half_edge / 3;
    } else {
      vertex_normal[low] = vertex_normal[first->other] = Vec3::Zero();
    }
  });
}

Vec3 SignedDistance::Impl::featureNormal(std::uint32_t triangle, int part) const {
  if (part == distance_detail::kFace) return face_normal[triangle];
  if (part < 3) return vertex_normal[mesh.triangles[triangle][part]];
  const std::uint32_t other = neighbour[3 * triangle + (part - 3)];
  if (other == distance_detail::kNoNeighbour || face_normal[triangle].isZero() ||
      face_normal[other].isZero()) {
    return Vec3::Zero();
  }
  return face_normal[triangle] + face_normal[other];
}

SurfaceDistance SignedDistance::Impl::judge(const Vec3& query,
                                            const Tree::Point_and_primitive_id& nearest) const {
  const std::uint32_t index = indexOf(nearest.second);
  const auto& v = mesh.triangles[index];
  const Feature feature =
      distance_detail::nearestOfTriangle(query, mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
  Vec3 away = query - distance_detail::fromCgal(nearest.first);
  Vec3 normal = featureNormal(index, feature.part);
  // Two ways to the nearest point that disagree: a triangle too thin for one of them.
  if ((away - (query - feature.point)).norm() > 1e-7) normal.setZero();
  const double length = away.norm();
  SurfaceDistance out;
  out.triangle = index;
  out.distance = length;
  constexpr double kOnSurface = 1e-9;  // mm, far below what a coordinate in float can say
  if (length < kOnSurface) {
    const Vec3 n = normal.isZero() ? face_normal[index] : normal.normalized();
    out.distance = away.dot(n);
    out.gradient = n.cast<float>();
    return out;
  }
  const double cosine = normal.isZero() ? 0.0 : away.dot(normal) / (length * normal.norm());
  const bool is_inside = std::abs(cosine) < distance_detail::kTangential ? inside(query) : cosine < 0.0;
  if (is_inside) out.distance = -length;
  out.gradient = (away / out.distance).cast<float>();
  return out;
}

bool SignedDistance::Impl::inside(const Vec3& point) const {
  int votes = 0;
  for (const Vec3& d : oddDirections()) {
    const distance_detail::Kernel::Ray_3 ray(distance_detail::toCgal(point),
                                             distance_detail::toCgal(point + d));
    votes += tree.number_of_intersected_primitives(ray) % 2 == 1;
  }
  return votes >= 2;
}

SignedDistance::SignedDistance(const SurfaceMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
SignedDistance::~SignedDistance() = default;

bool SignedDistance::inside(const Vec3& point) const { return impl_->inside(point); }

std::vector<std::uint32_t> SignedDistance::crossings(const Vec3& origin, const Vec3& direction) const {
  const distance_detail::Kernel::Ray_3 ray(distance_detail::toCgal(origin),
                                           distance_detail::toCgal(origin + direction));
  std::vector<distance_detail::Triangles::const_iterator> hits;
  impl_->tree.all_intersected_primitives(ray, std::back_inserter(hits));
  std::vector<std::uint32_t> out;
  for (const auto hit : hits) out.push_back(impl_->indexOf(hit));
  return out;
}

std::vector<SurfaceDistance> SignedDistance::at(const std::vector<Vec3>& points, Progress& progress,
                                                double from, double to) const {
  std::vector<SurfaceDistance> out(points.size());
  // The triangle nearest to one point gives the first guess for the next. Blocks are of fixed size, so that
  // the guesses, and with them the choice among equally near triangles, do not depend on the threads.
  constexpr std::size_t kBlock = 512;
  const std::size_t blocks = (points.size() + kBlock - 1) / kBlock;
  std::atomic<std::size_t> done{0};
  parallelFor(std::size_t{0}, blocks, [&](std::size_t block) {
    if (progress.cancelled()) return;
    const std::size_t first = block * kBlock, last = std::min(points.size(), first + kBlock);
    auto nearest = impl_->tree.closest_point_and_primitive(distance_detail::toCgal(points[first]));
    for (std::size_t i = first; i < last; ++i) {
      const auto& v = impl_->mesh.triangles[impl_->indexOf(nearest.second)];
      const auto& p = impl_->mesh.points;
      nearest.first = distance_detail::toCgal(
          distance_detail::nearestOfTriangle(points[i], p[v[0]], p[v[1]], p[v[2]]).point);
      nearest = impl_->tree.closest_point_and_primitive(distance_detail::toCgal(points[i]), nearest);
      out[i] = impl_->judge(points[i], nearest);
    }
    const std::size_t count = done.fetch_add(1) + 1;
    if (count % 64 == 0)
      progress.report("comparing", from + (to - from) * static_cast<double>(count) / blocks);
  });
  if (progress.cancelled()) out.clear();
  return out;
}

}  // namespace proveout
