// The wire EDM control against the examples of its manual and the closed forms of the digest wedm, D13 and
// D14. A test names the rows of coverage that it proves.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "wedm_path.h"

namespace proveout {
namespace {

using test::WedmPath;
using test::wireTrackLength;
using test::wireTrackPoint;

/// Digits of the digest.
constexpr double kDigits = 1.1e-6;
constexpr const char* kReady = "T84 T86;\nC001;\nG90 G92 X0 Y0 U0 V0;\n";

/// T 20, zM 0, zS 20, zL -40, zU 80.
ControlSettings digestHeights(std::map<std::string, double> more = {}) {
  ControlSettings settings;
  settings.parameters = {{"T", 20}, {"ZL", -40}, {"ZU", 80}};
  settings.parameters.merge(more);
  return settings;
}

void expectPoints(const std::vector<Vec2>& got, const std::vector<Vec2>& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t k = 0; k < got.size(); ++k)
    EXPECT_LT((got[k] - wanted[k]).norm(), kDigits * 2)
        << k << ": " << got[k].transpose() << " instead of " << wanted[k].transpose();
}

void expectEnds(const std::string& text, const std::vector<Vec2>& lower,
                const ControlSettings& settings = {}) {
  const WedmPath run(text, settings);
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  expectPoints(run.ends(), lower);
}

double lengthOf(const WedmPath& run) {
  double sum = 0.0;
  for (std::size_t k = 0; k < run.count(); ++k) sum += wireTrackLength(run.wire(k).lower);
  return sum;
}

/// Area that the tracks at the share w of the height go round, by Simpson's rule on every motion.
double areaAt(const WedmPath& run, double w, std::size_t first, std::size_t last) {
  double area = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    constexpr int kParts = 400;
    const auto at = [&](double f) -> Vec2 {
      return (1.0 - w) * wireTrackPoint(run.wire(k).lower, f) + w * wireTrackPoint(run.wire(k).upper, f);
    };
    for (int i = 0; i < kParts; ++i) {
      // Exact for the parabola through three points.
      const Vec2 a = at(static_cast<double>(i) / kParts), b = at((i + 0.5) / kParts),
                 c = at((i + 1.0) / kParts);
      const Vec2 d = 4 * b - 3 * a - c, e = 2 * (a + c - 2 * b);
      const auto cross = [](const Vec2& p, const Vec2& q) { return p.x() * q.y() - p.y() * q.x(); };
      area += 0.5 * (cross(a, d + e) + cross(d, e) / 3.0);
    }
  }
  return area;
}

std::string errorOf(const std::string& block) { return WedmPath(kReady + block + "\nM02;\n").error(); }

// EX-1 (1.6). Rows: wedm-8.3-M98 wedm-8.4-M99 wedm-10-P wedm-2.1-block wedm-1.6-comment wedm-8.1-M00
TEST(WedmExamples, HolesBySubprograms) {
  const std::string text =
      "(M02 STOP)\nT84T86;\nG90G92X0Y0;  (1)\nM98P0002;\nM00;\nG00X50.;  (2)\nM00;\nM98P0002;\nM00;\n"
      "G00Y-50.;  (3)\nM00;\nM98P0002;\nM00;\nG00X-50.;  (4)\nM00;\nM98P0002;\nT85T87;\nM02;\n"
      "N0001;\nT84T86;\nG90G92X0Y0;\nC004;\nG01X5.Y5.;\nX5.Y-5.;\nX-5.Y-5.;\nX-5.Y5.;\nX5.Y5.;\nX0Y0;"
      "\nT85T87;\nM99;\n"
      "N0002;\nT84T86;\nG90G92X0Y0;\nC004;\nG01X5.;\nG02X-5.Y0I-5.J0;\nX5.Y0I5.J0;\nG01X0;\nT85T87;\nM99;\n";
  const WedmPath run(text);
  EXPECT_EQ(run.error(), "");
  ASSERT_EQ(run.count(), 4 * 4 + 3u);
  const std::vector<Vec2> centers{{0, 0}, {50, 0}, {50, -50}, {0, -50}};
  for (std::size_t hole = 0; hole < 4; ++hole) {
    const WireTrack& arc = run.wire(5 * hole + 1).lower;
    EXPECT_LT((arc.center - centers[hole]).norm(), kDigits) << hole;
    EXPECT_NEAR(arc.sweep_rad, -kPi, 1e-12);
  }
  double hole = 0.0;
  for (std::size_t k = 0; k < 4; ++k) hole += wireTrackLength(run.wire(k).lower);
  EXPECT_NEAR(hole, 41.4159, 1e-4);
  EXPECT_EQ(run.path.motions[4].kind, MotionKind::kRapid);
}

