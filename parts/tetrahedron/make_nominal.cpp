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

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "../exact_nominal.h"

namespace {

using namespace exact_nominal;  // NOLINT

constexpr double kRadius = 4.0;  // of the tool
constexpr double kOffset = 1.0;  // D1
constexpr double kDepth = -5.0, kCircleDepth = -2.5, kHoleDepth = -50.0, kTop = 10.0;
constexpr double kTilt = 70.529;  // as programmed
constexpr int kSmallFacets = 264, kLargeFacets = 480;

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
    groove.join(toPolygon(alongLine(contour[i - 1], contour[i], onGrid(kRadius), kSmallFacets)));
  const std::int64_t way = onGrid(28.867 + d), r = onGrid(kRadius);
  const Point centre = at(-57.734, 0);
  Area round(toPolygon(circle(centre, way + r, kLargeFacets)));  // N90
  round.difference(toPolygon(circle(centre, way - r, kLargeFacets)));
  round.join(toPolygon(alongLine(at(20, 0), centre + Point{way, 0}, r, kSmallFacets)));  // N80
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

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : "";
  Mesh part = tetrahedron();
  const FloatMesh blank = toFloats(part);
  check("blank", blank);
  writeStl(blank, folder + "blank.stl", "tetrahedron");
  const std::vector<Mesh> taken = takenByO1000();
  for (const double turn_deg : {0.0, 120.0, 240.0}) {  // F180, F300, F60
    for (const Mesh& solid : taken) part = without(part, onFace(solid, turn_deg));
    std::printf("after the face at %g degrees: %.4f mm3\n", turn_deg, CGAL::to_double(pmp::volume(part)));
  }
  const FloatMesh nominal = toFloats(part);
  check("nominal", nominal);
  writeStl(nominal, folder + "nominal.stl", "tetrahedron");
}
