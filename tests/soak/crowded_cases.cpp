// Random milled jobs whose faces meet below the size of a cell: scallops over scallops, cones and small balls
// side by side, cuts that graze, faces that fall together.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "tests/soak/soak_case.h"

namespace proveout::soak {
namespace {

/// Of a blank, in cells.
struct Size {
  double width, depth, height;
};

/// The kinds that randomTool has not.
std::string rareTool(Random& random, int number, double d) {
  std::string text = fmt::format("[[tool]]\nnumber = {}\n", number);
  switch (random.whole(0, 4)) {
    case 0:
      return text +
             fmt::format("type = \"taper\"\ndiameter = {:.4f}\n{}_diameter = {:.4f}\ntaper_angle = {:.1f}\n",
                         d, random.chance(0.5) ? "tip" : "ball", random.number(0.1, 0.7) * d,
                         random.number(3, 40));
    case 1: {
      const double angle = random.number(45, 80), height = random.number(0.1, 0.3) * d;
      const double left = d - 2 * height / std::tan(angle * std::numbers::pi / 180);
      return text + fmt::format(
                        "type = \"dovetail\"\ndiameter = {:.4f}\ndovetail_angle = {:.1f}\nheight = {:.4f}\n"
                        "neck_diameter = {:.4f}\n",
                        d, angle, height, 0.9 * left);
    }
    case 2:
      return text + fmt::format(
                        "type = \"tslot\"\ndiameter = {:.4f}\nthickness = {:.4f}\nneck_diameter = "
                        "{:.4f}\ncorner_radius = {:.4f}\n",
                        d, 0.3 * d, 0.4 * d, random.number(0.02, 0.14) * d);
    case 3:
      return text +
             fmt::format(
                 "type = \"thread-mill\"\ndiameter = {:.4f}\npitch = {:.4f}\nteeth = {}\nthread_angle = "
                 "{:.1f}\n",
                 d, random.number(0.1, 0.3) * d, random.whole(1, 4), random.number(50, 90));
    default: {
      const double r = 0.5 * d, a = random.number(0.0, 0.5) * r, up = random.number(0.2, 0.6) * r;
      const double bend =
          random.chance(0.3) ? 0.0 : (random.chance(0.5) ? 1.0 : -1.0) * random.number(0.8, 2.0) * d;
      return text +
             fmt::format("type = \"form\"\nprofile = [[{:.4f}, 0], [{:.4f}, {:.4f}{}], [{:.4f}, {:.4f}]]\n",
                         a, r, up, bend == 0.0 ? "" : fmt::format(", {:.4f}", bend),
                         random.number(0.5, 1.0) * r, up + random.number(0.2, 1.0) * r);
    }
  }
}

/// Passes of plain jobs; of those with arcs in all planes; of those with all curves.
constexpr int kPlainPasses = 7, kWidePasses = 8, kCurvedPasses = 10;

/// Lengths in cells, from the middle of the blank's top.
class CrowdedWriter {
 public:
  /// `kinds`: of passes that it chooses from.
  CrowdedWriter(Random& random, double grid, const Size& size, int kinds)
      : random_(random),
        grid_(grid),
        width_(size.width),
        depth_(size.depth),
        height_(size.height),
        kinds_(kinds) {}

  std::string tool(int number);
  void passes(int number);
  Program finish() {
    out_.add("M30");
    return std::exchange(out_, {});
  }
  void begin() { out_.add("G21 G90 G17 G40"); }

 private:
  double x() { return random_.number(-0.55, 0.55) * width_; }
  double y() { return random_.number(-0.55, 0.55) * depth_; }
  /// How deep a pass goes; some touch the top only, some fall together.
  double down() {
    switch (random_.whole(0, 3)) {
      case 0:
        return -random_.number(0.01, 0.3);
      case 1:
        return -0.25 * height_ * random_.whole(1, 3);
      default:
        return -random_.number(0.3, 0.7 * height_);
    }
  }
  std::string at(double x, double y, double z) const {
    return fmt::format("X{:.4f} Y{:.4f} Z{:.4f}", grid_ * x, grid_ * y, grid_ * z);
  }
  void start(double x, double y, double z) {
    out_.stops.push_back(out_.lines);
    out_.add(fmt::format("G0 Z{:.4f}", 10.0 * grid_));
    out_.add(fmt::format("G0 X{:.4f} Y{:.4f}", grid_ * x, grid_ * y));
    out_.add(fmt::format("G1 Z{:.4f} F300", grid_ * z));
  }
  void line(double x, double y, double z) { out_.add("G1 " + at(x, y, z)); }
  void scallops();
  void zigzag();
  void holes();
  void steps();
  void circles();
  void chords();
  void bows();
  void spirals();
  void screws();

