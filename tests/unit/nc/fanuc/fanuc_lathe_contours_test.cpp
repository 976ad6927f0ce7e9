// Cycles over a contour: G70 to G73 (section 16), against the closed forms printed there and by brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/lathe/roughing_passes.h"
#include "core/nc/services/contour/contour_profile.h"
#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

const std::string kShaft = "N10 G0 X20.\nG1 Z-20. F.1\nX30. Z-30.\nZ-40.\nN20 X44.\n";

const Lines kShaftRoughing{"R 44.4 2.1",   "R 40.4 2.1",   "F 40.4 -39.9", "R 42.4 -38.9", "R 42.4 2.1",
                           "R 36.4 2.1",   "F 36.4 -39.9", "R 38.4 -38.9", "R 38.4 2.1",   "R 32.4 2.1",
                           "F 32.4 -39.9", "R 34.4 -38.9", "R 34.4 2.1",   "R 28.4 2.1",   "F 28.4 -27.9",
                           "R 30.4 -26.9", "R 30.4 2.1",   "R 24.4 2.1",   "F 24.4 -23.9", "R 26.4 -22.9",
                           "R 26.4 2.1",   "R 20.4 2.1",   "F 20.4 -19.9", "F 30.4 -29.9", "F 30.4 -39.9",
                           "F 44.4 -39.9", "R 44 2"};

// fan-16-G71: acceptance row 42
TEST(FanucLatheContours, RoughTurning) {
  const std::string text = "G71 U2. R1.\nG71 P10 Q20 U.4 W.1 F.3\n" + kShaft + "G0 X50.\nM30\n";
  Lines expected = kShaftRoughing;
  expected.push_back("R 50 2");
  EXPECT_EQ(turned(text, latheAt(44, 2)), expected);
}

// fan-16-G71one haas-18-latheG71
TEST(FanucLatheContours, RoughTurningInOneLine) {
  for (const double flavour : {0.0, 1.0})
    EXPECT_EQ(turned("G71 P10 Q20 U.4 W.1 D2. F.3\n" + kShaft + "M30\n",
                     latheAt(44, 2, {{"flavour", flavour}, {"g71_escape", 1.0}})),
              kShaftRoughing);
  EXPECT_EQ(
      turned("G71 P10 Q20 U.4 W.1 D2000 F.3\n" + kShaft + "M30\n", latheAt(44, 2, {{"g71_escape", 1.0}})),
      kShaftRoughing);
  // Inch: C (2.11, 0.105), levels X 2.01, 1.91, ...
  const IsoRun inch = lathe(
      "G20\nG71 P10 Q20 U0.01 W0.005 D0.05 F0.010\nN10 G0 X1.\nG1 Z-1. F.005\nN20 X2.1\nG70 P10 Q20 "
      "F0.005\nM30\n",
      latheAt(2.1 * 25.4, 0.1 * 25.4));
  EXPECT_EQ(inch.error(), "") << inch.message();
  std::vector<double> levels;
  for (const Motion& m : inch.path.motions) {
    if (m.kind != MotionKind::kRapid && std::abs(m.to.x() - m.from.x()) < 1e-9 && levels.size() < 3)
      levels.push_back(2.0 * m.to.x() / 25.4);
  }
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_NEAR(levels[0], 2.01, 1e-9);
  EXPECT_NEAR(levels[1], 1.91, 1e-9);
  EXPECT_NEAR(levels[2], 1.81, 1e-9);
}

