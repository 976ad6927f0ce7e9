// Builds blank.stl and nominal.stl of the impeller from its drawing, with exact booleans of CGAL. The
// simulator has no part in it. The numbers are those of ../make_five_axis.py, which writes the programs.
//
//   g++ -std=c++20 -O2 make_nominal.cpp -lgmp -lmpfr -o make_nominal && ./make_nominal FOLDER
//
// Both sides of a blade are cones about one upright line, the middle of the blade's arc. A ball-end cutter
// whose axis lies in a plane with that line touches them only in this plane: turning about the line, what
// each of its points comes to is fastest across the plane, so that the normal of the touch lies in it (for
// the cylinder and for the ball). So the cutter sweeps its own section, turned about the line, and itself at
// both ends.
//
// Facets: 5 degrees of the cutters (chords 0.003 mm), 1.5 of the arcs (0.002 mm), 1 of the blank (0.001 mm).

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "../exact_nominal.h"

namespace {

using namespace exact_nominal;  // NOLINT

constexpr int kBlades = 5;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMiddle = 24.0, kArc = 20.0;  // from the axis to the middle of a blade's arc; its radius
constexpr double kAside = 4.2;                 // from there to the way of the ball, on both sides
constexpr double kLean = 12.0 * kDegree;
constexpr double kRadius = 3.0;               // of both cutters
constexpr double kFloor = 8.0, kBall = 11.0;  // heights of the floor, and of the middle of the ball
constexpr double kIn = 10.5, kOut = 30.0;     // from the axis to both ends of the ball's ways
constexpr double kFlatIn = 14.5, kFlatOut = 29.0;
constexpr double kReach = 14.0, kAbove = 24.0;

struct Place {
  double x, y;
};

/// Where the circle about the middle of blade `k` is `away` from the axis; the angle about that middle.
double turnAt(int k, double radius, double away) {
  const double cosine = (kMiddle * kMiddle + radius * radius - away * away) / (2 * kMiddle * radius);
  return std::numbers::pi - std::acos(cosine) + 72.0 * kDegree * k;
}
Place about(int k, double radius, double turn) {
  const double middle = 72.0 * kDegree * k;
  return {kMiddle * std::cos(middle) + radius * std::cos(turn),
          kMiddle * std::sin(middle) + radius * std::sin(turn)};
}
Place wayAt(int k, double radius, double away) { return about(k, radius, turnAt(k, radius, away)); }

double onGridMm(double mm) { return static_cast<double>(onGrid(mm)) / kGrid; }

void orient(Mesh& mesh) {
  if (!CGAL::is_closed(mesh) || pmp::does_self_intersect(mesh)) fail("a swept solid is no solid");
  if (!pmp::is_outward_oriented(mesh)) pmp::reverse_face_orientations(mesh);
}

/// What the ball-end cutter sweeps beside blade `k`.
Mesh besideBlade(int k, double radius) {
  const double from = turnAt(k, radius, kOut), to = turnAt(k, radius, kIn);
  const int steps = static_cast<int>(std::ceil(std::abs(to - from) / (1.5 * kDegree)));
  constexpr int kHalf = 18;  // facets of a quarter of the section
  struct Along {
    double across, up;  // of the cutter's axis, from the middle of the ball
  };
  std::vector<Along> half = {{kRadius, kReach}};  // from the top of the cutter down to its tip
  for (int i = 0; i <= kHalf; ++i) {
    const double a = 90.0 * kDegree * i / kHalf;
    half.push_back({i == kHalf ? 0.0 : kRadius * std::cos(a), -kRadius * std::sin(a)});
  }
  const int tip = static_cast<int>(half.size()) - 1, across = 2 * tip;  // of a section: indices to `across`
  Mesh out;
  /// A point at a turn about the middle of the blade; `round` about the cutter's axis, `side` along the way.
  const auto add = [&](double turn, const Along& p, double round, double side) {
    const double b = p.across * std::cos(round), e = p.across * std::sin(round) * side;
    const double away = radius - p.up * std::sin(kLean) + b * std::cos(kLean),
                 z = kBall + p.up * std::cos(kLean) + b * std::sin(kLean);
    const Place at = about(k, away, turn);
    return out.add_vertex(Exact::Point_3(onGridMm(at.x - e * std::sin(turn)),
                                         onGridMm(at.y + e * std::cos(turn)), onGridMm(z)));
  };
  using Row = std::vector<Mesh::Vertex_index>;
  const auto face = [&](auto a, auto b, auto c) {
    if (out.add_face(a, b, c) == Mesh::null_face()) fail("a facet that does not fit");
  };
  const auto join = [&](const Row& a, const Row& b) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      if (a[i] != b[i]) face(a[i], a[i + 1], b[i]);
      if (a[i + 1] != b[i + 1]) face(b[i], a[i + 1], b[i + 1]);
    }
  };
  std::vector<Row> sections;
  for (int j = 0; j <= steps; ++j) {
    const double turn = from + (to - from) * j / steps;
    Row row;
    for (int i = 0; i <= across; ++i)
      row.push_back(i <= tip ? add(turn, half[static_cast<std::size_t>(i)], 0.0, 0.0)
                             : add(turn, half[static_cast<std::size_t>(across - i)], std::numbers::pi, 0.0));
    sections.push_back(row);
  }
  for (int j = 0; j < steps; ++j) {
    Row a = sections[static_cast<std::size_t>(j)], b = sections[static_cast<std::size_t>(j) + 1];
    a.push_back(a.front()), b.push_back(b.front());
    join(a, b);
  }
  for (const bool start : {true, false}) {  // half of the cutter, from one side of the section to the other
    const Row& section = start ? sections.front() : sections.back();
    const double turn = start ? from : to, side = (to > from) == start ? -1.0 : 1.0;
    Row last(section.begin(), section.begin() + tip + 1);
    const Row first = last;
    Row tops = {section.front()};
    for (int i = 1; i <= 2 * kHalf; ++i) {
      Row row;
      for (int n = 0; n <= tip; ++n) {
        const auto place = static_cast<std::size_t>(n);
        row.push_back(n == tip         ? section[place]
                      : i == 2 * kHalf ? section[static_cast<std::size_t>(across - n)]
                                       : add(turn, half[place], std::numbers::pi * i / (2 * kHalf), side));
      }
      start ? join(row, last) : join(last, row);
      tops.push_back(row.front());
      last = row;
    }
    for (std::size_t i = 1; i + 1 < tops.size(); ++i)
      start ? face(tops[0], tops[i + 1], tops[i]) : face(tops[0], tops[i], tops[i + 1]);
  }
  orient(out);
  return out;
}