  Random& random_;
  double grid_, width_, depth_, height_;
  int kinds_;
  double diameter_ = 4.0;  ///< of the tool in hand
  std::array<double, 8> diameters_{};
  Program out_;
};

std::string CrowdedWriter::tool(int number) {
  const double d = random_.chance(0.5) ? random_.number(2.1, 5.0) : random_.number(5.0, 16.0);
  diameters_[static_cast<std::size_t>(number)] = d;
  return kinds_ > kPlainPasses && random_.chance(0.6) ? rareTool(random_, number, grid_ * d)
                                                      : randomTool(random_, number, grid_ * d);
}

/// Parallel passes, level or over a wave, at any angle.
void CrowdedWriter::scallops() {
  const double angle = random_.chance(0.4) ? 0.0 : random_.number(0.0, 3.14);
  const double step = diameter_ * random_.number(0.1, 0.9), level = down();
  const double wave = random_.chance(0.5) ? 0.0 : random_.number(0.1, 2.0),
               length = random_.number(4.0, 30.0), half = 0.4 * std::min(width_, depth_);
  const int count = std::min(14, static_cast<int>(2.0 * half / step));
  for (int i = 0; i <= count; ++i) {
    const double v = -half + i * step;
    const auto point = [&](double u, bool first) {
      const double z = level - wave * (1.0 + std::sin(u / length * 6.28 + 0.1 * v));
      const double px = u * std::cos(angle) - v * std::sin(angle),
                   py = u * std::sin(angle) + v * std::cos(angle);
      first ? start(px, py, z) : line(px, py, z);
    };
    const int pieces = wave > 0.0 ? random_.whole(4, 12) : 1;
    for (int k = 0; k <= pieces; ++k) point(-half + 2.0 * half * k / pieces, k == 0);
  }
}

/// A line that turns at every corner and rises and falls, as engraving does.
void CrowdedWriter::zigzag() {
  const int corners = random_.whole(4, 16);
  const double pitch = 0.8 * width_ / corners, reach = random_.number(1.0, 0.4 * depth_), middle = 0.5 * y();
  const double low = down(), high = random_.chance(0.5) ? low : random_.number(low, 0.2);
  start(-0.4 * width_, middle, low);
  for (int i = 1; i <= corners; ++i)
    line(-0.4 * width_ + i * pitch, middle + (i % 2 == 0 ? -reach : reach), i % 2 == 0 ? low : high);
}

/// Plunges beside each other, some at one depth.
void CrowdedWriter::holes() {
  const int count = random_.whole(3, 25);
  const double level = down(), px = x(), py = y();
  for (int i = 0; i < count; ++i) {
    const double z = random_.chance(0.5) ? level : down();
    const double spread = diameter_ * 0.02 * random_.whole(10, 60);
    start(0.6 * px + spread * (i % 5), 0.6 * py + spread * (i / 5), z);
  }
}

/// Slots whose walls and floors fall together or nearly do.
void CrowdedWriter::steps() {
  const double px = x(), py = y(), level = down();
  const int count = random_.whole(2, 6);
  for (int i = 0; i < count; ++i) {
    const double shift = diameter_ * 0.25 * random_.whole(-4, 4) + (random_.chance(0.5) ? 0.0 : 0.02);
    const double z = level + (random_.chance(0.6) ? 0.0 : random_.number(-0.3, 0.3));
    if (random_.chance(0.5)) {
      start(px + shift, -0.6 * depth_, z);
      line(px + shift, 0.6 * depth_ * random_.unit(), z);
    } else {
      start(-0.6 * width_, py + shift, z);
      line(0.6 * width_ * random_.unit(), py + shift, z);
    }
  }
}

/// Arcs, circles, helices and spirals about nearby centers.
void CrowdedWriter::circles() {
  const int count = random_.whole(1, 5);
  const double px = 0.5 * x(), py = 0.5 * y();
  for (int i = 0; i < count; ++i) {
    const double radius = random_.number(0.3, 0.35 * std::min(width_, depth_)),
                 from = random_.number(0.0, 6.28), to = random_.number(0.0, 6.28);
    const double cx = px + random_.number(-2.0, 2.0), cy = py + random_.number(-2.0, 2.0), z = down();
    const bool full = random_.chance(0.4);
    start(cx + radius * std::cos(from), cy + radius * std::sin(from), z);
    const double a = full ? from : to, end = random_.chance(0.5) ? z : down();
    out_.add(fmt::format("G{} {} I{:.4f} J{:.4f}{}", random_.whole(2, 3),
                         at(cx + radius * std::cos(a), cy + radius * std::sin(a), end),
                         -grid_ * radius * std::cos(from), -grid_ * radius * std::sin(from),
                         end != z && random_.chance(0.5) ? fmt::format(" L{}", random_.whole(2, 6)) : ""));
  }
}

/// Lines from anywhere to anywhere.
void CrowdedWriter::chords() {
  start(x(), y(), down());
  const int count = random_.whole(2, 10);
  for (int i = 0; i < count; ++i) line(x(), y(), random_.chance(0.2) ? random_.number(0.0, 2.0) : down());
}

/// Half circles that hang in the planes of Z, side by side.
void CrowdedWriter::bows() {
  const int count = random_.whole(1, 6);
  const double level = down(), radius = random_.number(1.0, 0.3 * height_), px = 0.5 * x(), py = 0.5 * y();
  const bool along = random_.chance(0.5);
  const double step = diameter_ * random_.number(0.1, 0.7);
  for (int i = 0; i < count; ++i) {
    const double cx = along ? px : px + i * step, cy = along ? py + i * step : py;
    start(along ? cx - radius : cx, along ? cy : cy - radius, level);
    const double ex = along ? cx + radius : cx, ey = along ? cy : cy + radius;
    // From the side that Y, or -X, looks at the arc from, it goes below its ends.
    out_.add(
        fmt::format("{} {} R{:.4f}", along ? "G18 G2" : "G19 G3", at(ex, ey, level), grid_ * radius * 1.001));
    out_.add("G17 G1 F300");
  }
}

/// Flat spirals and conical helices.
void CrowdedWriter::spirals() {
  const int count = random_.whole(1, 3);
  const double px = 0.5 * x(), py = 0.5 * y(), most = 0.35 * std::min(width_, depth_);
  for (int i = 0; i < count; ++i) {
    const double a = random_.number(0.0, 6.28), b = random_.chance(0.5) ? a : random_.number(0.0, 6.28);
    const double from = random_.number(0.3, most), to = random_.number(0.3, most);
    const double cx = px + random_.number(-2.0, 2.0), cy = py + random_.number(-2.0, 2.0), z = down();
    start(cx + from * std::cos(a), cy + from * std::sin(a), z);
    out_.add(fmt::format("G{} {} I{:.4f} J{:.4f} L{}", random_.whole(2, 3),
                         at(cx + to * std::cos(b), cy + to * std::sin(b), random_.chance(0.5) ? z : down()),
                         -grid_ * from * std::cos(a), -grid_ * from * std::sin(a), random_.whole(1, 5)));
  }
}

/// Arcs about X and Y that go along their axis.
void CrowdedWriter::screws() {
  const int count = random_.whole(1, 4);
  for (int i = 0; i < count; ++i) {
    const bool along = random_.chance(0.5);
    const double level = down(), radius = random_.number(1.0, 0.3 * height_), cx = 0.6 * x(), cy = 0.6 * y();
    const double aside = random_.number(-1.0, 1.0) * (along ? depth_ : width_) * 0.3;
    start(along ? cx - radius : cx, along ? cy : cy - radius, level);
    out_.add(fmt::format("{} {} R{:.4f}", along ? "G18 G2" : "G19 G3",
                         at(along ? cx + radius : cx + aside, along ? cy + aside : cy + radius, level),
                         grid_ * radius * 1.001));
    out_.add("G17 G1 F300");
  }
}

void CrowdedWriter::passes(int number) {
  diameter_ = diameters_[static_cast<std::size_t>(number)];
  out_.add(fmt::format("T{} M6", number));
  out_.add("S1000 M3");
  for (int rest = random_.whole(1, 3); rest > 0; --rest) {
    switch (random_.whole(0, kinds_ - 1)) {
      case 0:
      case 1:
        scallops();
        break;
      case 2:
        zigzag();
        break;
      case 3:
        holes();
        break;
      case 4:
        steps();
        break;
      case 5:
        circles();
        break;
      case 7:
        bows();
        break;
      case 8:
        spirals();
        break;
      case 9:
        screws();
        break;
      default:
        chords();
    }
  }
  out_.add(fmt::format("G0 Z{:.4f}", 10.0 * grid_));
}

std::string boxBlank(double grid, const Size& size) {
  return fmt::format("shape = \"box\"\nmin = [{:.4f}, {:.4f}, {:.4f}]\nmax = [{:.4f}, {:.4f}, 0]\n",
                     -0.5 * grid * size.width, -0.5 * grid * size.depth, -grid * size.height,
                     0.5 * grid * size.width, 0.5 * grid * size.depth);
}

/// Lies or stands; its highest point is at 0.
std::string roundBlank(Random& random, double grid, const Size& size) {
  const int axis = random.whole(0, 2);
  const double radius = 0.5 * grid * (axis == 2 ? std::min(size.width, size.depth) : size.height),
               length = grid * (axis == 0   ? size.width
                                : axis == 1 ? size.depth
                                            : size.height);
  return fmt::format(
      "shape = \"cylinder\"\nbase = [{:.4f}, {:.4f}, {:.4f}]\naxis = \"{}\"\nlength = "
      "{:.4f}\nradius = {:.4f}\n",
      axis == 0 ? -0.5 * length : 0.0, axis == 1 ? -0.5 * length : 0.0, axis == 2 ? -length : -radius,
      "xyz"[axis], length, radius);
}

/// A roof on a slab, as OBJ: slanted faces and a ridge.
std::string roofObj(Random& random, double grid, const Size& size) {
  const double x = 0.5 * grid * size.width, y = 0.5 * grid * size.depth, low = -grid * size.height,
               eaves = low * random.number(0.1, 0.6), ridge = x * random.number(-0.4, 0.4);
  std::string text;
  for (const double at : {-y, y}) {
    for (const auto& [px, pz] : {std::pair(-x, low), {x, low}, {x, eaves}, {ridge, 0.0}, {-x, eaves}})
      text += fmt::format("v {:.5f} {:.5f} {:.5f}\n", px, at, pz);
  }
  text += "f 1 2 3\nf 1 3 5\nf 3 4 5\nf 6 8 7\nf 6 10 8\nf 8 10 9\n";
  for (int i = 0; i < 5; ++i) {
    const int a = i + 1, b = (i + 1) % 5 + 1;
    text += fmt::format("f {} {} {} {}\n", a, a + 5, b + 5, b);
  }
  return text;
}

/// One in three of each other; the blank may be cut before by a job of its own.
std::string wideBlank(Random& random, double grid, const Size& size, SoakCase& out) {
  switch (random.whole(0, 3)) {
    case 0:
      return roundBlank(random, grid, size);
    case 1:
      out.files["blank.obj"] = roofObj(random, grid, size);
      return "shape = \"mesh\"\nfile = \"blank.obj\"\n";
    default:
      return boxBlank(grid, size);
  }
}

Program writeProgram(CrowdedWriter& writer, int first, int last) {
  writer.begin();
  for (int tool = first; tool <= last; ++tool) writer.passes(tool);
  return writer.finish();
}

}  // namespace

void makeCrowded(Random& random, SoakCase& out) {
  const bool wide = out.seed >= kFirstCrowdedSeed + kFirstWideSeed;
  constexpr std::array<double, 4> kGrids = {0.2, 0.25, 0.5, 1.0};
  const double grid = kGrids[static_cast<std::size_t>(random.whole(0, 3))];
  const double width = random.number(16, 44), depth = random.number(16, 44);
  const Size size{width, depth, random.number(5, 16)};
  const bool curved = out.seed >= kFirstCrowdedSeed + kFirstCurvedSeed;
  CrowdedWriter writer(random, grid, size, curved ? kCurvedPasses : wide ? kWidePasses : kPlainPasses);
  const int tools = random.whole(1, 3);
  std::string rest;
  for (int tool = 1; tool <= tools; ++tool) rest += writer.tool(tool);
  const std::string resolution = fmt::format("[simulation]\nresolution = {:g}\n", grid);
  const auto job = [&](const char* file, const std::string& stock, const std::string& end) {
    return fmt::format("schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"{}\"\n[stock]\n{}{}",
                       file, stock, end);
  };
  std::string stock = wide ? wideBlank(random, grid, size, out) : boxBlank(grid, size);
  std::string end = rest + resolution;
  if (wide && random.chance(0.2)) {
    out.files["before.nc"] = writeProgram(writer, 1, 1).text;
    out.files["before.toml"] = job("before.nc", stock, end);
    stock = "shape = \"vdb\"\nfile = \"before.vdb\"\n";
    end = rest;
  }
  const Program program = writeProgram(writer, 1, tools);
  out.files["part.nc"] = program.text;
  out.files["idle.nc"] =
      fmt::format("G21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z{:.3f}\nG1 X1 F300\nM30\n", 20.0 * grid);
  out.stops = program.stops;
  out.files["job.toml"] = job("part.nc", stock, end);
  out.files["idle.toml"] = job("idle.nc", stock, end);
}

}  // namespace proveout::soak
