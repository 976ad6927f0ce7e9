#include "tests/reference/reference_part.h"

#include <CGAL/AABB_segment_primitive.h>
#define CGAL_NO_CDT_2_WARNING
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <list>

namespace proveout::reference {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Exact::Point_3>;

Vec3 rounded(const Exact::Point_3& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

Mesh hull(const std::vector<Vec3>& points) {
  using Rough = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Rough::Point_3> in;
  for (const Vec3& p : points) in.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Rough::Point_3> found;
  CGAL::convex_hull_3(in.begin(), in.end(), found);
  Mesh out;
  for (const auto v : found.vertices()) {
    const auto& p = found.point(v);
    out.add_vertex(Exact::Point_3(p.x(), p.y(), p.z()));
  }
  for (const auto f : found.faces()) {
    std::vector<Mesh::Vertex_index> face;
    for (const auto v : CGAL::vertices_around_face(found.halfedge(f), found))
      face.push_back(Mesh::Vertex_index(v));
    out.add_face(face);
  }
  return out;
}

Mesh toMesh(const Polyhedron& solid) {
  Mesh out;
  if (solid.faces.empty()) {
    out = hull(solid.points);
  } else {
    for (const Vec3& p : solid.points) out.add_vertex(Exact::Point_3(p.x(), p.y(), p.z()));
    for (const auto& face : solid.faces) {
      std::vector<Mesh::Vertex_index> corners;
      for (const std::size_t v : face) corners.emplace_back(static_cast<Mesh::size_type>(v));
      out.add_face(corners);
    }
  }
  pmp::triangulate_faces(out);
  return out;
}

Vec3 normalOf(const Mesh& mesh, Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
             &c = mesh.point(mesh.target(mesh.next(h)));
  const Exact::Vector_3 n = CGAL::cross_product(b - a, c - a);
  n.exact();  // digits that cancel are there still
  return Vec3(CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())).normalized();
}

Polyhedron boxOf(const BoxShape& b) {
  Polyhedron out;
  for (int i = 0; i < 8; ++i) {
    out.points.emplace_back(i & 1 ? b.max.x() : b.min.x(), i & 2 ? b.max.y() : b.min.y(),
                            i & 4 ? b.max.z() : b.min.z());
  }
  out.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return out;
}

}  // namespace

struct ReferencePart::Impl {
  Mesh mesh;
};

ReferencePart::ReferencePart(const BoxShape& block)
    : impl_(std::make_unique<Impl>(Impl{toMesh(boxOf(block))})) {}
ReferencePart::~ReferencePart() = default;
ReferencePart::ReferencePart(ReferencePart&&) noexcept = default;
ReferencePart& ReferencePart::operator=(ReferencePart&&) noexcept = default;

bool ReferencePart::subtract(const Polyhedron& solid) {
  Mesh other = toMesh(solid), result;
  if (!CGAL::is_closed(other) || !CGAL::is_triangle_mesh(other)) return false;
  if (!pmp::corefine_and_compute_difference(impl_->mesh, other, result)) return false;
  result.collect_garbage();
  impl_->mesh = std::move(result);
  return true;
}

double ReferencePart::volume() const {
  if (impl_->mesh.is_empty()) return 0.0;
  const Mesh& mesh = impl_->mesh;
  const Vec3 apex = rounded(mesh.point(*mesh.vertices().begin()));
  double six = 0.0;
  for (const Facet& f : facets()) {
    const auto& [a, b, c] = f.corners;
    six += (a - apex).dot((b - apex).cross(c - apex));
  }
  return six / 6.0;
}

std::vector<ReferencePart::Facet> ReferencePart::facets() const {
  const Mesh& mesh = impl_->mesh;
  std::vector<Facet> out;
  for (const auto f : mesh.faces()) {
    Facet facet;
    auto h = mesh.halfedge(f);
    for (int i = 0; i < 3; ++i, h = mesh.next(h)) {
      facet.vertices[i] = static_cast<int>(mesh.source(h));
      facet.corners[i] = rounded(mesh.point(mesh.source(h)));
      facet.beside[i] = static_cast<int>(mesh.face(mesh.opposite(h)));
    }
    facet.normal = normalOf(mesh, f);
    out.push_back(facet);
  }
  return out;
}

using Plain = CGAL::Simple_cartesian<double>;

struct DistanceToEdges::Impl {
  using Segments = std::vector<Plain::Segment_3>;
  using Primitive = CGAL::AABB_segment_primitive<Plain, Segments::iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Plain, Primitive>>;
  Segments segments;
  Tree tree;
};

DistanceToEdges::DistanceToEdges(const std::vector<std::array<Vec3, 2>>& edges)
    : impl_(std::make_unique<Impl>()) {
  const auto point = [](const Vec3& p) { return Plain::Point_3(p.x(), p.y(), p.z()); };
  for (const auto& [a, b] : edges) impl_->segments.emplace_back(point(a), point(b));
  if (edges.empty()) return;
  impl_->tree.rebuild(impl_->segments.begin(), impl_->segments.end());
  impl_->tree.accelerate_distance_queries();
}
DistanceToEdges::~DistanceToEdges() = default;

double DistanceToEdges::at(const Vec3& p) const {
  if (impl_->segments.empty()) return std::numeric_limits<double>::infinity();
  return std::sqrt(impl_->tree.squared_distance(Plain::Point_3(p.x(), p.y(), p.z())));
}

}  // namespace proveout::reference