// fan-16-G71II: acceptance row 62
TEST(FanucLatheContours, PocketsOfTypeTwo) {
  const std::string contour =
      "N10 G0 X30. Z0\nG1 Z-10. F.1\nX20. Z-15.\nZ-25.\nX30. Z-30.\nZ-40.\nN20 X44.\n";
  const Lines all = turned("G71 U2. R1.\nG71 P10 Q20 U0 W0 F.3\n" + contour + "M30\n", latheAt(44, 2));
  // The worked levels in their order: 40, 36, 32 to the wall, then the pocket down its falling flank.
  const Lines wanted{"F 40 -40", "F 36 -40", "F 32 -40", "F 28 -11", "F 28 -29",
                     "F 24 -13", "F 24 -27", "F 20 -15", "F 20 -25"};
  std::size_t k = 0;
  for (const std::string& line : all)
    if (k < wanted.size() && line == wanted[k]) ++k;
  EXPECT_EQ(k, wanted.size()) << (k < wanted.size() ? wanted[k] : "");
  const Lines last(all.end() - 8, all.end());
  EXPECT_EQ(last, (Lines{"R 30 0", "F 30 -10", "F 20 -15", "F 20 -25", "F 30 -30", "F 30 -40", "F 44 -40",
                         "R 44 2"}));
}

// fan-16-G72 haas-18-latheG72: acceptance row 62
TEST(FanucLatheContours, RoughFacing) {
  const std::string contour = "N10 G0 Z-20.\nG1 X30. F.1\nZ-10.\nX20.\nN20 Z2.\n";
  const Lines expected{"R 44.4 2.1",   "R 44.4 -1.4",  "F 20.4 -1.4",  "R 22.4 -0.4",  "R 44.4 -0.4",
                       "R 44.4 -4.9",  "F 20.4 -4.9",  "R 22.4 -3.9",  "R 44.4 -3.9",  "R 44.4 -8.4",
                       "F 20.4 -8.4",  "R 22.4 -7.4",  "R 44.4 -7.4",  "R 44.4 -11.9", "F 30.4 -11.9",
                       "R 32.4 -10.9", "R 44.4 -10.9", "R 44.4 -15.4", "F 30.4 -15.4", "R 32.4 -14.4",
                       "R 44.4 -14.4", "R 44.4 -18.9", "F 30.4 -18.9", "R 32.4 -17.9", "R 44.4 -17.9",
                       "R 44.4 -19.9", "F 30.4 -19.9", "F 30.4 -9.9",  "F 20.4 -9.9",  "F 20.4 2.1",
                       "R 44 2"};
  EXPECT_EQ(turned("G72 W3.5 R1.\nG72 P10 Q20 U.4 W.1 F.3\n" + contour + "M30\n", latheAt(44, 2)), expected);
  EXPECT_EQ(turned("G72 P10 Q20 U.4 W.1 D3.5 F.3\n" + contour + "M30\n",
                   latheAt(44, 2, {{"flavour", 1}, {"g71_escape", 1.0}})),
            expected);
}

TEST(FanucLatheContours, RoughBoring) {
  // A at the bore (20, 2), du -0.4: levels X 19.6 + 2 k d.
  const Lines all =
      turned("G71 U2. R1.\nG71 P10 Q20 U-.4 W.1 F.3\nN10 G0 X40.\nG1 Z-20. F.1\nX30.\nZ-30.\nN20 X20.\nM30\n",
             latheAt(20, 2));
  const Lines first(all.begin(), all.begin() + 5);
  EXPECT_EQ(first, (Lines{"R 19.6 2.1", "R 23.6 2.1", "F 23.6 -29.9", "R 21.6 -28.9", "R 21.6 2.1"}));
  const Lines last(all.end() - 6, all.end());
  EXPECT_EQ(last,
            (Lines{"R 39.6 2.1", "F 39.6 -19.9", "F 29.6 -19.9", "F 29.6 -29.9", "F 19.6 -29.9", "R 20 2"}));
}

