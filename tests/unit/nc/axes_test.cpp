// Paths with parallel axes, turning tables and virtual planes, against points computed here.
// Rows: nct-4.3.2-helix nct-4.6-R nct-4.6-comp nct-4.6-plane
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "core/nc/registry/interpreter.h"
#include "tests/support/linear_axis.h"

namespace proveout {
namespace {

struct Outcome {
  Toolpath path;
  InterpretSummary summary;
  std::string error;
};

Outcome runOf(const std::string& text, const ControlSettings& settings) {
  Outcome out;
  ToolpathBuilder sink(out.path);
  out.summary = interpret(ControlId::kNct, MemoryProgramSource("main.nc", text), settings, sink);
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.severity == Severity::kError && out.error.empty()) out.error = d.code + ": " + d.message;
  }
  return out;
}

ControlSettings machineWith(std::initializer_list<AxisSettings> axes) {
  ControlSettings settings;
  settings.start = Vec3::Zero();
  settings.axes = axes;
  return settings;
}

AxisSettings rotary(const std::string& name, int number) {
  AxisSettings axis;
  axis.name = name;
  axis.number = number;
  return axis;
}

/// Largest distance of the path's points of line `line` from the curve, whose points are `at` of 0..1: the
/// way along the path goes with the time.
double deviation(const Toolpath& path, std::uint32_t line, const std::function<Vec3(double)>& at) {
  double total = 0, done = 0, worst = 0;
  for (const Motion& m : path.motions) total += m.source.line == line ? m.time_s : 0.0;
  for (const Motion& m : path.motions) {
    if (m.source.line != line) continue;
    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      worst = std::max(worst, (path.pointAt(m, u) - at((done + u * m.time_s) / total)).norm());
    }
    done += m.time_s;
  }
  EXPECT_GT(total, 0.0);
  return worst;
}

// The manual's helix on the side of an oblique cylinder: V goes along with Y.
TEST(Axes, HelixWithAParallelAxis) {
  const Outcome r = runOf("G17 G90 G0 X100 Y0 Z0 V0\nG03 X0 Y-100 Z50 V20 I-100 F600\nM30\n",
                          machineWith({test::linearAxisOf("V", 4, "Y")}));
  ASSERT_EQ(r.error, "");
  const auto at = [](double t) {
    const double a = 1.5 * kPi * t;
    return Vec3(100 * std::cos(a), 100 * std::sin(a) + 20 * t, 50 * t);
  };
  EXPECT_LT(deviation(r.path, 2, at), 2e-4);
  EXPECT_NEAR(r.path.motions.back().to.y(), -80, 1e-9);
  EXPECT_LT((at(1.0 / 3) - Vec3(0, 106.666667, 16.666667)).norm(), 1e-5);  // the manual's own point
  EXPECT_NEAR(r.summary.cutting_s, 60 * 471.238898 / 600, 1e-4);
}

TEST(Axes, ArcsAlongParallelAxesAreArcs) {
  const Outcome r = runOf("G17 G0 X10 V0 Y3\nG17 X10 V0\nG3 X0 V10 Z4 I-10 F600\nM30\n",
                          machineWith({test::linearAxisOf("V", 4, "Y")}));
  ASSERT_EQ(r.error, "");
  ASSERT_EQ(r.path.motions.size(), 2u);
  EXPECT_EQ(r.path.motions[1].shape(), MotionShape::kArc);
  EXPECT_LT((r.path.motions[1].to - Vec3(0, 13, 4)).norm(), 1e-9);
}

/// Right-handed turn about an axis through `center`, by the rotation formula.
Vec3 turned(const Vec3& p, const Vec3& axis, const Vec3& center, double degrees) {
  const double a = degToRad(degrees);
  const Vec3 d = p - center, k = axis.normalized();
  const Vec3 cross(k.y() * d.z() - k.z() * d.y(), k.z() * d.x() - k.x() * d.z(),
                   k.x() * d.y() - k.y() * d.x());
  return center + d * std::cos(a) + cross * std::sin(a) + k * k.dot(d) * (1 - std::cos(a));
}