// EX-2. Rows: wedm-2.2-axes wedm-5.1-G00
TEST(WedmExamples, AxesTogetherOrOneByOne) {
  expectEnds("G92 X0 Y0; G91 G00 X5. Y15.; M02;", {{5, 15}});
  expectEnds("G92 X0 Y0; G91 G00 X5.; Y15.; M02;", {{5, 0}, {5, 15}});
}

// EX-3. Rows: wedm-3-N wedm-5.3-G02 wedm-5.3-G03
TEST(WedmExamples, HalfCircles) {
  const WedmPath run(
      "N0000; G90 G92 X0. Y0.; C001; M98 P0010; C010; M98 P0020; M02; ;\nN0010; G01 X0; M99; ;\n"
      "N0020; G02 X10. I5.; G02 X5. I-2.5; G03 X0 I-2.5; M99;");
  expectPoints(run.ends(), {{10, 0}, {5, 0}, {0, 0}});
  EXPECT_NEAR(lengthOf(run), 31.415927, kDigits);
  EXPECT_NEAR(areaAt(run, 0.0, 0, 3), -39.269908, 1e-5);
}

// EX-4. Rows: wedm-5.1-G00 wedm-5.2-G01
TEST(WedmExamples, SingleMotions) {
  for (const auto& [block, end, kind] : {std::tuple{"G00 X10.;", Vec2(10, 0), MotionKind::kRapid},
                                         {"G00 X10. Y20.;", {10, 20}, MotionKind::kRapid},
                                         {"C001; G01 X10.;", {10, 0}, MotionKind::kFeed},
                                         {"C001; G01 X70. Y60.;", {70, 60}, MotionKind::kFeed}}) {
    const WedmPath run(std::string("T84 T86; G92 X0 Y0; ") + block + " M02;");
    EXPECT_EQ(run.error(), "") << block;
    ASSERT_EQ(run.count(), 1u) << block;
    EXPECT_EQ(run.path.motions[0].kind, kind) << block;
    for (const WireTrack& track : {run.wire(0).lower, run.wire(0).upper}) {
      EXPECT_EQ(track.from, Vec2(0, 0)) << block;
      EXPECT_EQ(track.to, end) << block;
    }
  }
}

// EX-5
TEST(WedmExamples, QuarterCircles) {
  const WedmPath run("G90 G92 X10. Y20.;\nG02 X50.0 Y60.0 I40.0;\nG03 X80.0 Y30.0 I30.0;\nM02;");
  ASSERT_EQ(run.count(), 2u);
  EXPECT_NEAR(wireTrackLength(run.wire(0).lower), 62.831853, kDigits);
  EXPECT_NEAR(wireTrackLength(run.wire(1).lower), 47.123890, kDigits);
  EXPECT_LT((run.wire(1).lower.center - Vec2(80, 60)).norm(), kDigits);
}

const char* skipProgram(bool skip) {
  return skip ? "G90 G92 X0 Y0;\nG11;\n/G41 H001;\nG01 X10.;\nY10.;\n/ G02 X20. Y20. I10.;\n/M00;\nG01 "
                "Y30.;\nX0;\n"
                "G40 G01 Y0;\nM02;"
              : "G90 G92 X0 Y0;\nG12;\n/G41 H001;\nG01 X10.;\nY10.;\n/ G02 X20. Y20. I10.;\n/M00;\nG01 "
                "Y30.;\nX0;\n"
                "G40 G01 Y0;\nM02;";
}