// fan-16-G73 haas-18-latheG73: acceptance row 44
TEST(FanucLatheContours, Pattern) {
  const std::string contour = "N10 G0 X20. Z0\nG1 Z-20. F.1\nN20 X40. Z-30.\n";
  Lines expected;
  for (const auto& [x, z] : std::vector<std::pair<double, double>>{{5, 2}, {2.5, 1}, {0, 0}}) {
    const auto point = [&, dx = x, dz = z](const char* kind, double px, double pz) {
      expected.push_back(
          fmt::format("{} {} {}", kind, IsoRun::number(px + 0.4 + 2 * dx), IsoRun::number(pz + 0.1 + dz)));
    };
    point("R", 50, 5);
    point("R", 20, 0);
    point("F", 20, -20);
    point("F", 40, -30);
  }
  expected.push_back("R 50 5");
  EXPECT_EQ(turned("G73 U5. W2. R3\nG73 P10 Q20 U.4 W.1 F.3\n" + contour + "M30\n", latheAt(50, 5)),
            expected);
  EXPECT_EQ(
      turned("G73 P10 Q20 U.4 W.1 I5. K2. D3 F.3\n" + contour + "M30\n", latheAt(50, 5, {{"flavour", 1}})),
      expected);
}

// fan-16-G70
TEST(FanucLatheContours, FinishRunsTheContourWithItsOwnWords) {
  const IsoRun run = lathe(
      "T0101\nG97 S500 M3\nG0 X50. Z5.\nG71 U5. R1.\nG71 P10 Q20 U.4 W.1 F.5\nN10 G42 G0 X20.\nG1 Z-20. F.2\n"
      "X30. ,C2. F.1\nZ-40.\nN20 G40 X50.\nG70 P10 Q20 F.4\nG0 Z20.\nM30\n",
      latheAt(60, 10, {{"nose_radius.1", 0.8}, {"tip.1", 3}}));
  EXPECT_EQ(run.error(), "") << run.message();
  // Feeds of the contour hold for G70 alone: roughing goes with 0.5.
  std::vector<double> feeds;
  for (const Motion& m : run.path.motions)
    if (m.kind == MotionKind::kFeed) feeds.push_back(m.feed / 500.0);
  ASSERT_GE(feeds.size(), 6U);
  EXPECT_NEAR(feeds.front(), 0.5, 1e-9);
  EXPECT_NEAR(feeds[feeds.size() - 5], 0.2, 1e-9);
  EXPECT_NEAR(feeds.back(), 0.1, 1e-9);
  const auto& m = run.path.motions;
  EXPECT_TRUE(m[m.size() - 4].compensated);
  EXPECT_NEAR(m[m.size() - 2].to.x(), 25.0, 1e-9);  // back to where G70 began
  EXPECT_NEAR(m[m.size() - 2].to.z(), 5.0, 1e-9);
  EXPECT_NEAR(m.back().to.z(), 20.0, 1e-9);
}

TEST(FanucLatheContours, VariablesAndSubprogramsAroundContours) {
  // The contour of a program that M98 calls is searched in that program.
  EXPECT_EQ(turned("O1\n#1=20.\nM98 P2\nM30\nO2\nG71 U10. R1.\nG71 P10 Q20 U0 W0 F.3\nN10 G0 X#1\n#2=-40.\n"
                   "G1 Z#2 F.1\nN20 X44.\nM99\n",
                   latheAt(44, 2)),
            (Lines{"R 24 2", "F 24 -40", "R 26 -39", "R 26 2", "R 20 2", "F 20 -40", "F 44 -40", "R 44 2"}));
}

/// Words without a point in least increments: the same passes.
TEST(FanucLatheContours, IncrementsWithoutPoints) {
  EXPECT_EQ(
      turned("G71 U2000 R1000\nG71 P10 Q20 U400 W100 F.3\nN10 G0 X20000\nG1 Z-20000 F.1\nX30000 Z-30000\n"
             "Z-40000\nN20 X44000\nM30\n",
             latheAt(44, 2, {{"decimal", 1}})),
      kShaftRoughing);
  EXPECT_EQ(turned("G73 U5000 W2000 R3\nG73 P10 Q20 F.3\nN10 G0 X20000 Z0\nN20 G1 X40000 Z-30000 F.1\nM30\n",
                   latheAt(50, 5, {{"decimal", 1}})),
            turned("G73 U5. W2. R3\nG73 P10 Q20 F.3\nN10 G0 X20. Z0\nN20 G1 X40. Z-30. F.1\nM30\n",
                   latheAt(50, 5)));
}