// Random motions of a trunnion: A on the bed with an oblique axis, C on it.
TEST(Axes, TablesTurnThePart) {
  ControlSettings settings = machineWith({rotary("A", 4), rotary("C", 5)});
  settings.axes[0].direction = Vec3(1, 0.2, -0.1);
  settings.axes[0].center = Vec3(1, 2, 3);
  settings.axes[1].center = Vec3(-4, 5, 6);
  settings.work_offsets[0] = Vec3(10, 20, 30);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(-30, 30), angle(-200, 200);
  std::array<double, 5> from{}, to{};
  std::string text = "G90 G1 F1000\n";
  std::vector<std::array<double, 5>> points{from};
  for (int k = 0; k < 20; ++k) {
    for (std::size_t i = 0; i < 5; ++i)
      to[i] = k % 4 == 1 && i < 3 ? from[i] : i < 3 ? length(random) : angle(random);
    if (k % 4 == 2) to[3] = from[3];
    if (k % 4 == 3) to[4] = from[4];
    char line[200];
    std::snprintf(line, sizeof line, "X%.9f Y%.9f Z%.9f A%.9f C%.9f\n", to[0], to[1], to[2], to[3], to[4]);
    text += line;
    points.push_back(to);
    from = to;
  }
  const Outcome r = runOf(text + "M30\n", settings);
  ASSERT_EQ(r.error, "");
  const auto point = [&](const std::array<double, 5>& p) {
    const Vec3 c(Vec3(1, 2, 3) - settings.work_offsets[0]), e(Vec3(-4, 5, 6) - settings.work_offsets[0]);
    return turned(turned(Vec3(p[0], p[1], p[2]), {1, 0.2, -0.1}, c, p[3]), {0, 0, 1}, e, p[4]);
  };
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto at = [&](double t) {
      std::array<double, 5> p{};
      for (std::size_t i = 0; i < 5; ++i) p[i] = points[k - 1][i] + (points[k][i] - points[k - 1][i]) * t;
      return point(p);
    };
    EXPECT_LT(deviation(r.path, static_cast<std::uint32_t>(k + 1), at), 3e-4) << k;
  }
  const Motion& last = r.path.motions.back();
  ASSERT_GE(last.axis, 0);
  const Vec3 up =
      turned(turned(Vec3::UnitZ(), {1, 0.2, -0.1}, Vec3::Zero(), to[3]), {0, 0, 1}, Vec3::Zero(), to[4]);
  EXPECT_LT((r.path.axes[static_cast<std::size_t>(last.axis)].to - up).norm(), 1e-8);
}

/// Unrolls points of a path on a cylinder about X: (mm along the surface at radius r, x).
Vec2 unrolled(const Vec3& p, double r, double near_deg) {
  double a = radToDeg(std::atan2(-p.y(), p.z()));
  a += 360 * std::round((near_deg - a) / 360);
  return {degToRad(a) * r, p.x()};
}

const char* const kGroove =
    "N30 G0 Y0\nN40 G18 X-20 A0\nN40 G1 Z25.65 F500\nN50 G7.1 A28.65\nN60 G1 G42 X-10 F500 D1\nN70 A30\n"
    "N80 G2 X-40 A90 R30\nN90 G1 X-60\nN100 G3 X-75 A120 R15\nN110 G1 A180\nN120 G3 X-57.5 A240 R35\n"
    "N130 G1 X-27.5 A275\nN140 G2 X-10 A335 R35\nN150 G1 A360\nN160 G40 X-20 (A380)\nN170 G7.1 A0\nN180 G0 "
    "Z100\nM30\n";