// EX-6. Rows: wedm-4-skip wedm-5.5-G11 wedm-5.5-G12
TEST(WedmExamples, SkippedBlocks) {
  expectEnds(skipProgram(true), {{10, 0}, {10, 10}, {10, 30}, {0, 30}, {0, 0}});
  EXPECT_NEAR(lengthOf(WedmPath(skipProgram(false))), 95.707963, kDigits);
  ControlSettings settings;
  settings.parameters["H.1"] = 0.2;
  expectEnds(skipProgram(false), {{9.8, 0}, {9.8, 10}, {19.8, 20.198039}, {19.8, 29.8}, {0, 29.8}, {0, 0}},
             settings);
}

// EX-7. Rows: wedm-5.5.3-G30 wedm-5.5.3-G31
TEST(WedmExamples, ExtendedLines) {
  expectEnds("G92 X0 Y0; G01X0; G41H000; G31X1.0X10.0Y10.0; G30G01X0; M02;",
             {{10, 10}, {10.707107, 10.707107}, {10, 10}, {0, 10}});
}

std::string overcutProgram(const std::string& join) {
  return "H000=+00000000;\nH001=+00000110;\nH005=+00000000;\n" + join +
         "T84 T86 G54 G90 G92X+1500Y-1500;\nC007;\nG01X+1500Y-1000;G04X0.0+H005;\nG41H000;\n"
         "G01X+1500Y+0;G04X0.0+H005;\nG41H001;\nG37X50;\nX+0Y+0;G04X0.0+H005;\nX+0Y+3000;G04X0.0+H005;\n"
         "X+3000Y+3000;G04X0.0+H005;\nX+3000Y+0;G04X0.0+H005;\nG36;\nX+1500Y+0;G04X0.0+H005;\n"
         "G40H000G01X+1500Y-1000;\nM00;\nC007;\nG01X+1500Y-1500;G04X0.0+H005;\nT85 T87 M02;\n";
}

// EX-8. Rows: wedm-5.5.5-G36 wedm-5.5.5-G37 wedm-5.5.2-G28 wedm-5.5.2-G29 wedm-5.6.4-H0
TEST(WedmExamples, CornerOvercut) {
  const WedmPath run(overcutProgram(""));
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  EXPECT_FALSE(run.warns("wedm-5.5.5-G36"));
  expectPoints(run.ends(), {{1.5, -1},    {1.5, -0.11},  {0, -0.11}, {-0.05, -0.11}, {0, -0.11}, {-0.11, 0},
                            {-0.11, 3},   {-0.11, 3.05}, {-0.11, 3}, {0, 3.11},      {3, 3.11},  {3.05, 3.11},
                            {3, 3.11},    {3.11, 3},     {3.11, 0},  {3.11, -0.05},  {3.11, 0},  {3, -0.11},
                            {1.5, -0.11}, {1.5, -1},     {1.5, -1.5}});
  EXPECT_NEAR(lengthOf(run), 15.871150, kDigits);
  EXPECT_NEAR(-areaAt(run, 0.0, 2, 19), 10.358013, kDigits);
}
TEST(WedmExamples, CornerOvercutLeftOut) {
  std::string plain = overcutProgram("");
  plain.erase(plain.find("G37X50;\n"), 8);
  EXPECT_NEAR(lengthOf(WedmPath(plain)), 15.471150, kDigits);
  std::string straight = overcutProgram("G29;");
  straight.erase(straight.find("G37X50;\n"), 8);
  EXPECT_NEAR(lengthOf(WedmPath(straight)), 15.660000, kDigits);
}

