// Random jobs of the wire EDM control: closed contours, cut once or twice, upright or with a constant taper.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/soak/soak_case.h"

namespace proveout::soak {
namespace {

/// Micrometres: what a program can say, and sums of it without rounding.
struct Point {
  long x = 0, y = 0;
};
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
double lengthOf(const Point& p) { return std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)); }
Point polar(double radius_mm, double angle) {
  return {std::lround(1000 * radius_mm * std::cos(angle)), std::lround(1000 * radius_mm * std::sin(angle))};
}
Point between(const Point& a, const Point& b, double share) {
  return {std::lround(a.x + share * static_cast<double>(b.x - a.x)),
          std::lround(a.y + share * static_cast<double>(b.y - a.y))};
}

struct Edge {
  Point to, center;  ///< the center of arcs
  int motion = 1;    ///< G01 to G03
  double round = 0;  ///< radius of the corner behind it, mm
};

/// A closed contour from a point within its first edge, which is straight.
struct Contour {
  Point start;
  std::vector<Edge> edges;
};

/// As seen from its middle each point is at an angle of its own. Two of three edges are straight.
Contour randomContour(Random& random, const Point& middle, double size, bool reversed, double kerf) {
  const int corners = random.whole(3, 9);
  std::vector<Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5 * random.unit()) / corners;
    points.push_back(middle + polar(size * random.number(0.5, 1.0), angle));
  }
  if (reversed) std::reverse(points.begin(), points.end());
  Contour out;
  out.start = between(points[0], points[1], random.number(0.3, 0.7));
  Point at = points[0];
  for (int k = 1; k <= corners; ++k) {
    Edge edge;
    edge.to = points[static_cast<std::size_t>(k % corners)];
    const Point chord = edge.to - at;
    if (k > 1 && random.chance(0.33)) {
      const double bulge = random.number(0.5, 2.5) * (random.chance(0.5) ? 1 : -1);
      edge.motion = bulge > 0 ? 3 : 2;
      edge.center = between(at, edge.to, 0.5) + Point{std::lround(-bulge * static_cast<double>(chord.y)),
                                                      std::lround(bulge * static_cast<double>(chord.x))};
    }
    if (random.chance(0.4)) edge.round = std::max(1.2 * kerf, 1e-4 * lengthOf(chord) * random.number(0.5, 2));
    at = edge.to;
    out.edges.push_back(edge);
  }
  out.edges.push_back({out.start, {}, 1, 0});
  return out;
}

/// How the numbers of a job are written, and what they cut.
struct Style {
  bool points = true;  ///< millimetres with a point, else least increments
  bool incremental = false;
  double kerf = 0.0;       ///< half its width, mm
  double taper_deg = 0.0;  ///< 0: the wire stands upright
};

class ProgramWriter {
 public:
  ProgramWriter(Random& random, const Style& style) : random_(random), style_(style) {}

  void begin(const Point& at) {
    out_.add(random_.chance(0.3) ? "(RANDOM WAYS OF A WIRE);" : ";");
    out_.add("T84 T86;");
    out_.add(fmt::format("C{:03};", random_.whole(1, 100)));
    out_.add("G90 G92 " + words(at) + ";");
    at_ = at;
    if (style_.incremental) out_.add("G91;");
  }
  /// Round a contour from a point beside it and back there, once or twice; `left`: the wire is left of it.
  void contour(const Contour& contour, bool left) {
    const Point beside = at_;
    const int passes = random_.chance(0.35) ? 2 : 1;
    if (random_.chance(0.3)) out_.add(random_.chance(0.5) ? "G29;" : "G28;");
    const bool spikes = style_.taper_deg == 0.0 && random_.chance(0.15);
    for (int pass = 1; pass <= passes; ++pass) {
      const double stays = pass < passes ? random_.number(0.01, 0.1) : 0.0;
      out_.add(fmt::format("H{:03}={};", pass, number(std::lround(1000 * (style_.kerf + stays)))));
      out_.add(
          fmt::format("{} H{:03} {}G01 {};", left ? "G41" : "G42", pass, taperOn(), words(contour.start)));
      at_ = contour.start;
      if (spikes) out_.add(fmt::format("G37X{};", random_.whole(10, 80)));
      for (const Edge& edge : contour.edges) add(edge);
      if (spikes) out_.add("G36;");
      out_.add(fmt::format("G40 {}G01 {};", style_.taper_deg > 0.0 ? "G50 A0 " : "", words(beside)));
      at_ = beside;
      out_.stops.push_back(out_.lines);
    }
  }
  void threadAt(const Point& at) {
    out_.add("M50;");
    out_.add("G00 " + words(at) + ";");
    out_.add("M60;");
    at_ = at;
  }
  Program end() {
    out_.add("T85 T87;");
    out_.add("M02;");
    return std::move(out_);
  }

 private:
  std::string number(long um) const {
    return style_.points ? fmt::format("{:.3f}", 1e-3 * static_cast<double>(um)) : fmt::format("{}", um);
  }
  std::string words(const Point& to) const {
    const Point said = style_.incremental ? to - at_ : to;
    return fmt::format("X{} Y{}", number(said.x), number(said.y));
  }
  std::string taperOn() const {
    return style_.taper_deg == 0.0 ? ""
                                   : fmt::format("{} A{:.3f} ", lean_left_ ? "G51" : "G52", style_.taper_deg);
  }
  void add(const Edge& edge) {
    std::string line = fmt::format("G{:02} {}", edge.motion, words(edge.to));
    if (edge.motion != 1) {
      const Point arm = edge.center - at_;
      line += fmt::format(" I{} J{}", number(arm.x), number(arm.y));
    }
    if (edge.round > 0) line += fmt::format(" R{:.3f}", edge.round);
    out_.add(line + ";");
    at_ = edge.to;
  }