// The manual's groove without offset: corners, and the arcs about the centres that it gives.
TEST(Axes, ChordsCountAgainstTheBlockLimit) {
  ControlSettings settings = machineWith({rotary("C", 4)});
  settings.block_limit = 5000;
  const Outcome out =
      runOf("G0 Y40 Z60\nWHILE[1 EQ 1] DO1\nG1 X10 Y10 C3600 F10000\nX0 Y40 C0\nEND1\nM30\n", settings);
  EXPECT_EQ(out.summary.end, ProgramEnd::kBlockLimit);
  EXPECT_GT(out.summary.motions, 5000u);
  EXPECT_LT(out.summary.blocks, 10u);
}

TEST(Axes, GrooveOnACylinder) {
  ControlSettings settings = machineWith({rotary("A", 4)});
  const Outcome r = runOf(kGroove, settings);
  ASSERT_EQ(r.error, "");
  struct Leg {
    std::int64_t block;
    Vec2 end, center;
    double radius;
  };
  const std::vector<Leg> legs{
      {70, {15.0011, -10}, {}, 0},     {80, {45.0033, -40}, {15.0033, -40}, 30},
      {90, {45.0033, -60}, {}, 0},     {100, {60.0044, -75}, {60.0033, -60}, 15},
      {110, {90.0066, -75}, {}, 0},    {120, {120.0088, -57.5}, {89.6972, -40.0014}, 35},
      {130, {137.5101, -27.5}, {}, 0}, {140, {167.5123, -10}, {167.8218, -44.9986}, 35},
      {150, {180.0133, -10}, {}, 0}};
  for (const Leg& leg : legs) {
    Vec2 end = Vec2::Zero();
    double worst = 0;
    for (const Motion& m : r.path.motions) {
      if (m.source.block != leg.block) continue;
      ASSERT_GE(m.axis, 0);
      const AxisSweep& sweep = r.path.axes[static_cast<std::size_t>(m.axis)];
      end = unrolled(m.to, 28.65, sweep.rotary[0].to);
      EXPECT_NEAR(std::hypot(m.to.y(), m.to.z()), 25.65, 1e-9);
      // The tool looks at the cylinder's axis.
      EXPECT_LT((Vec3(0, m.to.y(), m.to.z()).normalized() - sweep.to).norm(), 1e-9);
      if (leg.radius > 0) worst = std::max(worst, std::abs((end - leg.center).norm() - leg.radius));
    }
    EXPECT_LT((end - leg.end).norm(), 2e-4) << leg.block;
    EXPECT_LT(worst, 2e-4) << leg.block;
  }
  // The feed counts on the surface: the arc of N80 is 90.004 degrees of radius 30.
  double n80 = 0;
  for (const Motion& m : r.path.motions) n80 += m.source.block == 80 ? m.time_s : 0;
  EXPECT_NEAR(n80, 60 * 47.1260 / 500, 1e-3);
}

/// A quarter circle on a cylinder of radius 20, R10, from (0, 0) to 10 mm along both ways of its surface.
struct Quarter {
  const char* plane;  ///< code of the plane
  char linear, rotary;
  bool linear_first;  ///< the linear axis is the first of the plane
};