Point pointOf(Place p) { return at(p.x, p.y); }
Loop disc(Place p) { return circle(pointOf(p), onGrid(kRadius), 72); }

/// What the end mill sweeps of an arc about the middle of blade `k`.
void joinArc(Area& area, int k, double radius) {
  const double from = turnAt(k, radius, kFlatOut), to = turnAt(k, radius, kFlatIn);
  const int steps = static_cast<int>(std::ceil(std::abs(to - from) / (1.5 * kDegree)));
  Loop loop;
  for (int j = 0; j <= steps; ++j)
    loop.push_back(pointOf(about(k, radius + kRadius, from + (to - from) * j / steps)));
  for (int j = steps; j >= 0; --j)
    loop.push_back(pointOf(about(k, radius - kRadius, from + (to - from) * j / steps)));
  Polygon band = toPolygon(loop);
  if (band.is_clockwise_oriented()) band.reverse_orientation();
  area.join(band);
  area.join(toPolygon(disc(about(k, radius, from))));
  area.join(toPolygon(disc(about(k, radius, to))));
}

/// What the end mill takes between blade `k` and the one before it.
Mesh channel(int k) {
  const double out = kArc + kAside, in = kArc - kAside;
  /// A share of the way from the ball's way at the blade before to that at this one, both `away` from the
  /// axis.
  const auto within = [&](double share, double away) {
    const Place a = wayAt(k - 1, out, away), b = wayAt(k, in, away);
    return Place{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  };
  const std::vector<Place> line = {wayAt(k - 1, out + kRadius, kFlatIn),
                                   within(0.5, 12.3),
                                   within(0.4, 18.0),
                                   within(0.33, kFlatOut),
                                   within(0.67, kFlatOut),
                                   within(0.6, 18.0),
                                   wayAt(k, in - kRadius, kFlatIn)};
  Area area;
  joinArc(area, k - 1, out + kRadius);
  for (std::size_t i = 1; i < line.size(); ++i)
    area.join(toPolygon(alongLine(pointOf(line[i - 1]), pointOf(line[i]), onGrid(kRadius), 72)));
  joinArc(area, k, in - kRadius);
  return extrude(area, kFloor, kAbove);
}

/// Turned: a disc with a cone on it.
Mesh blank() {
  const std::vector<Place> profile = {{24.0, 0.0}, {24.0, 13.0}, {9.0, 20.0}};
  constexpr int kSides = 360;
  Mesh out;
  std::vector<std::vector<Mesh::Vertex_index>> rings;
  for (const Place& p : profile) {
    rings.emplace_back();
    for (int i = 0; i < kSides; ++i)
      rings.back().push_back(out.add_vertex(
          Exact::Point_3(onGridMm(p.x * std::cos(i * kDegree)), onGridMm(p.x * std::sin(i * kDegree)), p.y)));
  }
  const auto low = out.add_vertex(Exact::Point_3(0, 0, profile.front().y)),
             high = out.add_vertex(Exact::Point_3(0, 0, profile.back().y));
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t j = (i + 1) % kSides;
    out.add_face(low, rings.front()[j], rings.front()[i]);
    out.add_face(high, rings.back()[i], rings.back()[j]);
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
      out.add_face(rings[k][i], rings[k][j], rings[k + 1][j]);
      out.add_face(rings[k][i], rings[k + 1][j], rings[k + 1][i]);
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : "";
  Mesh part = blank();
  const FloatMesh raw = toFloats(part);
  check("blank", raw);
  writeStl(raw, folder + "blank.stl", "impeller");
  for (int k = 0; k < kBlades; ++k) {
    part = without(part, channel(k));
    part = without(part, besideBlade(k, kArc + kAside));
    part = without(part, besideBlade(k, kArc - kAside));
    std::printf("after blade %d: %.4f mm3\n", k + 1, CGAL::to_double(pmp::volume(part)));
  }
  const FloatMesh nominal = toFloats(part);
  check("nominal", nominal);
  writeStl(nominal, folder + "nominal.stl", "impeller");
}
