// What holds for every program: the same contour written, placed or called in different ways.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout {
namespace {

struct Piece {
  Vec3 to;
  bool arc = false;
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double sweep = 0.0;
};

struct Path {
  std::vector<Piece> pieces;
  int errors = 0, warnings = 0;
  std::string first;  ///< first diagnostic
};

class PieceSink : public MotionSink {
 public:
  explicit PieceSink(Path& path) : path_(path) {}
  void file(std::uint32_t, const std::string&) override {}
  void motion(const Motion& m, const ArcGeometry* arc, const AxisSweep*) override {
    Piece piece{m.to};
    if (arc != nullptr) piece = {m.to, true, arc->center, arc->normal, arc->sweep_rad};
    path_.pieces.push_back(piece);
  }
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& d) override {
    (d.severity == Severity::kError ? path_.errors : path_.warnings) += 1;
    if (path_.first.empty()) path_.first = d.code + ": " + d.message;
  }

 private:
  Path& path_;
};

Path run(const std::string& text, double radius = 0.0,
         const std::vector<std::pair<std::string, std::string>>& subprograms = {}) {
  MemoryProgramSource source("main.nc", text);
  for (const auto& [name, sub] : subprograms) source.add(name, sub);
  ControlSettings settings;
  settings.start = Vec3::Zero();
  settings.radius_offsets[1] = {radius, 0.0};
  Path path;
  PieceSink sink(path);
  interpret(ControlId::kNct, source, settings, sink);
  return path;
}

/// A block of a contour in G17, absolute, mm.
struct Step {
  int g = 1;
  Vec3 to = Vec3::Zero();
  Vec2 center = Vec2::Zero();
};

double rounded(double value) { return std::round(value * 1e3) * 1e-3; }

/// Lines, arcs and heights at random.
std::vector<Step> randomSteps(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-80.0, 80.0), angle(-std::numbers::pi, std::numbers::pi);
  std::vector<Step> steps(1);
  steps[0].g = 0;
  steps[0].to = {rounded(place(random)), rounded(place(random)), 10.0};
  for (int k = 0; k < 12; ++k) {
    Step step;
    const Vec3 from = steps.back().to;
    step.g = static_cast<int>(random() % 4);
    step.to = {rounded(place(random)), rounded(place(random)), rounded(0.1 * place(random))};
    if (step.g >= 2) {
      step.center = {rounded(place(random)), rounded(place(random))};
      const Vec2 arm = from.head<2>() - step.center;
      const double a = angle(random);
      step.to.head<2>() = step.center + Vec2(std::cos(a) * arm.x() - std::sin(a) * arm.y(),
                                             std::sin(a) * arm.x() + std::cos(a) * arm.y());
      step.to.x() = rounded(step.to.x());
      step.to.y() = rounded(step.to.y());
      if (arm.norm() < 5.0 || (step.to - from).head<2>().norm() < 1.0) continue;
    }
    steps.push_back(step);
  }
  return steps;
}

struct Writing {
  bool incremental = false;
  double unit = 1.0;
  std::string axes = "XYZ", centers = "IJ";
};

std::string write(const std::vector<Step>& steps, const Writing& how, std::size_t first = 0) {
  std::string text;
  Vec3 at = Vec3::Zero();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step& step = steps[k];
    if (k >= first) {
      text += fmt::format("G{}", step.g);
      for (int axis = 0; axis < 3; ++axis) {
        const double value = how.incremental ? step.to[axis] - at[axis] : step.to[axis];
        text += fmt::format("{}{:.9f}", how.axes[static_cast<std::size_t>(axis)], value / how.unit);
      }
      for (int axis = 0; axis < 2 && step.g >= 2; ++axis) {
        const double value = (step.center[axis] - at[axis]) / how.unit;
        text += fmt::format("{}{:.9f}", how.centers[static_cast<std::size_t>(axis)], value);
      }
      text += "\n";
    }
    at = step.to;
  }
  return text;
}

using Map = std::function<Vec3(const Vec3&)>;

