// Pockets and engraving of Haas mills: closed forms, and what must hold for every path.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/nc/services/outline_pocket.h"
#include "core/nc/services/stroke_font.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

/// D1 has that radius; the tool starts at (0, 0, 0); F100, mm.
IsoRun pocketRun(const std::string& text, double radius) {
  ControlSettings settings = runAtZero({{"flavour", 1}, {"rapid", 1}});
  settings.radius_offsets[1] = {radius, 0.0};
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n", settings};
}

/// Points of the feed motions below that level, a tenth of a millimetre apart.
std::vector<Vec3> pointsOf(const Toolpath& path, double level) {
  std::vector<Vec3> points;
  Vec3 from = Vec3::Zero();
  for (std::size_t k = 0; k < path.motions.size(); ++k) {
    const Motion& m = path.motions[k];
    const bool below = from.z() <= level + 1e-9 && m.to.z() <= level + 1e-9;
    double length = (m.to - from).norm();
    if (m.arc >= 0) {
      const ArcGeometry& arc = path.arcs[static_cast<std::size_t>(m.arc)];
      length = std::abs(arc.sweep_rad) * (from - arc.center).norm();
    }
    const int pieces = static_cast<int>(std::ceil(length / 0.1)) + 1;
    for (int i = 0; below && i <= pieces; ++i)
      points.push_back(path.pointAt(m, static_cast<double>(i) / pieces));
    from = m.to;
  }
  return points;
}

double farthest(const std::vector<Vec3>& points) {
  double far = 0.0;
  for (const Vec3& p : points) far = std::max(far, p.head<2>().norm());
  return far;
}
double nearestTo(const std::vector<Vec3>& points, const Vec2& p) {
  double near = 1e9;
  for (const Vec3& q : points) near = std::min(near, (q.head<2>() - p).norm());
  return near;
}

// haas-18-G13, acceptance 51
TEST(HaasPockets, RoundPocketWithOneCircle) {
  const IsoRun run = pocketRun("G13 I10. Z-2. D1", 3.0);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"F 0 0 -2", "A 7 0 -2 c 3.5 0 -2 180", "A 7 0 -2 c 0 0 -2 360",
                                  "A 0 0 -2 c 3.5 0 -2 180"}));
}

// haas-18-G12
TEST(HaasPockets, RoundPocketClockwise) {
  EXPECT_EQ(
      pocketRun("G12 I10. Z-2. D1", 3.0).motions(),
      (Lines{"F 0 0 -2", "A 7 0 -2 c 3.5 0 -2 -180", "A 7 0 -2 c 0 0 -2 -360", "A 0 0 -2 c 3.5 0 -2 -180"}));
}

// haas-18-G13: the worked example; centre paths 2, 7, 12, 16
TEST(HaasPockets, RoundPocketWithSeveralCircles) {
  const IsoRun run = pocketRun("G13 I6. K20. Q5. Z-3. D1", 4.0);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(),
            (Lines{"F 0 0 -3", "A 2 0 -3 c 1 0 -3 180", "A 2 0 -3 c 0 0 -3 360", "A -7 0 -3 c -2.5 0 -3 180",
                   "A -7 0 -3 c 0 0 -3 360", "A 12 0 -3 c 2.5 0 -3 180", "A 12 0 -3 c 0 0 -3 360",
                   "A -16 0 -3 c -2 0 -3 180", "A -16 0 -3 c 0 0 -3 360", "A 0 0 -3 c -8 0 -3 180"}));
  // The wall is reached all round, and the tool is never nearer to it than its radius.
  const std::vector<Vec3> points = pointsOf(run.path, -3.0);
  EXPECT_NEAR(farthest(points) + 4.0, 20.0, 1e-4);
  for (int deg = 0; deg < 360; ++deg) {
    const double a = degToRad(deg);
    EXPECT_LE(nearestTo(points, 20.0 * Vec2(std::cos(a), std::sin(a))), 4.001);
    for (const double r : {1.0, 5.0, 9.0, 14.0, 18.0})
      EXPECT_LE(nearestTo(points, r * Vec2(std::cos(a), std::sin(a))), 4.0);
  }
}

TEST(HaasPockets, RoundPocketInSteps) {
  EXPECT_EQ(pocketRun("G91 G13 I10. Z-2. D1 L2\nG90 G0 Z5.", 3.0).motions(),
            (Lines{"F 0 0 -2", "A 7 0 -2 c 3.5 0 -2 180", "A 7 0 -2 c 0 0 -2 360", "A 0 0 -2 c 3.5 0 -2 180",
                   "F 0 0 -4", "A 7 0 -4 c 3.5 0 -4 180", "A 7 0 -4 c 0 0 -4 360", "A 0 0 -4 c 3.5 0 -4 180",
                   "R 0 0 5"}));
}

TEST(HaasPockets, RoundPocketWithoutRadiusIsTheCentrePath) {
  EXPECT_EQ(pocketRun("G13 I10. Z-2. D0", 3.0).motions()[1], "A 10 0 -2 c 5 0 -2 180");
}

