#include "tests/support/booleans.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

namespace proveout {
namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

Mesh toCgal(const TriMesh& mesh) {
  Mesh out;
  for (const auto& p : mesh.positions) out.add_vertex(Mesh::Point(p.x(), p.y(), p.z()));
  for (const auto& t : mesh.triangles)
    out.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  if (out.number_of_faces() != mesh.triangles.size()) throw std::runtime_error("not a 2-manifold");
  return out;
}

}  // namespace

TriMesh booleanOf(const TriMesh& a, const TriMesh& b, BooleanKind kind) {
  Mesh one = toCgal(a), other = toCgal(b), result;
  const bool done = kind == BooleanKind::kUnion ? pmp::corefine_and_compute_union(one, other, result)
                    : kind == BooleanKind::kIntersection
                        ? pmp::corefine_and_compute_intersection(one, other, result)
                        : pmp::corefine_and_compute_difference(one, other, result);
  if (!done) throw std::runtime_error("the boolean is no 2-manifold");
  pmp::triangulate_faces(result);
  result.collect_garbage();
  TriMesh out;
  for (const auto v : result.vertices()) {
    const auto& p = result.point(v);
    out.positions.emplace_back(static_cast<float>(CGAL::to_double(p.x())),
                               static_cast<float>(CGAL::to_double(p.y())),
                               static_cast<float>(CGAL::to_double(p.z())));
  }
  for (const auto f : result.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t corner = 0;
    for (const auto v : CGAL::vertices_around_face(result.halfedge(f), result)) t[corner++] = v;
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace proveout