/// Are the pieces of `b` those of `a` behind the map? `sense` < 0: it is a reflection.
void expectImage(const Path& a, const Path& b, const Map& map, double tolerance, double sense = 1.0) {
  ASSERT_EQ(a.first, b.first);
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t k = 0; k < a.pieces.size(); ++k) {
    const Piece &p = a.pieces[k], &q = b.pieces[k];
    EXPECT_LT((map(p.to) - q.to).norm(), tolerance) << k;
    ASSERT_EQ(p.arc, q.arc) << k;
    if (!p.arc) continue;
    EXPECT_LT((map(p.center) - q.center).norm(), tolerance) << k;
    EXPECT_NEAR(p.sweep * sense, q.sweep, 1e-6) << k;
  }
}

TEST(ProgramProperty, IncrementsAndAbsolutePositionsAreOnePath) {
  std::mt19937 random(1);
  for (int k = 0; k < 40; ++k) {
    const auto steps = randomSteps(random);
    const Path absolute = run("F500\n" + write(steps, {}) + "M30\n");
    const Path increments = run("F500 G91\n" + write(steps, {true, 1.0, "XYZ", "IJ"}) + "M30\n");
    const Path words = run("F500\n" + write(steps, {true, 1.0, "UVW", "IJ"}) + "M30\n");
    EXPECT_EQ(absolute.errors, 0) << absolute.first;
    const Map same = [](const Vec3& p) { return p; };
    expectImage(absolute, increments, same, 1e-7);
    expectImage(absolute, words, same, 1e-7);
  }
}

TEST(ProgramProperty, InchesAreMillimetres) {
  std::mt19937 random(2);
  for (int k = 0; k < 40; ++k) {
    const auto steps = randomSteps(random);
    const Path metric = run("G21 F500\n" + write(steps, {}) + "M30\n");
    const Path inch = run("G20 F20\n" + write(steps, {false, 25.4, "XYZ", "IJ"}) + "M30\n");
    expectImage(
        metric, inch, [](const Vec3& p) { return p; }, 1e-6);
  }
}

TEST(ProgramProperty, PlanesAreTurnedAxes) {
  std::mt19937 random(3);
  for (int k = 0; k < 40; ++k) {
    const auto steps = randomSteps(random);
    const Path xy = run("G17 F500\n" + write(steps, {}) + "M30\n");
    const Path zx = run("G18 F500\n" + write(steps, {false, 1.0, "ZXY", "KI"}) + "M30\n");
    const Path yz = run("G19 F500\n" + write(steps, {false, 1.0, "YZX", "JK"}) + "M30\n");
    expectImage(
        xy, zx, [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); }, 1e-7);
    expectImage(
        xy, yz, [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); }, 1e-7);
  }
}

/// The same contour behind `head`, with what it makes of points.
struct Placement {
  std::string head;
  Map map;
  double sense = 1.0;
};

std::vector<Placement> placements(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  const double x = rounded(place(random)), y = rounded(place(random)), degrees = rounded(3.0 * place(random));
  const double a = degrees * std::numbers::pi / 180.0;
  const Map rotate = [=](const Vec3& p) {
    const double dx = p.x() - x, dy = p.y() - y;
    return Vec3(x + dx * std::cos(a) - dy * std::sin(a), y + dx * std::sin(a) + dy * std::cos(a), p.z());
  };
  const Map mirror = [=](const Vec3& p) { return Vec3(2.0 * x - p.x(), p.y(), p.z()); };
  const std::string rotation = fmt::format("G68 X{} Y{} R{}\n", x, y, degrees);
  return {{rotation, rotate, 1.0},
          {fmt::format("G51.1 X{}\n", x), mirror, -1.0},
          {fmt::format("G51.1 X{} Y{}\n", x, y),
           [=](const Vec3& p) { return Vec3(2.0 * x - p.x(), 2.0 * y - p.y(), p.z()); }, 1.0},
          {fmt::format("G51.1 X{}\n", x) + rotation, [=](const Vec3& p) { return mirror(rotate(p)); }, -1.0},
          {fmt::format("G51 X{} Y{} Z0 I-1\n", x, y), mirror, -1.0}};
}