// EX-9. Rows: wedm-5.6.5-change wedm-5.6-G40 wedm-5.6-G41 wedm-5.6-G42
TEST(WedmExamples, ChangeOfSide) {
  const WedmPath run(
      "H000=0.;\nH001=5.;\nG90 G92 X0 Y0;\nG41 H001;\nG01 X10.Y0.;\nX20.Y0.;\nG42 H001;\nX40.Y0.;\n"
      "G40H000G01X40.Y1.;\nM02;");
  expectPoints(run.ends(), {{10, 5}, {20, 5}, {40, -5}, {40, 1}});
  EXPECT_NEAR(lengthOf(run), 49.541020, kDigits);
}

// EX-10. Rows: wedm-5.6.6-G92 wedm-1.4-units
TEST(WedmExamples, PointNamedWithinAnOffset) {
  ControlSettings settings;
  settings.parameters["H.1"] = 0.05;
  expectEnds(
      "G92 X0 Y0;\nN001 G90 G41 H001 G01 X300 Y600;\nN002 X600 Y300;\nN003 G92 X100 Y200;\nN004 G01 X400 "
      "Y400;\nN005\n",
      {{0.335355, 0.635355}, {0.6, 0.3}, {0.872265, 0.541603}}, settings);
}

// EX-11. Rows: wedm-5.8-G54 wedm-5.8-G55 wedm-5.11-G92
TEST(WedmExamples, WorkSystems) {
  expectEnds("G92 G54 X0 Y0;\nG00 X100 Y100;\nG92 G55 X0 Y0;\nG54 X200 Y100;\nG55 X0 Y0;\nM02;",
             {{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.1}});
}
// Rows: wedm-5.8-G56 wedm-5.8-G57 wedm-5.8-G58 wedm-5.8-G59
TEST(WedmExamples, WorkSystemsOfTheJob) {
  for (int system = 56; system <= 59; ++system) {
    ControlSettings settings;
    settings.work_offsets[static_cast<std::size_t>(system - 54)] = Vec3(system, -3, 0);
    expectEnds("G92 X0 Y0; G" + std::to_string(system) + " G00 X1. Y1.; M02;", {{system + 1.0, -2}},
               settings);
  }
}

std::string shapesProgram(const std::string& h) {
  return "H000=0;\nH001=" + h +
         ";\nG90 G92 X0 Y0 U0 V0;\nC001;\nG61;\nG41 H000;\nG01 X0 Y10. : G01 X0 Y10.;\nG41 H001;\n"
         "G02 X-10. Y20. I0 J10. : X-10. Y20.;\nX0 Y30. I10. J0 : X0 Y30.;\nX10. Y20. I0 J-10. : X10. Y20.;\n"
         "X0 Y10. I-10. J0 : X0 Y10.;\nG40 H000;\nG01 X0 Y0 : X0 Y0;\nG60;\nM02;\n";
}

// EX-12. Rows: wedm-5.9-G61 wedm-5.9-G60 wedm-5.9-colon
TEST(WedmExamples, CircleBelowDiamondAbove) {
  const WedmPath run(shapesProgram("0"), digestHeights());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  ASSERT_EQ(run.count(), 6u);
  EXPECT_NEAR(-areaAt(run, 0.0, 1, 5), 314.159265, 1e-5);
  EXPECT_NEAR(-areaAt(run, 1.0, 1, 5), 200.0, 1e-6);
  EXPECT_NEAR(-areaAt(run, 0.5, 1, 5), 255.863771, 1e-5);
  EXPECT_LT((wireTrackPoint(run.wire(1).lower, 0.5) - Vec2(-7.071068, 12.928932)).norm(), kDigits);
  EXPECT_LT((wireTrackPoint(run.wire(1).lower, 0.25) - Vec2(-3.826834, 10.761205)).norm(), kDigits);
  EXPECT_LT((wireTrackPoint(run.wire(1).upper, 0.25) - Vec2(-2.5, 12.5)).norm(), kDigits);
}
TEST(WedmExamples, CircleBelowDiamondAboveOffset) {
  const WedmPath run(shapesProgram("0.135"), digestHeights());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  const double o = 0.095459, d = 10.095459;
  expectPoints(run.ends(true), {{-o, 10 - o},
                                {-d, 20 - o},
                                {-d, 20 + o},
                                {-o, 30 + o},
                                {o, 30 + o},
                                {d, 20 + o},
                                {d, 20 - o},
                                {o, 10 - o},
                                {0, 0}});
  // The lower point stands during the upper arcs.
  EXPECT_EQ(run.wire(2).lower.from, run.wire(2).lower.to);
  EXPECT_EQ(run.wire(2).lower.sweep_rad, 0.0);
  EXPECT_NEAR(-areaAt(run, 0.0, 1, 8), 322.698821, 1e-5);
  EXPECT_LT((wireTrackPoint(run.wire(1).lower, 0.5) - Vec2(-7.166527, 12.833473)).norm(), kDigits);
  EXPECT_LT((wireTrackPoint(run.wire(1).upper, 0.5) - Vec2(-5.095459, 14.904541)).norm(), kDigits);
}