TEST(HaasPockets, RefusesRoundPocketsThatCannotBe) {
  EXPECT_EQ(pocketRun("G13 I3. Z-2. D1", 3.0).error(), "fanuc-pocket-size");
  EXPECT_EQ(pocketRun("G13 I10. K8. Q1. Z-2. D1", 3.0).error(), "fanuc-pocket-size");
  EXPECT_EQ(pocketRun("G13 I10. K20. Z-2. D1", 3.0).error(), "fanuc-pocket-size");
  EXPECT_EQ(pocketRun("G13 I10. K20. Q0.0001 Z-2. D1", 3.0).error(), "fanuc-pocket-size");
  EXPECT_EQ(pocketRun("G13 Z-2. D1", 3.0).error(), "fanuc-missing-data");
  EXPECT_EQ(pocketRun("G18 G13 I10. Z-2. D1", 3.0).error(), "fanuc-028");
}

/// Distance of a point from the walls of the square of 40 about (20, 20).
double fromSquare(const Vec3& p) {
  return std::min(std::min(p.x(), 40.0 - p.x()), std::min(p.y(), 40.0 - p.y()));
}

constexpr const char* kSquare = "\nM30\nO20\nG1 X0 Y20.\nY0\nX40.\nY40.\nX0\nY20.\nM99";

// haas-18-G150: outline of 40 by 40 that turns left
TEST(HaasPockets, PocketOfAnOutline) {
  const IsoRun run = pocketRun(
      std::string("G0 X20. Y20. Z5.\nG150 G41 D1 P20 X20. Y20. Z-4. R1. Q2.5 I4. K0.5 F200.\nG40 X20.") +
          kSquare,
      3.0);
  EXPECT_EQ(run.error(), "") << run.message();
  double low = 0.0;
  for (const Motion& m : run.path.motions) low = std::min(low, m.to.z());
  EXPECT_EQ(low, -4.0);
  for (const double level : {-1.5, -4.0}) {
    const std::vector<Vec3> points = pointsOf(run.path, level);
    ASSERT_FALSE(points.empty());
    const double allowance = level == -4.0 ? 0.0 : 0.5;
    double least = 1e9;
    for (const Vec3& p : points) least = std::min(least, fromSquare(p));
    EXPECT_NEAR(least, 3.0 + (level == -4.0 ? 0.0 : 0.0), level == -4.0 ? 1e-3 : 0.6);
    EXPECT_GE(least, 3.0 - 1e-3);
    // What the tool reaches: everything but the corners of its radius, and the allowance above the bottom.
    for (double x = 1.0; x < 40.0; x += 1.0) {
      for (double y = 1.0; y < 40.0; y += 1.0) {
        const bool corner = (x < 4.0 || x > 36.0) && (y < 4.0 || y > 36.0);
        if (corner || fromSquare(Vec3(x, y, 0)) < allowance) continue;
        EXPECT_LE(nearestTo(points, Vec2(x, y)), 3.01) << x << " " << y;
      }
    }
  }
}

TEST(HaasPockets, RefusesOutlinesThatCannotBe) {
  const auto error = [](const std::string& words, const std::string& outline, double radius = 3.0) {
    return pocketRun("G0 X20. Y20. Z5.\nG150 " + words + "\nM30\nO20\n" + outline + "\nM99", radius).error();
  };
  const std::string square = "G1 X0 Y20.\nY0\nX40.\nY40.\nX0\nY20.";
  const std::string good = "G41 D1 P20 Z-4. R1. Q2. I4.";
  EXPECT_EQ(error(good, square), "");
  EXPECT_EQ(error("G42 D1 P20 Z-4. R1. Q2. I4.", square), "fanuc-pocket-side");
  EXPECT_EQ(error("D1 P20 Z-4. R1. Q2. I4.", square), "fanuc-pocket-side");
  EXPECT_EQ(error(good, "G1 X0 Y20.\nY0\nX40.\nY40.\nX0"), "fanuc-pocket-outline");
  EXPECT_EQ(error(good, square, 25.0), "fanuc-pocket-outline");
  EXPECT_EQ(error("G41 D1 P20 X1. Z-4. R1. Q2. I4.", square), "fanuc-pocket-outline");
  EXPECT_EQ(error("G41 D1 P20 Z4. R1. Q2. I4.", square), "fanuc-pocket-size");
  EXPECT_EQ(error("G41 D1 P20 Z-4. R1. Q2.", square), "fanuc-pocket-size");
  EXPECT_EQ(error("G41 D1 P20 Z-4. R1. Q2. I4. J4.", square), "fanuc-pocket-size");
  EXPECT_EQ(error("G41 D1 P20 Z-4. R1. I4.", square), "fanuc-missing-data");
  EXPECT_EQ(error("G41 D1 P21 Z-4. R1. Q2. I4.", square), "fanuc-076");
  EXPECT_EQ(error(good, "#1=5"), "fanuc-pocket-outline");
  std::string many = "G1 X0 Y20.";
  for (int k = 0; k < 50; ++k) many += "\nG91 Y-0.1\nG90";
  EXPECT_EQ(error(good, many), "fanuc-pocket-outline");
}