TEST(ProgramProperty, RotationAndMirrorMoveThePath) {
  std::mt19937 random(4);
  for (int k = 0; k < 20; ++k) {
    const auto steps = randomSteps(random);
    const Path plain = run("F500\n" + write(steps, {}) + "M30\n");
    for (const Placement& placed : placements(random)) {
      SCOPED_TRACE(placed.head);
      expectImage(plain, run("F500\n" + placed.head + write(steps, {}) + "M30\n"), placed.map, 1e-6,
                  placed.sense);
    }
  }
}

TEST(ProgramProperty, ScalingMovesThePath) {
  std::mt19937 random(5);
  for (int k = 0; k < 30; ++k) {
    const auto steps = randomSteps(random);
    const Path plain = run("F500\n" + write(steps, {}) + "M30\n");
    const double factor = 0.2 + 0.1 * k;
    const Path scaled = run(fmt::format("F500\nG51 X10 Y-20 Z5 P{}\n", factor) + write(steps, {}) + "M30\n");
    const Vec3 center(10.0, -20.0, 5.0);
    expectImage(
        plain, scaled, [&](const Vec3& p) { return Vec3(center + factor * (p - center)); }, 1e-6);
  }
}

/// A star-shaped closed contour about the origin, counter-clockwise, from its first corner back to it.
std::vector<Vec2> randomContour(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(30.0, 60.0);
  const std::size_t corners = 5 + random() % 8;
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < corners; ++k) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double r = radius(random);
    points.push_back({rounded(r * std::cos(a)), rounded(r * std::sin(a))});
  }
  return points;
}

/// The contour with compensation: it begins and ends in the middle of the first side, with `aids` behind each
/// corner block (,R5 and the like).
std::string contourProgram(const std::vector<Vec2>& points, bool left, const std::string& aids) {
  const Vec2 middle = 0.5 * (points[0] + points[1]);
  const Vec2 along = (points[1] - points[0]).normalized();
  const Vec2 away = (left ? 1.0 : -1.0) * Vec2(-along.y(), along.x());
  const Vec2 start = middle + 20.0 * away, before = middle - 2.0 * along, behind = middle + 2.0 * along;
  std::string text = fmt::format("G0 X{:.6f} Y{:.6f}\n", start.x(), start.y());
  text += fmt::format("{} D1 G1 X{:.6f} Y{:.6f}\n", left ? "G41" : "G42", before.x(), before.y());
  for (std::size_t k = 1; k <= points.size(); ++k) {
    const Vec2& p = points[k % points.size()];
    text += fmt::format("X{:.6f} Y{:.6f} {}\n", p.x(), p.y(), aids);
  }
  text += fmt::format("X{:.6f} Y{:.6f}\n", behind.x(), behind.y());
  return text + fmt::format("G40 X{:.6f} Y{:.6f}\n", start.x(), start.y());
}

TEST(ProgramProperty, CompensatedContoursMoveWithTheirTransform) {
  std::mt19937 random(6);
  int sound = 0;
  for (int k = 0; k < 15; ++k) {
    const auto points = randomContour(random);
    for (const bool left : {false, true}) {
      for (const char* aids : {"", ",R2", ",C2"}) {
        const std::string text = contourProgram(points, left, aids) + "M30\n";
        const Path plain = run("F500\n" + text, 3.0);
        sound += plain.errors == 0;
        for (const Placement& placed : placements(random)) {
          SCOPED_TRACE(placed.head + text);
          const Path moved = run("F500\n" + placed.head + text, 3.0);
          expectImage(plain, moved, placed.map, 1e-5, placed.sense);
        }
      }
    }
  }
  EXPECT_GT(sound, 60);
}

double distanceTo(const std::vector<Vec2>& points, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 a = points[k], b = points[(k + 1) % points.size()];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    best = std::min(best, (p - a - t * (b - a)).norm());
  }
  return best;
}

