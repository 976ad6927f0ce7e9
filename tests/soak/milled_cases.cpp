// Random milled jobs for the nct control.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/soak/soak_case.h"

namespace proveout::soak {
namespace {

using Point = std::array<double, 3>;

struct Bounds {
  Point min{}, max{};
  double size(int axis) const { return max[axis] - min[axis]; }
};

struct Blank {
  std::string toml;
  Bounds bounds;
};

std::string triple(const Point& p) { return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", p[0], p[1], p[2]); }

Bounds randomBounds(Random& random, double least, double most) {
  Bounds b;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = random.number(least, most);
    b.min[axis] = random.chance(0.3) ? std::round(random.number(-20, 20)) : random.number(-20, 20);
    b.max[axis] = b.min[axis] + size;
  }
  return b;
}

/// One side, or the diameter, is two to four cells.
void makeThin(Random& random, double grid, Bounds& b) {
  const int axis = random.whole(0, 2);
  b.max[axis] = b.min[axis] + random.number(2.02, 4.0) * grid;
  if (random.chance(0.5)) {
    const int other = (axis + random.whole(1, 2)) % 3;
    b.max[other] = b.min[other] + random.number(2.02, 6.0) * grid;
  }
}

Blank boxBlank(const Bounds& b) {
  return {fmt::format("[stock]\nshape = \"box\"\nmin = {}\nmax = {}\n", triple(b.min), triple(b.max)), b};
}

/// Fills `b` along one axis. A tube's wall is `least_wall` thick at least.
Blank roundBlank(Random& random, Bounds b, double least_wall) {
  const int axis = random.whole(0, 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double radius = 0.5 * std::min(b.size(u), b.size(v));
  Point base;
  base[axis] = b.min[axis];
  for (const int side : {u, v}) {
    base[side] = b.min[side] + radius;
    b.max[side] = b.min[side] + 2 * radius;
  }
  std::string text = fmt::format("base = {}\naxis = \"{}\"\nlength = {:.4f}\nradius = {:.4f}\n", triple(base),
                                 "xyz"[axis], b.size(axis), radius);
  const bool tube = radius > 1.6 * least_wall && random.chance(0.4);
  if (tube)
    text += fmt::format("inner_radius = {:.4f}\n", random.number(0.2 * least_wall, radius - least_wall));
  return {fmt::format("[stock]\nshape = \"{}\"\n{}", tube ? "tube" : "cylinder", text), b};
}

/// A prism over a polygon that is turned about all axes, as OBJ.
std::string prismObj(Random& random, const Bounds& b) {
  const int n = random.whole(3, 9);
  const double radius = 0.5 * std::min({b.size(0), b.size(1), b.size(2)}),
               half = radius * random.number(0.3, 1.0);
  const double a = random.chance(0.4) ? 0.0 : random.number(0, 6.2),
               t = random.chance(0.4) ? 0.0 : random.number(0, 3.1);
  const bool star = random.chance(0.3);
  std::string text;
  for (const double z : {-half, half}) {
    for (int i = 0; i < n; ++i) {
      const double w = 2 * std::numbers::pi * i / n, r = radius * (star && i % 2 == 1 ? 0.55 : 0.95);
      const double x = r * std::cos(w), y = r * std::sin(w);
      const double y1 = y * std::cos(t) - z * std::sin(t), z1 = y * std::sin(t) + z * std::cos(t);
      text += fmt::format(
          "v {:.5f} {:.5f} {:.5f}\n", 0.5 * (b.min[0] + b.max[0]) + x * std::cos(a) - y1 * std::sin(a),
          0.5 * (b.min[1] + b.max[1]) + x * std::sin(a) + y1 * std::cos(a), 0.5 * (b.min[2] + b.max[2]) + z1);
    }
  }
  // Caps as fans about their middles, which lie inside a star too.
  for (const double z : {-half, half}) {
    text +=
        fmt::format("v {:.5f} {:.5f} {:.5f}\n", 0.5 * (b.min[0] + b.max[0]) + z * std::sin(t) * std::sin(a),
                    0.5 * (b.min[1] + b.max[1]) - z * std::sin(t) * std::cos(a),
                    0.5 * (b.min[2] + b.max[2]) + z * std::cos(t));
  }
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    text += fmt::format("f {} {} {}\nf {} {} {}\n", 2 * n + 1, k + 1, i + 1, 2 * n + 2, n + i + 1, n + k + 1);
    text += fmt::format("f {} {} {} {}\n", i + 1, k + 1, n + k + 1, n + i + 1);
  }
  return text;
}

class ProgramWriter {
 public:
  ProgramWriter(Random& random, const Bounds& b, bool helices) : random_(random), b_(b), helices_(helices) {}