/// Compensation that is on before a roughing cycle is not in its levels, and is there again behind it.
TEST(FanucLatheContours, RoughingIsNotCompensated) {
  const std::string text =
      "T0101\nG42 G1 X44. Z2. F.3\nG71 U2. R1.\nG71 P10 Q20 U.4 W.1 F.3\n" + kShaft + "G40 G0 X60.\nM30\n";
  const Lines all = turned(text, latheAt(50, 2, {{"nose_radius.1", 0.8}, {"tip.1", 3}}));
  EXPECT_NE(std::search(all.begin(), all.end(), kShaftRoughing.begin() + 1, kShaftRoughing.end()), all.end());
}

// fan-16-errors
TEST(FanucLatheContours, Errors) {
  const auto error = [](const std::string& text) { return lathe(text + "M30\n", latheAt(44, 2)).error(); };
  const std::string c = kShaft;
  EXPECT_EQ(error("G71 P10 U.4 F.3\n" + c), "fanuc-061");
  EXPECT_EQ(error("G71 U0\nG71 P10 Q20 F.3\n" + c), "fanuc-062");
  EXPECT_EQ(error("G71 P10 Q20 D0 F.3\n" + c), "fanuc-062");
  EXPECT_EQ(error("G73 U1. R0\nG73 P10 Q20 F.3\n" + c), "fanuc-062");
  EXPECT_EQ(error("G71 P10 Q25 F.3\n" + c), "fanuc-063");
  EXPECT_EQ(error("G70 P11 Q20 F.3\n" + c), "fanuc-063");
  EXPECT_EQ(error("G71 U2.\nG71 P20 Q10 F.3\n" + c), "fanuc-063");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 X20.\nG1 Z-20.\nX30.\nX25. Z-30.\nN20 X44.\n"), "fanuc-064");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 X20. W0\nG1 Z-20.\nX30. Z-15.\nN20 X44.\n"), "fanuc-064");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 X20.\nG1 Z-20.\nN20 X44.\n"), "fanuc-065");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 Z1.\nG1 Z-20.\nN20 X44.\n"), "fanuc-065");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 X20.\nG1 Z-20.\nM98 P1\nN20 X44.\n"), "fanuc-066");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 X20.\nG28 U0\nG1 Z-20.\nN20 X44.\n"), "fanuc-066");
  EXPECT_EQ(error("G71 P10 Q20 F.3\nN10 G0 X20.\nG1 Z-20.\nN20 X44. ,C1.\n"), "fanuc-069");
}

/// Random contours that fall along X from the start: levels and heights of the moves by themselves.
class RandomContour {
 public:
  explicit RandomContour(std::uint32_t seed) : seed_(seed) {}
  double number(double low, double high) {
    seed_ = seed_ * 1664525u + 1013904223u;
    return low + (high - low) * (seed_ >> 8) / double(1u << 24);
  }
  /// (z, x) from (0, x0) towards -Z; `pockets`: X may fall again.
  PlaneContour make(bool pockets) {
    PlaneContour all;
    Vec2 p(0.0, number(5.0, 12.0));
    const int n = 3 + static_cast<int>(number(0.0, 8.0));
    bool wall = true;  // two in a row would leave a slit without width
    for (int k = 0; k < n; ++k) {
      wall = !wall && k + 1 < n && number(0.0, 1.0) < 0.2;
      Vec2 to(p.x() - (wall ? 0.0 : number(0.5, 8.0)), p.y());
      if (number(0.0, 1.0) < 0.7 || wall) to.y() += number(pockets ? -4.0 : 0.1, 5.0);
      to.y() = std::clamp(to.y(), 3.0, 29.0);
      if ((to - p).norm() < 1e-3) continue;
      all.push_back(lineElement(p, to));
      p = to;
    }
    all.push_back(lineElement(p, Vec2(p.x(), 30.0)));
    return all;
  }

 private:
  std::uint32_t seed_;
};

