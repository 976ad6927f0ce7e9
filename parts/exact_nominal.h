// Solids of polygons and discs, exact booleans of CGAL, and meshes of single precision: what the makers of
// nominal parts share that no closed form gives. The simulator has no part in it.
//
// Coordinates of polygons lie on a grid of 2^-20 mm (1 nm), so that most are doubles without any rounding:
// planes stay planes, tangents meet, and exact booleans are quick.
#pragma once

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace exact_nominal {

namespace pmp = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
using Rough = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Exact>;
using Region = CGAL::Polygon_with_holes_2<Exact>;
using Area = CGAL::Polygon_set_2<Exact>;
using FloatMesh = CGAL::Surface_mesh<Rough::Point_3>;

constexpr double kGrid = 1 << 20;  // steps in a mm
constexpr double kSame = 2e-5;     // mm between corners that are one
constexpr double kNear = 1e-4;     // mm that facets may move when corners are left out

struct Point {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const Point&) const = default;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline std::int64_t onGrid(double mm) { return std::llround(mm * kGrid); }
inline Point at(double x, double y) { return {onGrid(x), onGrid(y)}; }
using Loop = std::vector<Point>;

inline Loop circle(Point centre, std::int64_t radius, int facets) {
  Loop out;
  for (int i = 0; i < facets; ++i) {
    const double a = 2 * std::numbers::pi * i / facets, r = static_cast<double>(radius);
    out.push_back(centre + Point{std::llround(r * std::cos(a)), std::llround(r * std::sin(a))});
  }
  return out;
}

inline std::int64_t turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Counterclockwise, without points on its sides.
inline Loop hull(Loop points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Loop out;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = out.size();
    for (const Point& p : points) {
      while (out.size() >= first + 2 && turn(out[out.size() - 2], out.back(), p) <= 0) out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

inline Exact::Point_3 point(Point p, double z) {
  return {static_cast<double>(p.x) / kGrid, static_cast<double>(p.y) / kGrid, z};
}

inline Mesh prism(const Loop& loop, double bottom, double top) {
  Mesh out;
  std::vector<Mesh::Vertex_index> low, high;
  for (const Point& p : loop) low.push_back(out.add_vertex(point(p, bottom)));
  for (const Point& p : loop) high.push_back(out.add_vertex(point(p, top)));
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    out.add_face(low[i], low[j], high[j], high[i]);
  }
  out.add_face(high);
  std::reverse(low.begin(), low.end());
  out.add_face(low);
  pmp::triangulate_faces(out);
  return out;
}

/// What a disc covers on its way.
inline Loop alongLine(Point from, Point to, std::int64_t radius, int facets) {
  Loop points = circle(from, radius, facets);
  const Loop end = circle(to, radius, facets);
  points.insert(points.end(), end.begin(), end.end());
  return hull(std::move(points));
}

[[noreturn]] inline void fail(const char* what) {
  std::fprintf(stderr, "make_nominal: %s\n", what);
  std::exit(1);
}

inline Polygon toPolygon(const Loop& loop) {
  Polygon out;
  for (const Point& p : loop)
    out.push_back({static_cast<double>(p.x) / kGrid, static_cast<double>(p.y) / kGrid});
  return out;
}

/// Onto the grid; without points that lie on a side.
inline Loop toLoop(const Polygon& polygon) {
  Loop out;
  for (const auto& p : polygon) out.push_back(at(CGAL::to_double(p.x()), CGAL::to_double(p.y())));
  for (std::size_t i = 0; i < out.size();) {
    const std::size_t n = out.size();
    if (turn(out[(i + n - 1) % n], out[i], out[(i + 1) % n]) == 0) {
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 1 ? i - 2 : 0;
    } else {
      ++i;
    }
  }
  return out;
}

inline Mesh without(const Mesh& mesh, const Mesh& solid) {
  Mesh from = mesh, tool = solid, rest;
  if (!pmp::corefine_and_compute_difference(from, tool, rest)) fail("no difference");
  rest.collect_garbage();
  return rest;
}

/// From `bottom` up to `top`: one region with its holes, simple once on the grid.
inline Mesh extrude(const Area& area, double bottom, double top) {
  if (area.number_of_polygons_with_holes() != 1) fail("ways that do not hang together");
  std::vector<Region> regions;
  area.polygons_with_holes(std::back_inserter(regions));
  const Region& region = regions.front();
  const Loop outline = toLoop(region.outer_boundary());
  if (!toPolygon(outline).is_simple()) fail("the grid is too coarse");
  Mesh out = prism(outline, bottom, top);
  for (const Polygon& inner : region.holes()) {
    Loop hole = toLoop(inner);
    std::reverse(hole.begin(), hole.end());
    if (!toPolygon(hole).is_simple()) fail("the grid is too coarse");
    out = without(out, prism(hole, bottom - 1, top + 1));
  }
  return out;
}

inline Rough::Point_3 rounded(const Exact::Point_3& p) {
  const auto f = [](const auto& v) { return static_cast<float>(CGAL::to_double(v)) + 0.0F; };
  return {f(p.x()), f(p.y()), f(p.z())};
}

struct Corners {
  std::array<Rough::Point_3, 3> p;
  Rough::Vector_3 normal() const {
    const Rough::Vector_3 n = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    const double size = std::sqrt(n.squared_length());
    return size > 0 ? n / size : n;
  }
  double height() const {
    double longest = 0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, CGAL::squared_distance(p[i], p[(i + 1) % 3]));
    return longest > 0 ? std::sqrt(4 * CGAL::squared_area(p[0], p[1], p[2]) / longest) : 0.0;
  }
};

inline Corners cornersOf(const FloatMesh& mesh, FloatMesh::Face_index f) {
  Corners out;
  auto h = mesh.halfedge(f);
  for (auto& corner : out.p) corner = mesh.point(mesh.target(h)), h = mesh.next(h);
  return out;
}

/// Whether the start of `h` may go to its end: the facets around stay where they are, and none turns over.
inline bool mayGo(const FloatMesh& mesh, FloatMesh::Halfedge_index h) {
  const auto from = mesh.source(h), to = mesh.target(h);
  const Rough::Point_3 end = mesh.point(to);
  for (const auto around : mesh.halfedges_around_target(mesh.opposite(h))) {
    const auto f = mesh.face(around);
    const Corners old = cornersOf(mesh, f);
    const bool has_plane = old.height() > kNear;
    if (has_plane && std::abs((end - old.p[0]) * old.normal()) > kNear) return false;
    const auto a = mesh.source(around), b = mesh.target(mesh.next(around));
    if (a == to || b == to) continue;
    const Corners moved{{end, mesh.point(b), mesh.point(a)}};
    const double height = moved.height();
    if (height < std::min(kNear, old.height())) return false;
    if (has_plane && moved.normal() * old.normal() < 0.99) return false;
    if (!has_plane && height > kNear && CGAL::squared_distance(mesh.point(from), end) > kNear * kNear)
      return false;
  }
  return CGAL::Euler::does_satisfy_link_condition(mesh.edge(h), mesh);
}

/// Which corner stands for each: those that lie within `kSame` of each other are one.
inline std::vector<std::size_t> merged(const std::vector<Rough::Point_3>& points) {
  std::vector<std::size_t> order(points.size()), stands(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = stands[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return points[a].x() < points[b].x(); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && points[order[i]].x() - points[order[j]].x() < kSame;) {
      if (CGAL::squared_distance(points[order[i]], points[order[j]]) > kSame * kSame) continue;
      stands[order[i]] = stands[order[j]];
      break;
    }
  }
  return stands;
}

/// In single precision, without the corners that facets share in planes and on straight edges.
inline FloatMesh toFloats(const Mesh& mesh) {
  std::vector<Rough::Point_3> points;
  for (const auto v : mesh.vertices()) points.push_back(rounded(mesh.point(v)));
  const std::vector<std::size_t> stands = merged(points);
  std::map<std::array<std::size_t, 3>, int>
      facets;  // from the smallest corner on; twice is none where they face
  for (const auto f : mesh.faces()) {
    std::array<std::size_t, 3> v;
    auto h = mesh.halfedge(f);
    for (auto& corner : v) corner = stands[static_cast<std::size_t>(mesh.target(h))], h = mesh.next(h);
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    if (const auto back = facets.find({v[0], v[2], v[1]}); back != facets.end()) {
      if (--back->second == 0) facets.erase(back);
    } else {
      ++facets[v];
    }
  }
  FloatMesh out;
  std::map<std::size_t, FloatMesh::Vertex_index> index;
  for (const auto& [v, count] : facets) {
    for (const std::size_t corner : v)
      if (const auto [it, fresh] = index.try_emplace(corner); fresh)
        it->second = out.add_vertex(points[corner]);
    if (count != 1 || out.add_face(index[v[0]], index[v[1]], index[v[2]]) == FloatMesh::null_face())
      fail("no manifold when near corners are one");
  }
  for (bool again = true; again;) {
    again = false;
    std::vector<std::pair<double, FloatMesh::Halfedge_index>> ways;  // short ones first
    for (const auto h : out.halfedges())
      ways.emplace_back(CGAL::squared_distance(out.point(out.source(h)), out.point(out.target(h))), h);
    std::sort(ways.begin(), ways.end());
    for (const auto& [length, h] : ways) {
      if (out.is_removed(h) || !mayGo(out, h)) continue;
      const Rough::Point_3 end = out.point(out.target(h));
      out.point(CGAL::Euler::collapse_edge(out.edge(h), out)) = end;
      again = true;
    }
  }
  out.collect_garbage();
  return out;
}

inline void writeStl(const FloatMesh& mesh, const std::string& name, const char* text) {
  static_assert(std::endian::native == std::endian::little);
  std::ofstream file(name, std::ios::binary);
  std::array<char, 80> head = {};
  std::snprintf(head.data(), head.size(), "%s, mm", text);
  file.write(head.data(), head.size());
  const auto put = [&](const auto& value) {
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(mesh.number_of_faces()));
  for (const auto f : mesh.faces()) {
    const Corners corners = cornersOf(mesh, f);
    const Rough::Vector_3 n = corners.normal();
    for (const double v : {n.x(), n.y(), n.z()}) put(static_cast<float>(v));
    for (const auto& corner : corners.p)
      for (int i = 0; i < 3; ++i) put(static_cast<float>(corner[i]));
    put(std::uint16_t{0});
  }
}

inline void check(const char* name, const FloatMesh& mesh) {
  if (!CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh))
    fail("not closed, or no manifold");
  double shortest = 1e9, lowest = 1e9;
  for (const auto f : mesh.faces()) lowest = std::min(lowest, cornersOf(mesh, f).height());
  for (const auto e : mesh.edges())
    shortest = std::min(shortest, std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                                   mesh.point(mesh.vertex(e, 1)))));
  const long long euler = static_cast<long long>(mesh.number_of_vertices()) -
                          static_cast<long long>(mesh.number_of_edges()) +
                          static_cast<long long>(mesh.number_of_faces());
  std::printf(
      "%s: closed, 2-manifold, %zu facets, V - E + F = %lld, crosses itself: %s, volume %.4f mm3, "
      "shortest edge %.2g, lowest facet %.2g mm\n",
      name, static_cast<std::size_t>(mesh.number_of_faces()), euler,
      pmp::does_self_intersect(mesh) ? "YES" : "no", CGAL::to_double(pmp::volume(mesh)), shortest, lowest);
}

}  // namespace exact_nominal
