#include "core/mesh/signed_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "core/mesh/edge_table.h"

namespace proveout {

namespace {

/// Faces lower than this have no normal to trust: coordinates come as float, whose rounding is of that size,
/// mm.
constexpr double kSliverHeight = 2e-5;
/// Cosine between the direction to the nearest point and its normal under which the normal tells nothing.
constexpr double kTangential = 1e-3;
/// Faces that turn by more than 154 degrees at an edge are a fold of the mesh, if not a knife's edge.
constexpr float kFold = -0.9f;
/// Nobody asks for the sign of less, mm.
constexpr double kUntold = 1e-4;
/// Within rounding.
constexpr double kSameSide = 1.0 - 1e-9;
/// Far below what a coordinate in float can say, mm.
constexpr double kOnSurface = 1e-9;

}  // namespace

SignedDistance::SignedDistance(const SurfaceMesh& mesh, double sure_mm)
    : mesh_(mesh), sure_mm_(sure_mm), normals_(mesh), tree_(mesh) {}

SignedDistance::Normals::Normals(const SurfaceMesh& mesh) {
  compute(mesh);
  findNeighbours(mesh);
  doubtFolds(mesh);
}

void SignedDistance::Normals::compute(const SurfaceMesh& mesh) {
  of_face.assign(mesh.triangles.size(), Eigen::Vector3f::Zero());
  of_vertex.assign(mesh.points.size(), Eigen::Vector3f::Zero());
  std::vector<char> doubtful(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const std::array<Vec3, 3> p = {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
    const Vec3 normal = mesh.areaVector(t);
    const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    if (normal.norm() <= kSliverHeight * longest) {
      for (const auto i : v) doubtful[i] = 1;
      continue;
    }
    const Vec3 unit = normal.normalized();
    of_face[t] = toFloat(unit);
    for (int c = 0; c < 3; ++c) {
      const Vec3 e = p[(c + 1) % 3] - p[c], f = p[(c + 2) % 3] - p[c];
      of_vertex[v[c]] += toFloat(unit * std::atan2(e.cross(f).norm(), e.dot(f)));
    }
  }
  for (std::size_t i = 0; i < doubtful.size(); ++i) {
    if (doubtful[i]) of_vertex[i].setZero();
  }
}

void SignedDistance::Normals::findNeighbours(const SurfaceMesh& mesh) {
  neighbour.assign(3 * mesh.triangles.size(), TriangleTree::kNone);
  const EdgeTable edges(mesh.points.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    if (last - first == 2) {
      neighbour[first[0].half_edge] = first[1].half_edge / 3;
      neighbour[first[1].half_edge] = first[0].half_edge / 3;
    } else {
      of_vertex[low].setZero();
      of_vertex[first->other].setZero();
    }
  });
}

/// Takes the normals away where the mesh folds back: of the triangles there and of their vertices.
void SignedDistance::Normals::doubtFolds(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> folded;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t other = neighbour[3 * t + c];
      if (other != TriangleTree::kNone && of_face[t].dot(of_face[other]) < kFold) folded.push_back(t);
    }
  }
  for (const std::uint32_t t : folded) {
    of_face[t].setZero();
    for (const auto v : mesh.triangles[t]) of_vertex[v].setZero();
  }
}

Vec3 SignedDistance::featureNormal(std::uint32_t triangle, int part) const {
  if (part == kFacePart) return normals_.of_face[triangle].cast<double>();
  if (part < 3)
    return normals_.of_vertex[mesh_.triangles[triangle][static_cast<std::size_t>(part)]].cast<double>();
  const std::uint32_t other = neighbour(triangle, part - 3);
  if (other == TriangleTree::kNone || normals_.of_face[triangle].isZero() || normals_.of_face[other].isZero())
    return Vec3::Zero();
  return (normals_.of_face[triangle] + normals_.of_face[other]).cast<double>();
}

SurfaceDistance SignedDistance::at(const Vec3& point, const Known* known) const {
  const TriangleTree::Nearest nearest =
      tree_.nearest(point, known ? known->distance.triangle : TriangleTree::kNone);
  const Vec3 away = point - nearest.point;
  const Vec3 normal = featureNormal(nearest.triangle, nearest.part);
  const double length = away.norm();
  SurfaceDistance out;
  out.triangle = nearest.triangle;
  out.part = static_cast<std::int8_t>(nearest.part);
  out.distance = length;
  if (length < kOnSurface) {
    const Vec3 n = normal.isZero() ? mesh_.areaVector(nearest.triangle).normalized() : normal.normalized();
    out.distance = away.dot(n);
    out.gradient = toFloat(n);
    return out;
  }
  const double cosine = normal.isZero() ? 0.0 : away.dot(normal) / (length * normal.norm());
  bool within = cosine < 0.0;
  const bool doubtful = length > sure_mm_ || std::abs(cosine) < kTangential;
  if (doubtful && length < kUntold) {
    within = away.dot(mesh_.areaVector(nearest.triangle)) < 0.0;
  } else if (doubtful) {
    // The surface does not pass between two points that are nearer to each other than to it, both taken
    // together.
    const bool same_side =
        known && std::abs(known->distance.distance) > sure_mm_ &&
        (known->point - point).norm() < kSameSide * (std::abs(known->distance.distance) + length);
    within = same_side ? known->distance.distance < 0.0 : inside(point);
  }
  if (within) out.distance = -length;
  out.gradient = toFloat(away / out.distance);
  return out;
}

std::vector<SurfaceDistance> SignedDistance::at(const std::vector<Vec3>& points, Progress& progress,
                                                double from, double to) const {
  std::vector<SurfaceDistance> out(points.size());
  constexpr std::size_t kBlock = 512;
  const std::size_t blocks = (points.size() + kBlock - 1) / kBlock;
  std::atomic<std::size_t> done{0};
  parallelFor(std::size_t{0}, blocks, [&](std::size_t block) {
    if (progress.cancelled()) return;
    const std::size_t first = block * kBlock, last = std::min(points.size(), first + kBlock);
    Known known;
    for (std::size_t i = first; i < last; ++i) {
      out[i] = at(points[i], i == first ? nullptr : &known);
      known = {points[i], out[i]};
    }
    const std::size_t count = done.fetch_add(1) + 1;
    if (count % 64 == 0)
      progress.report("comparing", from + (to - from) * static_cast<double>(count) / blocks);
  });
  if (progress.cancelled()) out.clear();
  return out;
}

}  // namespace proveout