TEST(ProgramProperty, CompensatedContoursKeepTheirDistanceOrSayWhyNot) {
  std::mt19937 random(7);
  int checked = 0;
  for (int k = 0; k < 200; ++k) {
    const auto points = randomContour(random);
    const double radius = 1.0 + 0.05 * k;
    const bool left = k % 2 == 0;
    const Path path = run("F500\n" + contourProgram(points, left, "") + "M30\n", radius);
    if (path.errors + path.warnings > 0) continue;
    ++checked;
    // Between the move that starts compensation and the one that ends it the tool rides on the contour.
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t m = 2; m + 1 < path.pieces.size(); ++m) {
      const Vec3 from = path.pieces[m - 1].to, to = path.pieces[m].to;
      for (int i = 0; i <= 50; ++i) {
        const Vec3 p = from + (to - from) * (0.02 * i);
        nearest = std::min(nearest, distanceTo(points, p.head<2>()));
      }
    }
    EXPECT_NEAR(nearest, radius, 1e-5) << contourProgram(points, left, "");
  }
  EXPECT_GT(checked, 100);
}

TEST(ProgramProperty, RepeatedCallsAreTheTextWrittenOut) {
  std::mt19937 random(8);
  for (int k = 0; k < 20; ++k) {
    auto steps = randomSteps(random);
    const std::string body = write(steps, {true, 1.0, "XYZ", "IJ"});
    const int times = 1 + static_cast<int>(random() % 5);
    std::string unrolled = "F500 G91\n";
    for (int i = 0; i < times; ++i) unrolled += body;
    const Path plain = run(unrolled + "M30\n");
    const Path called =
        run(fmt::format("F500 G91\nM98 P7 L{}\nM30\n", times), 0.0, {{"O0007.nc", body + "M99\n"}});
    expectImage(
        plain, called, [](const Vec3& p) { return p; }, 1e-9);
  }
}

/// All cycles at some holes; addresses as the plane wants them, "XYZIJ" in G17.
std::string cycleProgram(std::mt19937& random, const std::string& names) {
  std::uniform_real_distribution<double> place(-80.0, 80.0);
  const auto word = [&](int k, double value) {
    return fmt::format("{}{:.3f}", names[static_cast<std::size_t>(k)], value);
  };
  std::string text = "M3 S500 F200\n" + word(2, 30.0) + "\n";
  for (const char* code :
       {"G73", "G74", "G76", "G81", "G82", "G83", "G84", "G84.2", "G84.3", "G85", "G86", "G88", "G89"}) {
    text += fmt::format("{} {} {} {} {} R{:.3f} Q4 P1\n", random() % 2 ? "G98" : "G99", code,
                        word(0, place(random)), word(1, place(random)),
                        word(2, -0.2 * std::abs(place(random)) - 1.0), 2.0 + 0.1 * std::abs(place(random)));
    text += fmt::format("G91 {} {} L3\nG90 G80\n", word(0, 10.0), word(1, rounded(0.1 * place(random))));
  }
  return text + fmt::format("G87 {} {} {}2 {}1 {} R-20\nG80\nM30\n", word(0, 1.0), word(1, 2.0), names[3],
                            names[4], word(2, -5.0));
}

TEST(ProgramProperty, CyclesInAllPlanesAreTurnedAxes) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto written = [&](const char* plane, const char* names) {
      std::mt19937 random(seed);
      return run(plane + cycleProgram(random, names));
    };
    const Path xy = written("G17 ", "XYZIJ");
    EXPECT_EQ(xy.errors, 0) << xy.first;
    EXPECT_GT(xy.pieces.size(), 150u);
    expectImage(
        xy, written("G18 ", "ZXYKI"), [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); }, 1e-9);
    expectImage(
        xy, written("G19 ", "YZXJK"), [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); }, 1e-9);
  }
}

TEST(ProgramProperty, HolesFollowTheTransform) {
  std::mt19937 random(9);
  const std::string text = "G98 G81 X10 Y5 Z-8 R2 F100\nX20 Y-3\nG91 X4 Y2 L3\nG90 G80\nM30\n";
  const Path plain = run("G0 X1 Y1 Z20\n" + text);
  EXPECT_EQ(plain.errors, 0) << plain.first;
  for (int k = 0; k < 10; ++k) {
    for (const Placement& placed : placements(random)) {
      SCOPED_TRACE(placed.head);
      expectImage(plain, run(placed.head + "G0 X1 Y1 Z20\n" + text), placed.map, 1e-9);
    }
  }
}

}  // namespace
}  // namespace proveout
