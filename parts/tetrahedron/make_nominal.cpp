// Builds blank.stl and nominal.stl of the tetrahedron (manual of the NCT control, 25.5 and 25.12) from the
// printed program, with exact booleans of CGAL. The simulator has no part in it.
//
//   g++ -std=c++20 -O2 make_nominal.cpp -lgmp -lmpfr -o make_nominal && ./make_nominal FOLDER
//
// Path of the tool's centre in the frame of a face, derived by hand from O1000 with G42, D1 = d, rho = -d
// (15.5): n = left normal of a direction t, n(1) and n(2) those of the blocks before and behind a corner P,
// delta = angle from t(1) to t(2), alpha = 180 - delta: an inner corner above 180, an obtuse one from 90, an
// acute one below 90.
//
// - N10   G0 to (20, 0, -5). Clear of the blank: the tetrahedron lies at x <= 0 of the face's frame.
// - N20   start-up at P = (0, 0): t1 = (-1, 0), t2 = (-86.603, 50) / 100.0004, delta -30, alpha 210: inner,
//         one point P + rho n2 = P - d n2, for d = 1 (0.5000, 0.8660). Straight from (20, 0), at Z-5.
// - N30   to P = (-86.603, 50): delta +120, alpha 60: acute, two points P - d n1 + d t1 = (-86.969, 51.366)
//         and P - d n2 - d t2 = (-87.603, 51), joined by a straight piece: each offset line goes on by d.
// - N40   to P = (-86.603, -50): the same corner mirrored, (-87.603, -51) and (-86.969, -51.366).
// - N50   to P = (0, 0), before the G40 of N60: t1 = (86.603, 50) / 100.0004, t2 = (1, 0), delta -30,
//         alpha 210: inner, one point P - d n1 = (0.5000, -0.8660).
// - N60   G40, feed straight to (20, 0). N70 goes up to Z-2.5 there: air.
// - N80   G42 from (20, 0) to P = (-28.867, 0), before the arc N90 (G3 about (-57.734, 0), t2 = (0, 1)):
//         delta -90, alpha 270: inner, P - d n2 = (-27.867, 0). G1 is still modal: a slot along y = 0.
// - N90   full circle. R' = R - q rho = 28.867 + d = 29.867, from (-27.867, 0) to itself.
// - N100  G40 behind the arc: t1 = (0, 1), t2 = (1, 0), delta -90, alpha 270: inner, P - d n1 = the same
//         point. Then G0 straight to (20, 0, 20): the disc rises within the slot of N80 and takes nothing.
// - N110  hole at (-57.736, 0) down to Z-50; R2 and the way back to Z20 are in air or in the hole.
//
// A flat tool of radius r that stands on the face takes what lies above its bottom: discs of radius r along
// these ways, from the depth upwards. What lies above the face is air, so that the prisms may end at z = 10
// or more; the next face is approached in air (ways between the faces are the jobs' matter).
//
// Circles have so many facets that chords are off by less than 1 micrometre: 264 at r = 4 (0.28), 480 at R' +
// r = 33.867 (0.73). Both are multiples of 12, so that walls of the contour (30, 150, 270 degrees) run
// through corners of the discs. Coordinates in the face's frame lie on a grid of 2^-20 mm (1 nm) and the
// numbers of its matrix are multiples of 2^-24 (off by 3e-8), so that turned corners are doubles without any
// rounding: planes stay planes, tangents meet, and exact booleans are quick.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
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

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
using Rough = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Exact>;
using Region = CGAL::Polygon_with_holes_2<Exact>;
using Area = CGAL::Polygon_set_2<Exact>;
using FloatMesh = CGAL::Surface_mesh<Rough::Point_3>;

constexpr double kRadius = 4.0;  // of the tool
constexpr double kOffset = 1.0;  // D1
constexpr double kDepth = -5.0, kCircleDepth = -2.5, kHoleDepth = -50.0, kTop = 10.0;
constexpr double kTilt = 70.529;  // as programmed
constexpr int kSmallFacets = 264, kLargeFacets = 480;
constexpr double kGrid = 1 << 20;  // steps in a mm
constexpr double kSame = 2e-5;     // mm between corners that are one
constexpr double kNear = 1e-4;     // mm that facets may move when corners are left out

struct Point {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const Point&) const = default;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
std::int64_t onGrid(double mm) { return std::llround(mm * kGrid); }
Point at(double x, double y) { return {onGrid(x), onGrid(y)}; }
using Loop = std::vector<Point>;

Loop circle(Point centre, std::int64_t radius, int facets) {
  Loop out;
  for (int i = 0; i < facets; ++i) {
    const double a = 2 * std::numbers::pi * i / facets, r = static_cast<double>(radius);
    out.push_back(centre + Point{std::llround(r * std::cos(a)), std::llround(r * std::sin(a))});
  }
  return out;
}

