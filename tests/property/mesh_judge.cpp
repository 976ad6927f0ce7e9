#include "tests/property/mesh_judge.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace proveout::test {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

MeshVerdict judgeMesh(const TriMesh& mesh) {
  MeshVerdict verdict;
  std::vector<Kernel::Point_3> points;
  for (const auto& p : mesh.positions) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& t : mesh.triangles) triangles.push_back({t[0], t[1], t[2]});
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles)) return verdict;
  SurfaceMesh surface;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, surface);
  verdict.manifold = CGAL::is_valid_polygon_mesh(surface);
  verdict.closed = CGAL::is_closed(surface);
  using Face = SurfaceMesh::Face_index;
  std::vector<std::pair<Face, Face>> pairs;
  pmp::self_intersections(surface, std::back_inserter(pairs));
  verdict.meetings = pairs.size();
  std::ostringstream places;
  for (std::size_t i = 0; i < std::min<std::size_t>(5, pairs.size()); ++i)
    places << "\n  near " << surface.point(surface.source(surface.halfedge(pairs[i].first)));
  verdict.places = places.str();
  return verdict;
}

}  // namespace proveout::test