constexpr const char* kFourAxes =
    "G92 X0 Y-1.;\nG74;\nG01 Y0;\nX10.;\nY10. U-3. V-4.;\nX5. U0 V0;\nX0 U3. V-4.;\nY0 U0 "
    "V0;\nG75;\nY-1.;\nM02;";

// EX-13. Rows: wedm-5.9.1-G74 wedm-5.9.1-G75 wedm-6-UV wedm-6-XY
TEST(WedmExamples, FourAxes) {
  const WedmPath run(kFourAxes, digestHeights());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  expectPoints(run.ends(), {{0, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}, {0, 0}, {0, -1}});
  expectPoints(run.ends(true), {{0, 0}, {10, 0}, {7, 6}, {5, 10}, {3, 6}, {0, 0}, {0, -1}});
  for (const auto& [w, area] : {std::pair{0.0, 100.0}, {0.25, 87.5}, {0.5, 75.0}, {0.75, 62.5}, {1.0, 50.0}})
    EXPECT_NEAR(areaAt(run, w, 1, 6), area, 1e-6);
  const WedmPath guides(kFourAxes, digestHeights({{"UV_UPPER", 1}}));
  EXPECT_LT((guides.ends()[2] - Vec2(9, 8.666667)).norm(), kDigits);
  EXPECT_LT((guides.ends(true)[2] - Vec2(8.5, 8)).norm(), kDigits);
}
// Row: wedm-6-UV
TEST(Wedm, UpperGuideIsMovedByItself) {
  const WedmPath run(std::string(kReady) + "G01 X10. U12. V-6.; X20.; G02 X30. I5.; M02;", digestHeights());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  expectPoints(run.ends(), {{10, 0}, {20, 0}, {30, 0}});
  expectPoints(run.ends(true), {{12, -1}, {22, -1}, {32, -1}});
  EXPECT_LT((run.wire(2).upper.center - Vec2(27, -1)).norm(), kDigits);
}

// EX-14. Rows: wedm-5.10-G90 wedm-5.10-G91 wedm-1.5-abs-inc
TEST(WedmExamples, AbsoluteAndIncremental) {
  const std::vector<Vec2> ends{{20, 15}, {60, 15}, {80, 30}};
  expectEnds(
      "N0001 G90 G92 X0 Y0;\nN0002 G01 X20. Y15.;\nN0003 G02 X60. Y15. I20. J0;\nN0004 G01 X80. Y30.;\nM02;",
      ends);
  const std::string steps =
      "N0001 G91 G92 X0 Y0;\nN0002 G01 X20. Y15.;\nN0003 G02 X40.0 I20.;\nN0004 G01 X20. Y15.;\nM02;";
  expectEnds(steps, ends);
  EXPECT_NEAR(lengthOf(WedmPath(steps)), 112.831853, kDigits);
}