  Program write(int tools) {
    out_.add("G21 G90 G17 G40");
    for (int tool = 1; tool <= tools; ++tool) {
      out_.add(fmt::format("T{} M6", tool));
      out_.add("S1000 M3");
      goTo(random_.chance(0.5));
      const int motions = random_.whole(1, 6);
      for (int i = 0; i < motions; ++i) motion();
      out_.stops.push_back(out_.lines);
      out_.add(fmt::format("G0 Z{:.4f}", safe()));
    }
    out_.add("M30");
    return std::move(out_);
  }

 private:
  double safe() const { return b_.max[2] + 5.0; }
  double level(int axis) {
    return random_.number(b_.min[axis] - 0.1 * b_.size(axis), b_.max[axis] + 0.1 * b_.size(axis));
  }
  double height() { return random_.number(b_.min[2] - 0.05 * b_.size(2), b_.max[2] + 0.15 * b_.size(2)); }
  void goTo(bool deep) {
    at_ = {level(0), level(1), deep ? height() : b_.max[2] - 0.2 * b_.size(2) * random_.unit()};
    out_.add(fmt::format("G0 X{:.4f} Y{:.4f} Z{:.4f}", at_[0], at_[1], safe()));
    out_.add(fmt::format("G1 Z{:.4f} F300", at_[2]));
  }
  void motion() {
    if (random_.chance(0.3)) out_.stops.push_back(out_.lines);
    const int style = helices_ ? 7 : random_.whole(0, 7);
    if (style >= 6) return arc(style == 7);
    Point to{level(0), level(1), height()};
    if (style <= 1) to[2] = at_[2];
    if (style == 2) to[0] = at_[0];
    if (style == 3) to = {at_[0], at_[1], to[2]};
    if (style == 4) to = {at_[0] + random_.number(-0.05, 0.05), at_[1], at_[2] + random_.number(-0.05, 0.02)};
    out_.add(fmt::format("G1 X{:.4f} Y{:.4f} Z{:.4f}", to[0], to[1], to[2]));
    at_ = to;
  }
  void arc(bool helix) {
    const double radius = random_.number(0.05, 0.5) * std::max(b_.size(0), b_.size(1)),
                 from = random_.number(0, 6.28);
    const double i = radius * std::cos(from), j = radius * std::sin(from);
    const bool full = random_.chance(0.4);
    Point to = at_;
    if (!full) {
      const double w = random_.number(0, 6.28);
      to = {at_[0] + i + radius * std::cos(w), at_[1] + j + radius * std::sin(w), at_[2]};
    }
    if (helix) to[2] = height();
    // Several turns: L on the block of the arc.
    const std::string turns = helix && random_.chance(0.5) ? fmt::format(" L{}", random_.whole(2, 12)) : "";
    out_.add(fmt::format("G{} X{:.4f} Y{:.4f} Z{:.4f} I{:.4f} J{:.4f}{}", random_.whole(2, 3), to[0], to[1],
                         to[2], i, j, turns));
    at_ = to;
    out_.add("G1 F300");
  }