/// Radius of the contour at a Z, the largest where it is a wall.
double radiusAt(const PlaneContour& contour, double z) {
  double radius = 0.0;
  for (const ContourElement& e : contour) {
    const double low = std::min(e.from.x(), e.to.x()), high = std::max(e.from.x(), e.to.x());
    if (z < low - 1e-9 || z > high + 1e-9) continue;
    if (high - low < 1e-9) {
      radius = std::max({radius, e.from.y(), e.to.y()});
    } else {
      radius =
          std::max(radius, e.from.y() + (z - e.from.x()) / (e.to.x() - e.from.x()) * (e.to.y() - e.from.y()));
    }
  }
  return radius;
}

/// The lowest point of each column of a grid along Z that moves have cut, radii.
struct CutColumns {
  std::vector<double> z, cut;
  CutColumns(double from, double to, double start) {
    for (double at = from + 0.013; at < to; at += 0.05) {
      z.push_back(at);
      cut.push_back(start);
    }
  }
  /// The move's own height over each column; false: a rapid is below what has been cut.
  bool take(const ContourMove& move) {
    const Vec2 &a = move.element.from, &b = move.element.to;
    bool clear = true;
    for (std::size_t k = 0; k < z.size(); ++k) {
      const double low = std::min(a.x(), b.x()), high = std::max(a.x(), b.x());
      if (z[k] < low || z[k] > high) continue;
      const double share = high - low < 1e-12 ? 0.0 : (z[k] - a.x()) / (b.x() - a.x());
      const double height = high - low < 1e-12 ? std::min(a.y(), b.y()) : a.y() + share * (b.y() - a.y());
      if (move.speed == ContourMove::Speed::kFeed) {
        cut[k] = std::min(cut[k], height);
      } else {
        clear = clear && height > cut[k] - 1e-4;
      }
    }
    return clear;
  }
};

void checkLevels(bool pockets, std::uint32_t seed) {
  RandomContour random(seed);
  const PlaneContour contour = random.make(pockets);
  nc::LevelRules rules;
  rules.from = Vec2(2.0, 31.0);
  rules.first = 31.0;
  rules.depth = random.number(0.7, 3.0);
  rules.escape = random.number(0.1, 1.0);
  rules.pockets = pockets;
  const auto moves = nc::levelPasses(contour, rules);
  const double end = contour.back().to.x();
  CutColumns columns(end, 2.0, 31.0);
  Vec2 before = rules.from;
  for (const ContourMove& move : moves) {
    ASSERT_LT((move.element.from - before).norm(), 1e-9);
    before = move.element.to;
    EXPECT_TRUE(columns.take(move)) << "rapid through material at " << move.element.to.transpose();
    // No pass enters the contour.
    for (double t = 0.0; t <= 1.0; t += 0.125) {
      const Vec2 p = move.element.from + t * (move.element.to - move.element.from);
      // On a wall it may be anywhere: both sides count.
      const double least = std::min(radiusAt(contour, p.x() - 1e-5), radiusAt(contour, p.x() + 1e-5));
      EXPECT_GT(p.y(), least - 1e-4) << "at z " << p.x();
    }
    // Level moves are on the levels told.
    const bool level = move.speed == ContourMove::Speed::kFeed &&
                       std::abs(move.element.to.y() - move.element.from.y()) < 1e-9 &&
                       move.element.source < 0;
    if (level) {
      const double k = (31.0 - move.element.to.y()) / rules.depth;
      EXPECT_NEAR(k, std::round(k), 1e-6);
    }
  }
  // Everything above the last level is removed: less than a depth stays on the contour.
  for (std::size_t k = 0; k < columns.z.size(); ++k) {
    const double z = columns.z[k];
    if (z > 0.0) continue;
    EXPECT_LT(columns.cut[k], radiusAt(contour, z) + rules.depth + 1e-4) << "z " << z;
  }
}

TEST(FanucLatheContours, LevelsOverRandomContours) {
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    checkLevels(false, seed);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(FanucLatheContours, PocketsOverRandomContours) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    checkLevels(true, seed);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace proveout::test