// EX-15. Rows: wedm-5.11-G92 wedm-1.4-units
TEST(WedmExamples, TheFirstPointSaysWhereTheWireStands) {
  const auto start = [](const std::string& point) {
    const WedmPath run(point + " G91 G00 X1. Y2.; M02;");
    EXPECT_EQ(run.error(), "") << point;
    EXPECT_EQ(run.wire(0).lower.from, run.wire(0).upper.from) << "upright";
    EXPECT_LT((run.ends()[0] - run.wire(0).lower.from - Vec2(1, 2)).norm(), kDigits);
    return run.wire(0).lower.from;
  };
  EXPECT_EQ(start("G92 X0 Y0 U0 V0;"), Vec2(0, 0));
  EXPECT_LT((start("G92 X10 Y0;") - Vec2(0.010, 0)).norm(), 1e-12) << "least increments";
}

constexpr const char* kRoundedSquare =
    "H000=0;\nG90 G92 X-18.Y0.U0.V0.;\nC001;\nG42H000;\nG52A0.;\nG01 "
    "X-10.Y0.;\nG42H000;\nG52A2.5;\nX-10.Y-6.;\n"
    "G03X-6.Y-10.I4.J0.;\nG01X6.Y-10.;\nG03X10.Y-6.J4.;\nG01X10.Y6.;\nG03X6.Y10.I-4.;\nG01X-6.Y10.;\n"
    "G03X-10.Y6.J-4.;\nG01X-10.Y0.;\nG40H000G50A0.X-18.Y0.;\nM02;";

// EX-16. Rows: wedm-5.7-G50 wedm-5.7-G52 wedm-5.7-A wedm-7.2-start
TEST(WedmExamples, TaperedRoundedSquare) {
  const WedmPath run(kRoundedSquare, digestHeights());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  EXPECT_NEAR(lengthOf(run), 89.132741, kDigits);
  EXPECT_NEAR(areaAt(run, 0.0, 1, 10), 386.265482, 1e-5);
  EXPECT_NEAR(areaAt(run, 1.0, 1, 10), 452.521871, 1e-5);
  EXPECT_LT((run.wire(0).upper.to - Vec2(-10.873219, 0)).norm(), kDigits);
  EXPECT_NEAR((run.wire(2).upper.from - run.wire(2).upper.center).norm(), 4.873219, kDigits);
  EXPECT_EQ(run.ends(true).back(), Vec2(-18, 0));
  const WedmPath high(kRoundedSquare, digestHeights({{"ZS", 40}}));
  EXPECT_NEAR(areaAt(high, 1.0, 1, 10), 523.569258, 1e-5);
}

std::string variableTaper(const std::string& corner = "") {
  return "H000=0;\nG90G92X0.Y0.U0.V0.;\nC096;\nG01X0.Y4.;\nC001;\nG42H000;\nG51A0G01X0.Y5.;\nG42H001;\n"
         "G51A2.X5.Y5." +
         corner +
         ";\nG51A2.X5.Y-5.;\nG51A2.X-5.Y-5.;\nG51A0.X-5.Y5.;\nG51A2.X0.Y5.;\nG40H000G50A0X0.Y4.5;\nX0.Y0.;"
         "\nM02;\n";
}

// EX-17. Rows: wedm-5.7-G51 wedm-7.5-variable wedm-7.3-joins
TEST(WedmExamples, ConstantAndVariableTaper) {
  const WedmPath sharp(variableTaper(), digestHeights());
  EXPECT_EQ(sharp.error(), "") << sharp.first(Severity::kError).message;
  EXPECT_NEAR(lengthOf(sharp), 50.0, kDigits);
  EXPECT_NEAR(-areaAt(sharp, 1.0, 2, 7), 121.928030, 1e-5);
  EXPECT_NEAR(-areaAt(sharp, 0.5, 2, 7), 110.720123, 1e-5);
  const WedmPath run(variableTaper(), digestHeights({{"H.1", 0.1}}));
  expectPoints(
      run.ends(),
      {{0, 4}, {0, 4.9}, {4.9, 4.9}, {4.9, -4.9}, {-4.9, -4.9}, {-4.9, 4.9}, {0, 4.9}, {0, 4.5}, {0, 0}});
  const double t = 5.598415;
  expectPoints(run.ends(true),
               {{0, 4}, {0, t}, {t, t}, {t, -t}, {-4.9, -t}, {-4.9, t}, {0, t}, {0, 4.5}, {0, 0}});
}