  Random& random_;
  Bounds b_;
  bool helices_;
  Point at_{};
  Program out_;
};

std::string idleProgram(const Bounds& b) {
  return fmt::format("G21 G90 G17\nT1 M6\nS1000 M3\nG0 X{:.3f} Y{:.3f} Z{:.3f}\nG1 X{:.3f} F300\nM30\n",
                     b.min[0], b.min[1], b.max[2] + 5, b.max[0]);
}

std::string clampToml(Random& random, const Bounds& b, double grid, const std::string& table) {
  const double wide = std::max(2.1 * grid, 0.3 * b.size(0));
  const double x = b.min[0] - wide - random.number(0, 2);
  if (random.chance(0.5)) {
    return fmt::format("[[{}]]\nname = \"clamp\"\nshape = \"box\"\nmin = {}\nmax = {}\n", table,
                       triple({x, b.min[1], b.min[2]}), triple({x + wide, b.max[1], b.max[2] + 2}));
  }
  return fmt::format(
      "[[{}]]\nname = \"pin\"\nshape = \"cylinder\"\nbase = {}\nlength = {:.4f}\nradius = {:.4f}\n", table,
      triple({x, b.min[1], b.min[2]}), b.size(2) + 2.1 * grid, wide);
}

/// Where a box is after a turn by the degrees of a fixed Z, or over X.
struct Turn {
  std::string toml;
  bool flip = false, quarter = false;
};

Bounds turned(const Bounds& b, double deg, bool flip, const Point& shift) {
  Bounds out{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  const double w = deg * std::numbers::pi / 180;
  for (int corner = 0; corner < 8; ++corner) {
    Point p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = corner >> axis & 1 ? b.max[axis] : b.min[axis];
    if (flip) p = {p[0], -p[1], -p[2]};
    p = {p[0] * std::cos(w) - p[1] * std::sin(w), p[0] * std::sin(w) + p[1] * std::cos(w), p[2]};
    for (int axis = 0; axis < 3; ++axis) {
      out.min[axis] = std::min(out.min[axis], p[axis] + shift[axis]);
      out.max[axis] = std::max(out.max[axis], p[axis] + shift[axis]);
    }
  }
  return out;
}

struct Heads {
  std::string top, simulation, tools;
  int tool_count = 0;
};

void writeSetups(Random& random, const Blank& blank, double grid, const Heads& heads, SoakCase& out) {
  const int count = random.whole(2, 3);
  std::string job, idle;
  Bounds b = blank.bounds;
  for (int k = 0; k < count; ++k) {
    const std::string name = fmt::format("s{}", k + 1), program = fmt::format("p{}.nc", k + 1);
    std::string text = fmt::format("[[setup]]\nname = \"{}\"\nprogram = \"", name), transform;
    if (k > 0) {
      constexpr double kTurns[] = {0, 90, 180, 33, 33, -147};
      const double deg = kTurns[random.whole(0, 5)];
      const bool flip = random.chance(0.5);
      const Point shift{random.number(-5, 5), random.number(-5, 5), random.number(-5, 5)};
      b = turned(b, deg, flip, shift);
      transform = fmt::format("[setup.transform]\nrotate = [{}, 0, {:g}]\ntranslate = {}\n", flip ? 180 : 0,
                              deg, triple(shift));
    }
    const std::string fixture = random.chance(0.3) ? clampToml(random, b, grid, "setup.fixture") : "";
    job += text + program + "\"\n" + transform + fixture;
    idle += text + fmt::format("i{}.nc\"\n", k + 1) + transform + fixture;
    Program written = ProgramWriter(random, b, false).write(random.whole(1, heads.tool_count));
    out.files[program] = written.text;
    out.files[fmt::format("i{}.nc", k + 1)] = idleProgram(b);
    out.stops = written.stops;
    out.last_setup = name;
  }
  out.files["job.toml"] = heads.top + blank.toml + job + heads.tools + heads.simulation;
  out.files["idle.toml"] = heads.top + blank.toml + idle + heads.tools + heads.simulation;
}

}  // namespace

std::string randomTool(Random& random, int number, double d) {
  std::string text = fmt::format("[[tool]]\nnumber = {}\n", number);
  switch (random.whole(0, 8)) {
    case 0:
    case 1:
      return text + fmt::format("type = \"flat\"\ndiameter = {:.4f}\n", d);
    case 2:
    case 3:
      return text + fmt::format("type = \"ball\"\ndiameter = {:.4f}\n", d);
    case 4:
      return text + fmt::format("type = \"bull\"\ndiameter = {:.4f}\ncorner_radius = {:.4f}\n", d,
                                random.number(0.05, 0.45) * d);
    case 5:
      return text + fmt::format("type = \"drill\"\ndiameter = {:.4f}\npoint_angle = {:.1f}\n", d,
                                random.number(60, 150));
    case 6:
      return text +
             fmt::format("type = \"cone\"\ndiameter = {:.4f}\ncone_angle = {:.1f}\ntip_diameter = {:.4f}\n",
                         d, random.number(30, 120), random.chance(0.5) ? 0.0 : random.number(0.05, 0.6) * d);
    case 7:
      return text +
             fmt::format("type = \"tslot\"\ndiameter = {:.4f}\nthickness = {:.4f}\nneck_diameter = {:.4f}\n",
                         d, 0.4 * d, 0.4 * d);
    default:
      return text +
             fmt::format("type = \"lollipop\"\ndiameter = {:.4f}\nneck_diameter = {:.4f}\n", d, 0.5 * d);
  }
}

void makeMilled(Random& random, SoakCase& out) {
  constexpr double kGrids[] = {0.25, 0.3, 0.5, 0.6, 0.8, 1.0};
  const bool thin = out.kind == Kind::kThinBlank || random.chance(0.2);
  double grid = kGrids[random.whole(0, 5)];
  Bounds b = randomBounds(random, 8 * grid, 40 * grid);
  if (thin) makeThin(random, grid, b);
  Blank blank = random.chance(0.5) ? boxBlank(b) : roundBlank(random, b, 2.02 * grid);
  if (out.kind == Kind::kMeshBlank) {
    out.files["blank.obj"] = prismObj(random, blank.bounds);
    blank.toml = "[stock]\nshape = \"mesh\"\nfile = \"blank.obj\"\n";
  }
  Heads heads;
  heads.top = "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n";
  heads.simulation = fmt::format("[simulation]\nresolution = {:g}\n", grid);
  heads.tool_count = random.whole(1, 3);
  const double size = std::max({blank.bounds.size(0), blank.bounds.size(1), blank.bounds.size(2)});
  for (int tool = 1; tool <= heads.tool_count; ++tool)
    heads.tools += randomTool(random, tool, random.number(0.15, 0.8) * size);
  if (out.kind == Kind::kSetups) return writeSetups(random, blank, grid, heads, out);

  const Program program =
      ProgramWriter(random, blank.bounds, out.kind == Kind::kHelix).write(heads.tool_count);
  out.files["part.nc"] = program.text;
  out.files["idle.nc"] = idleProgram(blank.bounds);
  out.stops = program.stops;
  std::string stock = blank.toml, rest = heads.tools + heads.simulation;
  const std::string part = "program = \"part.nc\"\n", idle = "program = \"idle.nc\"\n";
  if (out.kind == Kind::kFixtures || random.chance(0.15))
    rest += clampToml(random, blank.bounds, grid, "fixture");
  if (out.kind == Kind::kSavedStock) {
    const Program before = ProgramWriter(random, blank.bounds, false).write(1);
    out.files["before.nc"] = before.text;
    out.files["before.toml"] =
        heads.top + "program = \"before.nc\"\n" + stock + heads.tools + heads.simulation;
    stock = "[stock]\nshape = \"vdb\"\nfile = \"before.vdb\"\n";
    rest = heads.tools;
  }
  out.files["job.toml"] = heads.top + part + stock + rest;
  out.files["idle.toml"] = heads.top + idle + stock + rest;
}

}  // namespace proveout::soak