/// Random star-shaped outlines, lanes along both axes: the tool stays off the wall and runs along all of it.
TEST(HaasPockets, WaysKeepOffEveryOutline) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(25.0, 60.0), turn(-0.2, 0.2);
  for (int k = 0; k < 40; ++k) {
    OutlinePocket pocket;
    std::vector<Vec2> corners;
    const int count = 5 + k % 7;
    for (int i = 0; i < count; ++i) {
      const double a = 2.0 * kPi * i / count + turn(random);
      corners.push_back(radius(random) * Vec2(std::cos(a), std::sin(a)));
    }
    if (k % 2 == 0) std::reverse(corners.begin(), corners.end());
    for (int i = 0; i < count; ++i)
      pocket.outline.push_back(lineElement(corners[static_cast<std::size_t>(i)],
                                           corners[static_cast<std::size_t>((i + 1) % count)]));
    pocket.tool_radius = 2.0;
    pocket.allowance = k % 3 == 0 ? 0.0 : 0.4;
    pocket.step = 3.0;
    pocket.along_v = k % 2 == 1;
    const auto ways = outlinePocketWays(pocket);
    ASSERT_TRUE(ways.ok()) << k << " " << ways.error().message;
    PlaneContour path;
    Vec2 at = pocket.start;
    for (const auto* moves : {&ways.value().rough, &ways.value().finish}) {
      for (const PocketMove& m : *moves) {
        if (m.kind == PocketMove::Kind::kLine) path.push_back(lineElement(at, m.to));
        if (m.kind == PocketMove::Kind::kArc) path.push_back(arcElement(m.center, at, m.to, m.sweep_rad));
        at = m.to;
      }
    }
    double least = 1e9;
    std::vector<Vec2> points;
    for (const ContourElement& e : path) {
      for (int i = 0; i <= 40; ++i) {
        const Vec2 p = pointOn(e, i / 40.0);
        points.push_back(p);
        for (const ContourElement& wall : pocket.outline) least = std::min(least, distanceFrom(wall, p));
      }
    }
    EXPECT_NEAR(least, 2.0, 1e-3) << k;
    for (const ContourElement& wall : pocket.outline) {
      const Vec2 middle = pointOn(wall, 0.5);
      double near = 1e9;
      for (const Vec2& p : points) near = std::min(near, (p - middle).norm());
      EXPECT_LE(near, 2.2) << k;
    }
  }
}

// haas-18-G47: an L of height 6 at (10, 5), depth -0.2, level R 1
TEST(HaasPockets, EngravesStrokes) {
  const IsoRun run = pocketRun("G47 P0 X10. Y5. Z-.2 R1. J6. E50. F100. (L)", 3.0);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 10 5 0", "R 10 5 1", "R 10 11 1", "F 10 11 -0.2", "F 10 5 -0.2",
                                  "F 14 5 -0.2", "R 14 5 1"}));
  ASSERT_EQ(run.path.motions.size(), 7u);
  EXPECT_NEAR(run.path.motions[3].time_s, 1.2 / 50.0 * 60.0, 1e-9);
  EXPECT_NEAR(run.path.motions[4].time_s, 6.0 / 100.0 * 60.0, 1e-9);
  EXPECT_TRUE(run.tells("fanuc-path-not-proven"));
  // Turned by 90 degrees.
  EXPECT_EQ(pocketRun("G47 P0 X10. Y5. Z-.2 R1. J6. I90. (L)", 3.0).motions()[2], "R 4 5 1");
  // A serial number, and a sign.
  EXPECT_EQ(pocketRun("G47 P1 X0 Y0 Z-.2 R1. J6. (SN 7)", 3.0).motions().size(), 6u);
  EXPECT_EQ(pocketRun("G47 P45 X0 Y0 Z-.2 R1. J6.", 3.0).motions().size(), 5u);
  EXPECT_EQ(pocketRun("G47 P0 X0 Y0 Z-.2 R1. J6.", 3.0).error(), "fanuc-engraving");
}

TEST(HaasPockets, AllLettersHaveStrokes) {
  for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+.,:/=#")) {
    char unknown = '\0';
    const auto strokes = strokesOf(std::string(1, c), &unknown);
    EXPECT_EQ(unknown, '\0') << c;
    ASSERT_FALSE(strokes.empty()) << c;
    for (const Stroke& s : strokes) {
      EXPECT_GE(s.size(), 2u);
      for (const Vec2& p : s) EXPECT_TRUE(p.x() >= 0 && p.x() <= 0.7 && p.y() >= 0 && p.y() <= 1.0) << c;
    }
  }
}

}  // namespace
}  // namespace proveout::test