// K17, K18. Row: wedm-7.4-RR
TEST(WedmConstructed, RoundedCornersOfBothPlanes) {
  const auto arcs = [](const char* corner) {
    const WedmPath run(variableTaper(corner), digestHeights());
    EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
    return run.wire(3);
  };
  const WireSweep same = arcs("R1.R1.");
  EXPECT_LT((same.lower.center - Vec2(4, 4)).norm(), kDigits);
  EXPECT_LT((same.upper.center - Vec2(4.698415, 4.698415)).norm(), kDigits);
  EXPECT_LT((same.upper.from - Vec2(4.698415, 5.698415)).norm(), kDigits);
  EXPECT_LT((same.upper.to - Vec2(5.698415, 4.698415)).norm(), kDigits);
  EXPECT_LT((arcs("R1.R2.").upper.center - Vec2(3.698415, 3.698415)).norm(), kDigits);
  EXPECT_LT((arcs("R1.R1.698415").upper.center - Vec2(4, 4)).norm(), kDigits);
  EXPECT_LT((arcs("R1.").upper.center - Vec2(4, 4)).norm(), kDigits) << "a cone";
}

/// What happens, in order: "rapid 50", "M00", "cut 10" with the X that a motion ends at.
std::string courseOf(const WedmPath& run) {
  std::string course;
  std::size_t event = 0;
  for (std::size_t k = 0; k <= run.count(); ++k) {
    for (; event < run.path.events.size() && run.path.events[event].before <= k; ++event) {
      const PathEvent& what = run.path.events[event].event;
      if (const auto* c = what.as<event::Coolant>()) course += c->code + (c->on ? " on; " : " off; ");
      if (const auto* s = what.as<event::Stop>()) course += s->code + "; ";
      if (const auto* e = what.as<event::End>()) course += e->code;
    }
    if (k == run.count()) break;
    course += run.path.motions[k].kind == MotionKind::kRapid ? "rapid " : "cut ";
    course += std::to_string(std::lround(run.wire(k).lower.to.x())) + "; ";
  }
  return course;
}

// EX-18, EX-20. Rows: wedm-8.1-M00 wedm-15-T85 wedm-15-T87 wedm-8.2-M02
TEST(WedmExamples, StopAndEnd) {
  EXPECT_EQ(courseOf(WedmPath("G92 X0 Y0; G00 X50.; M00; C001; G01 X10.; M02;")),
            "rapid 50; M00; cut 10; M02");
  EXPECT_EQ(
      courseOf(WedmPath("G92 X9. Y0; C001; T84 T86; G41 H000; G01 X5.; G40 G01 X0;  T85 T87;  M02; X7.;")),
      "T84 on; T86 on; cut 5; cut 0; T85 off; T87 off; M02");
}

// EX-19. Rows: wedm-11-expr wedm-12-H wedm-5.6.1-H
TEST(WedmExamples, Expressions) {
  expectEnds("G92X0Y0; H000=1000; G90 G01 X1000+2H000; M02;", {{3, 0}});
  expectEnds("G92X0Y0; H000=320; H001=180+2H000; G01 XH001; M02;", {{0.82, 0}});
  expectEnds("G92X0Y0; H005=90.07; G01 X50.1+5H005; M02;", {{500.45, 0}});
  const WedmPath run("G92X0Y0; H010=100; H000=20; H100=H010+10-2H000; G01 XH100; M02;");
  expectPoints(run.ends(), {{0.07, 0}});
  EXPECT_TRUE(run.warns("wedm-12-H-range"));
  EXPECT_EQ(errorOf("H001=99999.999+1.;"), "wedm-12-H");
}

}  // namespace
}  // namespace proveout