  Random& random_;
  Style style_;
  Point at_;
  bool lean_left_ = random_.chance(0.5);
  Program out_;
};

/// An upright blank about the origin, from `z` on.
struct Plate {
  std::string toml;
  double half_x = 0.0, half_y = 0.0;
};

Plate randomPlate(Random& random, double z, double thickness) {
  Plate plate;
  if (random.chance(0.6)) {
    plate.half_x = random.number(6, 60);
    plate.half_y = random.number(6, 60);
    plate.toml = fmt::format(
        "[stock]\nshape = \"box\"\nmin = [{0:.4f}, {1:.4f}, {2:.4f}]\nmax = [{3:.4f}, {4:.4f}, {5:.4f}]\n",
        -plate.half_x, -plate.half_y, z, plate.half_x, plate.half_y, z + thickness);
    return plate;
  }
  const double radius = random.number(6, 50);
  const bool tube = random.chance(0.3);
  plate.half_x = plate.half_y = radius;
  plate.toml =
      fmt::format("[stock]\nshape = \"{}\"\nbase = [0, 0, {:.4f}]\nlength = {:.4f}\nradius = {:.4f}\n",
                  tube ? "tube" : "cylinder", z, thickness, radius);
  if (tube) plate.toml += fmt::format("inner_radius = {:.4f}\n", radius * random.number(0.05, 0.7));
  return plate;
}

Program randomProgram(Random& random, const Plate& plate, const Style& style) {
  const int columns = random.whole(1, 3), rows = random.whole(1, 2);
  const double cell_x = 2 * plate.half_x / columns, cell_y = 2 * plate.half_y / rows;
  ProgramWriter writer(random, style);
  bool begun = false;
  for (int k = 0; k < columns * rows; ++k) {
    if (begun && random.chance(0.4)) continue;
    // Now and then contours pass over the border of the plate, and over each other.
    const double size = 0.5 * std::min(cell_x, cell_y) * random.number(0.4, random.chance(0.15) ? 1.6 : 0.9);
    const Point middle{std::lround(1000 * (cell_x * (k % columns + 0.5) - plate.half_x)),
                       std::lround(1000 * (cell_y * (k / columns + 0.5) - plate.half_y))};
    const bool reversed = random.chance(0.5), inside = random.chance(0.6);
    const Contour contour = randomContour(random, middle, size, reversed, style.kerf);
    // The wire comes from the middle of a hole, or from outside of a punch.
    const Point out = contour.start - middle;
    const double beyond = 1 + 1000 * (3 * style.kerf + random.number(0.5, 5)) / lengthOf(out);
    const Point beside = inside ? middle
                                : middle + Point{std::lround(beyond * static_cast<double>(out.x)),
                                                 std::lround(beyond * static_cast<double>(out.y))};
    if (begun) writer.threadAt(beside);
    if (!begun) writer.begin(beside);
    begun = true;
    writer.contour(contour, inside != reversed);
  }
  return writer.end();
}

std::string idleProgram(const Plate& plate) {
  const double far = plate.half_x + 5;
  return fmt::format("T84 T86;\nC001;\nG90 G92 X{0:.3f} Y0;\nG01 Y{1:.3f};\nG00 X{2:.3f};\nM02;\n", far,
                     plate.half_y, far + 5);
}

}  // namespace

void makeWire(Random& random, SoakCase& out) {
  const double diameter = random.number(0.05, 0.35), gap = random.number(0.0, 0.03);
  const double z = random.chance(0.5) ? 0.0 : random.number(-20, 20), thickness = random.number(0.5, 60);
  Style style;
  style.points = random.chance(0.7);
  style.incremental = random.chance(0.3);
  style.kerf = std::round(1000 * (diameter / 2 + gap)) / 1000;
  if (out.kind == Kind::kTaperedWire) style.taper_deg = random.number(0.1, 5);
  const Plate plate = randomPlate(random, z, thickness);
  const Program program = randomProgram(random, plate, style);
  out.files["part.nc"] = program.text;
  out.files["idle.nc"] = idleProgram(plate);
  out.stops = program.stops;
  std::string rest =
      fmt::format("[control]\nname = \"wedm\"\n[control.wedm]\nZB = {:.4f}\nT = {:.4f}\n", z, thickness);
  rest += plate.toml;
  rest += fmt::format("[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = {:.5f}\nspark_gap = {:.5f}\n",
                      diameter, gap);
  if (random.chance(0.5))
    rest += fmt::format("[simulation]\nprofile_resolution = {:g}\n", random.chance(0.5) ? 0.02 : 0.001);
  const std::string head = "schema = \"proveout.job/1\"\n";
  out.files["job.toml"] = head + "program = \"part.nc\"\n" + rest;
  out.files["idle.toml"] = head + "program = \"idle.nc\"\n" + rest;
}

}  // namespace proveout::soak