std::int64_t turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Counterclockwise, without points on its sides.
Loop hull(Loop points) {
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

Exact::Point_3 point(Point p, double z) {
  return {static_cast<double>(p.x) / kGrid, static_cast<double>(p.y) / kGrid, z};
}

Mesh prism(const Loop& loop, double bottom, double top) {
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

Loop alongLine(Point from, Point to) {
  Loop points = circle(from, onGrid(kRadius), kSmallFacets);
  const Loop end = circle(to, onGrid(kRadius), kSmallFacets);
  points.insert(points.end(), end.begin(), end.end());
  return hull(std::move(points));
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "make_nominal: %s\n", what);
  std::exit(1);
}

Polygon toPolygon(const Loop& loop) {
  Polygon out;
  for (const Point& p : loop)
    out.push_back({static_cast<double>(p.x) / kGrid, static_cast<double>(p.y) / kGrid});
  return out;
}

/// Onto the grid; without points that lie on a side.
Loop toLoop(const Polygon& polygon) {
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

Mesh without(const Mesh& mesh, const Mesh& solid) {
  Mesh from = mesh, tool = solid, rest;
  if (!pmp::corefine_and_compute_difference(from, tool, rest)) fail("no difference");
  rest.collect_garbage();
  return rest;
}

/// From `bottom` up to `top`: one region with its holes, simple once on the grid.
Mesh extrude(const Area& area, double bottom, double top) {
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

/// What O1000 takes, in the frame of a face. Tops differ, so that they do not lie in each other.
std::vector<Mesh> takenByO1000() {
  const double length = std::hypot(86.603, 50.0), tx = 86.603 / length, ty = 50.0 / length, d = kOffset;
  const std::vector<Point> contour = {
      at(20, 0),                                             // N10
      at(d * ty, d * tx),                                    // N20
      at(-86.603 + d * ty - d * tx, 50 + d * tx + d * ty),   // N30
      at(-86.603 - d, 50 + d),                               // N30, second point of the corner
      at(-86.603 - d, -50 - d),                              // N40
      at(-86.603 + d * ty - d * tx, -50 - d * tx - d * ty),  // N40, second point
      at(d * ty, -d * tx),                                   // N50
      at(20, 0),                                             // N60
  };
  Area groove;
  for (std::size_t i = 1; i < contour.size(); ++i)
    groove.join(toPolygon(alongLine(contour[i - 1], contour[i])));
  const std::int64_t way = onGrid(28.867 + d), r = onGrid(kRadius);
  const Point centre = at(-57.734, 0);
  Area round(toPolygon(circle(centre, way + r, kLargeFacets)));  // N90
  round.difference(toPolygon(circle(centre, way - r, kLargeFacets)));
  round.join(toPolygon(alongLine(at(20, 0), centre + Point{way, 0})));  // N80
  return {extrude(groove, kDepth, kTop), extrude(round, kCircleDepth, kTop + 1),
          prism(circle(at(-57.736, 0), r, kSmallFacets), kHoleDepth, kTop + 2)};  // N110
}

/// From the frame of a face into the workpiece: M_Z(turn) M_Y(-tilt), which is G68.2 I(turn-90) J(tilt) K90
/// too.
Mesh onFace(const Mesh& mesh, double turn_deg) {
  const auto rad = [](double deg) { return deg * std::numbers::pi / 180.0; };
  const double c = std::cos(rad(kTilt)), s = std::sin(rad(kTilt)), k = std::cos(rad(turn_deg)),
               m = std::sin(rad(turn_deg));
  const auto whole = [](double v) { return std::round(std::ldexp(v, 24)) / (1 << 24); };
  const CGAL::Aff_transformation_3<Exact> to_part(whole(k * c), whole(-m), whole(-k * s), whole(m * c),
                                                  whole(k), whole(-m * s), whole(s), 0.0, whole(c));
  Mesh out = mesh;
  for (const auto v : out.vertices()) {
    const Exact::Point_3 p = to_part.transform(out.point(v));
    const Exact::Point_3 plain(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    out.point(v) = plain == p ? plain : p;
  }
  return out;
}

Mesh tetrahedron() {
  const std::array<std::array<float, 3>, 4> corners = {
      {{0, 0, 0}, {-28.8675F, 50, -81.6497F}, {-28.8675F, -50, -81.6497F}, {57.7350F, 0, -81.6497F}}};
  Mesh out;
  for (const auto& p : corners) out.add_vertex(Exact::Point_3(p[0], p[1], p[2]));
  const auto face = [&](int a, int b, int c) {
    out.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  };
  face(0, 1, 2), face(0, 2, 3), face(0, 3, 1), face(1, 3, 2);
  return out;
}

Rough::Point_3 rounded(const Exact::Point_3& p) {
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

Corners cornersOf(const FloatMesh& mesh, FloatMesh::Face_index f) {
  Corners out;
  auto h = mesh.halfedge(f);
  for (auto& corner : out.p) corner = mesh.point(mesh.target(h)), h = mesh.next(h);
  return out;
}

/// Whether the start of `h` may go to its end: the facets around stay where they are, and none turns over.
bool mayGo(const FloatMesh& mesh, FloatMesh::Halfedge_index h) {
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
std::vector<std::size_t> merged(const std::vector<Rough::Point_3>& points) {
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
FloatMesh toFloats(const Mesh& mesh) {
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

void writeStl(const FloatMesh& mesh, const std::string& name) {
  static_assert(std::endian::native == std::endian::little);
  std::ofstream file(name, std::ios::binary);
  std::array<char, 80> head = {};
  std::snprintf(head.data(), head.size(), "tetrahedron, mm");
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

void check(const char* name, const FloatMesh& mesh) {
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

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : "";
  Mesh part = tetrahedron();
  const FloatMesh blank = toFloats(part);
  check("blank", blank);
  writeStl(blank, folder + "blank.stl");
  const std::vector<Mesh> taken = takenByO1000();
  for (const double turn_deg : {0.0, 120.0, 240.0}) {  // F180, F300, F60
    for (const Mesh& solid : taken) part = without(part, onFace(solid, turn_deg));
    std::printf("after the face at %g degrees: %.4f mm3\n", turn_deg, CGAL::to_double(pmp::volume(part)));
  }
  const FloatMesh nominal = toFloats(part);
  check("nominal", nominal);
  writeStl(nominal, folder + "nominal.stl");
}
