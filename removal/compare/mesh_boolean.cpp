#include "removal/compare/mesh_boolean.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <exception>
#include <stdexcept>

namespace proveout::boolean_detail {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

/// A mesh that can be walked so many steps. CGAL's union (5.5.1) goes round a vertex for ever for some pairs
/// of closed bodies, neither of which runs through itself: tests/unit/compare/bodies_test.cpp has one.
class BoundedMesh : public SurfaceMesh {
 public:
  /// To be called when the triangles are there, or those that it will be made of.
  void allowFor(std::size_t triangles) { steps_left_ = kLeast + kPerTriangle * triangles; }
  /// Throws where they are used up.
  void step() const {
    if (steps_left_-- == 0) throw std::runtime_error("a walk on a mesh that does not end");
  }

 private:
  /// Beyond what a union needs that ends: round a vertex of n triangles it goes up to n times.
  static constexpr std::size_t kLeast = 1'000'000, kPerTriangle = 10'000;
  mutable std::size_t steps_left_ = kLeast;
};

}  // namespace proveout::boolean_detail

#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME proveout::boolean_detail::BoundedMesh
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME proveout::boolean_detail::SurfaceMesh
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>

namespace proveout {

namespace boolean_detail {

// What every walk of CGAL's calls, found by the kind of the mesh.
SurfaceMesh::Halfedge_index next(SurfaceMesh::Halfedge_index h, const BoundedMesh& mesh) {
  mesh.step();
  return mesh.next(h);
}

SurfaceMesh::Halfedge_index prev(SurfaceMesh::Halfedge_index h, const BoundedMesh& mesh) {
  mesh.step();
  return mesh.prev(h);
}

}  // namespace boolean_detail

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using boolean_detail::Point;
using Mesh = boolean_detail::BoundedMesh;

/// Without the triangles that CGAL has no place for: a third one along an edge.
Mesh toCgal(const TriMesh& mesh) {
  Mesh out;
  for (const auto& p : mesh.positions) out.add_vertex(Point(p.x(), p.y(), p.z()));
  for (const auto& t : mesh.triangles)
    out.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return out;
}

TriMesh fromCgal(Mesh& mesh) {
  mesh.collect_garbage();
  TriMesh out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.positions.emplace_back(static_cast<float>(CGAL::to_double(p.x())),
                               static_cast<float>(CGAL::to_double(p.y())),
                               static_cast<float>(CGAL::to_double(p.z())));
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t corner = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) t[corner++] = v;
    out.triangles.push_back(t);
  }
  return out;
}

TriMesh properTriangles(const TriMesh& mesh) {
  TriMesh out;
  out.positions = mesh.positions;
  for (const auto& t : mesh.triangles) {
    const auto point = [&](std::uint32_t v) {
      const auto& p = mesh.positions[v];
      return Point(p.x(), p.y(), p.z());
    };
    if (!CGAL::collinear(point(t[0]), point(t[1]), point(t[2]))) out.triangles.push_back(t);
  }
  return out;
}

bool computed(Mesh& one, Mesh& other, Mesh& result, BooleanKind kind) {
  const auto strict = CGAL::parameters::throw_on_self_intersection(true);
  switch (kind) {
    case BooleanKind::kUnion:
      return pmp::corefine_and_compute_union(one, other, result, strict);
    case BooleanKind::kIntersection:
      return pmp::corefine_and_compute_intersection(one, other, result, strict);
    case BooleanKind::kDifference:
      return pmp::corefine_and_compute_difference(one, other, result, strict);
  }
  return false;
}

}  // namespace

std::optional<TriMesh> booleanOf(const TriMesh& a, const TriMesh& b, BooleanKind kind) {
  try {
    Mesh one = toCgal(a), other = toCgal(b), result;
    if (one.number_of_faces() != a.triangles.size() || other.number_of_faces() != b.triangles.size())
      return std::nullopt;  // voids that touch along an edge
    for (Mesh* mesh : {&one, &other, &result}) mesh->allowFor(a.triangles.size() + b.triangles.size());
    if (!computed(one, other, result, kind) || !CGAL::is_triangle_mesh(result)) return std::nullopt;
    return fromCgal(result);
  } catch (const std::exception&) {
    return std::nullopt;  // one of them runs through itself, or the walk does not end
  }
}

bool surfacesMeet(const TriMesh& a, const TriMesh& b) {
  const boolean_detail::SurfaceMesh one = toCgal(properTriangles(a)), other = toCgal(properTriangles(b));
  return pmp::do_intersect(one, other);
}

}  // namespace proveout