// The manual's table of planes: the rotary axis stands for the plane's other axis, and clockwise turns from
// the second axis to the first.
TEST(Axes, PlanesOfTheCylinder) {
  for (const Quarter& q :
       {Quarter{"G17", 'X', 'A', true}, Quarter{"G18", 'X', 'A', false}, Quarter{"G17", 'Y', 'B', false},
        Quarter{"G19", 'Y', 'B', true}, Quarter{"G18", 'Z', 'C', true}, Quarter{"G19", 'Z', 'C', false}}) {
    const std::string linear(1, q.linear), axis(1, q.rotary);
    const std::string place = q.linear == 'Z' ? "G0 X20\n" : "G0 Z20\n";
    const std::string words = linear + "10 " + axis + fmt::format("{:.9f}", radToDeg(0.5)) + " R10";
    for (const bool clockwise : {true, false}) {
      const std::string text = place + q.plane + " " + linear + "0 " + axis + "0\nG7.1 " + axis + "20\n" +
                               (clockwise ? "G2 " : "G3 ") + words + " F100\nG7.1 " + axis + "0\nM30\n";
      const Outcome r = runOf(text, machineWith({rotary(axis, 4)}));
      ASSERT_EQ(r.error, "") << text;
      // Clockwise from (0, 0) to (10, 10) in (first, second) the centre is at (10, 0), else at (0, 10).
      const double first = clockwise ? 10 : 0, second = clockwise ? 0 : 10;
      const Vec2 center = q.linear_first ? Vec2(first, second) : Vec2(second, first);  // (linear, unrolled)
      int points = 0;
      for (const Motion& m : r.path.motions) {
        if (m.kind != MotionKind::kFeed) continue;
        ASSERT_GE(m.axis, 0);
        const double angle = r.path.axes[static_cast<std::size_t>(m.axis)].rotary[0].to;
        const Vec2 p(m.to[q.linear - 'X'], 20 * degToRad(angle));
        EXPECT_NEAR((p - center).norm(), 10, 1e-4) << text;
        ++points;
      }
      EXPECT_GT(points, 10);
      EXPECT_NEAR(r.summary.cutting_s, 60 * 5 * kPi / 100, 1e-3) << text;
    }
  }
}

// With the tool's radius the path keeps that distance from the programmed one, on the unrolled surface.
TEST(Axes, GrooveOnACylinderWithOffset) {
  ControlSettings settings = machineWith({rotary("A", 4)});
  settings.radius_offsets[1] = {4.0, 0.0};
  const Outcome plain = runOf(kGroove, machineWith({rotary("A", 4)}));
  const Outcome offset = runOf(kGroove, settings);
  ASSERT_EQ(offset.error, "");
  std::vector<std::pair<Vec2, Vec2>> contour;
  const auto ends = [](const Outcome& r, const Motion& m) {
    const RotaryPosition& a = r.path.axes[static_cast<std::size_t>(m.axis)].rotary[0];
    return std::pair(unrolled(m.from, 28.65, a.from), unrolled(m.to, 28.65, a.to));
  };
  for (const Motion& m : plain.path.motions) {
    if (m.source.block >= 70 && m.source.block <= 150) contour.push_back(ends(plain, m));
  }
  int points = 0;
  for (const Motion& m : offset.path.motions) {
    if (m.source.block < 80 || m.source.block > 140) continue;
    const Vec2 p = ends(offset, m).second;
    double nearest = 1e9;
    for (const auto& [a, b] : contour) {
      const Vec2 d = b - a;
      const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      nearest = std::min(nearest, (a + t * d - p).norm());
    }
    EXPECT_NEAR(nearest, 4.0, 5e-4) << m.source.block;
    ++points;
  }
  EXPECT_GT(points, 100);
}

// The machine's axes during G12.1: X is the distance from the centre, C the angle; a table that turns about
// another point than the program counts on cuts another shape, and a warning says so.
TEST(Axes, FaceBesideTheCentre) {
  ControlSettings settings = machineWith({rotary("C", 4)});
  settings.axes[0].center = Vec3(0, 1, 0);
  const Outcome r = runOf("G17 G0 X20 C0\nG12.1\nG1 C20 F500\nX-20\nG13.1\nM30\n", settings);
  ASSERT_EQ(r.error, "");
  EXPECT_EQ(r.summary.warnings, 1);
  const auto at = [](double t) {
    const Vec2 p(20, 20 * t);
    return turned(Vec3(p.norm(), 0, 0), {0, 0, 1}, {0, 1, 0}, radToDeg(std::atan2(p.y(), p.x())));
  };
  EXPECT_LT(deviation(r.path, 3, at), 3e-4);
}

}  // namespace
}  // namespace proveout
