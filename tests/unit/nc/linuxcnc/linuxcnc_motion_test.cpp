// Motions of LinuxCNC, against what its interpreter rs274 (2.9) gives.
// Points are machine coordinates: those of rs274 with its offsets and turns added.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

// clang-format off: one case a row
const std::vector<LcnCase> kLcnMotionCases{
    // lcn-3-G2 lcn-3-G3 lcn-3-G0 lcn-3-G1
    {"arcs by centre and by radius",
     "G0 X20 Y5\nG2 X30 Y-5 I0 J-10\nG3 X40 Y-15 R10\nG1 X41",
     {"R 20 5 0", "A 30 -5 0 c 20 -5 0 -90", "A 40 -15 0 c 40 -5 0 90", "F 41 -15 0"},
     ""},
    // lcn-3-arcP
    {"two turns down",
     "G0 X40 Y-15 Z-1\nG2 X40 Y-15 I5 J0 P2 Z-3",
     {"R 40 -15 -1", "A 40 -15 -3 c 45 -15 -1 -720"},
     ""},
    // lcn-3-arctol
    {"radii differ by 0.8 percent", "G2 X10 Y0 I5.02", {}, "linuxcnc-arc-radius"},
    // lcn-3-arctol
    {"radii differ by 0.2 percent, within the tolerance",
     "G2 X10 Y0 I5.005",
     {"A 10 0 0 c 5.005 0 0 -180"},
     ""},
    // lcn-3-arctol
    {"inches have a tolerance of their own", "G20\nG2 X5 Y0 I2.4987", {"A 127 0 0 c 63.467 0 0 -180"}, ""},
    // lcn-3-arctol
    {"radii differ by 0.05 percent", "G2 X400 Y0 I200.05", {"A 400 0 0 c 200.05 0 0 -180"}, ""},
    // lcn-3-arctol
    {"radii differ by more than 100 tolerances", "G2 X9000 Y0 I4498", {}, "linuxcnc-arc-radius"},
    // lcn-3-G2
    {"a radius a little too small", "G2 X20 R9.999", {"A 20 0 0 c 10 0 0 -180"}, ""},
    // lcn-3-G2
    {"a radius too small", "G2 X20 R9.9", {}, "linuxcnc-arc-reach"},
    // lcn-3-G2
    {"the long way", "G0 X10\nG2 X0 Y0 R-6", {"R 10 0 0", "A 0 0 0 c 5 -3.3166 0 -247.1146"}, ""},
    // lcn-3-G3
    {"full circle without an end", "G3 I5 J2\nX1 I3\nI-2", {"A 0 0 0 c 5 2 0 360"}, "linuxcnc-arc-radius"},
    // lcn-4-G90.1 lcn-4-G91.1
    {"centres absolute",
     "G90.1\nG0 X10 Y10\nG2 X20 Y20 I20 J10\nG91.1\nG2 X30 Y10 J-10",
     {"R 10 10 0", "A 20 20 0 c 20 10 0 -90", "A 30 10 0 c 20 10 0 -90"},
     ""},
    // lcn-4-G90.1
    {"centres absolute need both", "G90.1\nG2 X20 Y0 I10", {}, "linuxcnc-arc-center"},
    // lcn-4-G18
    {"arc in XZ",
     "G18 G2 X12 Z3 I6 K1.5\nG91 G3 X4 K2 Y-1 P3",
     {"A 12 0 3 c 6 0 1.5 -180"},
     "linuxcnc-arc-radius"},
    // lcn-4-G19
    {"arc in YZ", "G19 G3 Y12 Z3 J6 K1.5", {"A 0 12 3 c 0 6 1.5 180"}, ""},
    // lcn-3-G2
    {"letter of the other plane", "G2 X5 K2", {}, "linuxcnc-arc-plane"},
    // lcn-3-G2
    {"no centre", "G2 X5", {}, "linuxcnc-arc-form"},
    // lcn-3-G2
    {"both forms", "G2 X5 R4 I2", {}, "linuxcnc-arc-form"},
    // lcn-3-G2
    {"radius without a way", "G2 R4 X0", {}, "linuxcnc-arc-end"},
    // lcn-4-G53 lcn-3-modalmotion
    {"G53 alone in a line with an arc", "G53 G2 X5 I2", {}, "linuxcnc-machine-move"},
    // lcn-4-G53
    {"G53 in steps", "G91 G53 G0 X1", {}, "linuxcnc-machine-move"},
    // lcn-4-G53
    {"G53 alone", "G53 X1", {"R 1 0 0"}, ""},
    // lcn-3-G80 lcn-3-modalmotion
    {"axis words without a motion", "G80\nX5", {}, "linuxcnc-axis-words"},
    // lcn-3-G80
    {"G80 with axis words", "G80 X5", {}, "linuxcnc-axis-words"},
    // lcn-3-G1
    {"no feed", "F0\nG1 X1", {}, "linuxcnc-feed"},
    // lcn-4-G94 lcn-4-G95
    {"a new feed mode takes F away", "G94\nG1 X1", {}, "linuxcnc-feed"},
    // lcn-4-G95
    {"feed per turn needs the spindle", "G95 F1\nG1 X2", {}, "linuxcnc-feed"},
    // lcn-4-G93
    {"inverse time needs F in each line", "G93 G1 X10 F2\nX20", {"F 10 0 0"}, "linuxcnc-feed"},
    // lcn-4-G20 lcn-4-G21
    {"two units", "G20 F10\nG1 X1\nG21 F10\nG1 X1", {"F 25.4 0 0", "F 1 0 0"}, ""},
    // lcn-4-G91 lcn-4-G90
    {"steps", "G91\nG1 X3 Y4\nX2\nG90\nX1", {"F 3 4 0", "F 5 4 0", "F 1 4 0"}, ""},
    // lcn-4-G7 lcn-4-G8
    {"diameters",
     "G18 G7\nG0 X20\nG0 X30 Z-5\nG2 X40 Z-10 I5 K0\nG91 G1 X2\nG8 X2",
     {"R 10 0 0", "R 15 0 -5", "A 20 0 -10 c 20 0 -5 -90", "F 21 0 -10", "F 23 0 -10"},
     ""},
    // lcn-4-G96 lcn-4-G97
    {"surface speed needs S", "G96 D1000", {}, "linuxcnc-surface-speed"},
    // lcn-3-G4
    {"dwell needs P", "G4", {}, "linuxcnc-dwell"},
    // lcn-3-G4
    {"no negative dwell", "G4 P-1", {}, "linuxcnc-dwell"},
    // lcn-3-G4
    {"dwell and motion in a line", "G4 P.1 G1 X2", {"F 2 0 0"}, ""},
    // lcn-4-G61 lcn-4-G61.1 lcn-4-G64
    {"exact path, exact stop, blending",
     "G61 G1 X1\nG61.1 X2\nG64 P.1 Q.05 X3\nG64 X4",
     {"F 1 0 0", "F 2 0 0", "F 3 0 0", "F 4 0 0"},
     ""},
    // lcn-3-G1
    {"two codes of a group", "G0 G1 X3", {}, "linuxcnc-group-clash"},
    // lcn-3-G1
    {"two codes that want the axes", "G0 X1 G92 Y2", {}, "linuxcnc-axis-words"},
    // lcn-3-A
    {"rotary axis in degrees", "G1 X1", {"F 1 0 0"}, ""},
    // lcn-4-G17.1
    {"planes of U V W", "G17\nG1 X1", {"F 1 0 0"}, ""},
    // lcn-4-G17
    {"plane XY again", "G18\nG17 G2 X4 I2", {"A 4 0 0 c 2 0 0 -180"}, ""},
    // lcn-3-G33 lcn-3-G33.1
    {"synchronous lines and a tap", "S200 M3\nG33 Z-5 K1", {"T 0 0 -5"}, ""},
    // lcn-3-G33.1
    {"tap without the spindle", "G33.1 Z-5 K1", {}, "linuxcnc-spindle-stopped"},
    // lcn-3-G33
    {"G33 without the spindle", "G33 Z-5 K1", {}, "linuxcnc-spindle-stopped"},
    // lcn-3-G33
    {"G33 without K", "S200 M3\nG33 Z-5", {}, "linuxcnc-thread"},
};
// clang-format on

TEST(LinuxCncMotion, GoesWhereTheInterpreterGoes) { checkLcnCases(kLcnMotionCases); }

/// The point of the path nearest to one.
double distanceTo(const IsoRun& run, const Vec3& point) {
  double least = 1e9;
  for (const Motion& m : run.path.motions) {
    const Vec3 d = m.to - m.from;
    const double n = d.squaredNorm();
    const double t = n > 0.0 ? std::clamp((point - m.from).dot(d) / n, 0.0, 1.0) : 0.0;
    least = std::min(least, (m.from + t * d - point).norm());
  }
  return least;
}

// lcn-3-G5 lcn-3-G5.1: the middles of the curves, in closed form.
TEST(LinuxCncMotion, GoesAlongSplines) {
  const IsoRun cubic = runLcn("G5 I0 J3 P0 Q-3 X1 Y1\nG5 P0 Q-2 X2 Y2");
  EXPECT_EQ(cubic.error(), "") << cubic.message();
  EXPECT_LT(distanceTo(cubic, {0.5, 0.5, 0.0}), 1.1e-3);
  // Without I J: from (1,1) with (0,3), through (P0 + 3 P1 + 3 P2 + P3) / 8.
  EXPECT_LT(distanceTo(cubic, {(1 + 3 + 6 + 2) / 8.0, (1 + 12 + 0 + 2) / 8.0, 0.0}), 1.1e-3);
  EXPECT_EQ(cubic.motions().back(), "F 2 2 0");
  const IsoRun quadratic = runLcn("G0 X2 Y2\nG5.1 X4 Y2 I1 J1");
  EXPECT_EQ(quadratic.error(), "") << quadratic.message();
  EXPECT_LT(distanceTo(quadratic, {3.0, 2.5, 0.0}), 1.1e-3);
}

// lcn-3-G5.2 lcn-3-G5.3: points of the example by de Boor's recurrence.
TEST(LinuxCncMotion, GoesAlongNurbs) {
  const IsoRun run = runLcn("G5.2 X0 Y1 P1 L3\nX2 Y2 P1\nX2 Y0 P1\nX0 Y0 P2\nG5.3\nG91 G1 X1");
  EXPECT_EQ(run.error(), "") << run.message();
  for (const Vec3& point : {Vec3(0.25, 0.875, 0), Vec3(1.75, 1.625, 0), Vec3(1.2, 0.2, 0)})
    EXPECT_LT(distanceTo(run, point), 1.1e-3);
  EXPECT_EQ(run.motions().back(), "F 1 0 0");
  EXPECT_EQ(runLcn("G5.3").error(), "linuxcnc-spline");
  EXPECT_EQ(runLcn("G5.2 X1 P1 L3\nG5.3").error(), "linuxcnc-spline");
  EXPECT_EQ(runLcn("G5.2 X1 P0 L3").error(), "linuxcnc-spline");
  EXPECT_EQ(runLcn("G5 P1 Q1 X3").error(), "linuxcnc-spline");
  EXPECT_EQ(runLcn("G5.1 I1 X3").error(), "linuxcnc-spline");
  EXPECT_EQ(runLcn("F0\nG5.2 X1 P1 L3").error(), "linuxcnc-feed");
}

// lcn-3-G6.2: a quarter of a circle is a NURBS of order 3.
TEST(LinuxCncMotion, GoesAlongNurbsWithKnots) {
  const IsoRun run =
      runLcn("G0 X10 Y0\nG6.2 X10 Y0 R1 K0 P3\nX10 Y10 R0.70710678 K0\nX0 Y10 R1 K0\nK1\nK1\nK1");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_TRUE(run.tells("linuxcnc-version"));
  for (const Motion& m : run.path.motions)
    EXPECT_NEAR(m.to.head<2>().norm(), m.kind == MotionKind::kRapid ? 10.0 : 10.0, 1e-6);
  EXPECT_EQ(run.motions().back(), "F 0 10 0");
  EXPECT_EQ(runLcn("G6.2 X10 Y0 R1 K0 P3").error(), "linuxcnc-spline");
}

// lcn-3-polar: figures of rs274.
TEST(LinuxCncMotion, TakesPolarWords) {
  const IsoRun run = runLcn("G0 X10\n@5 ^90\nG1 @10 ^45\nG91 G1 ^45\n@-4");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(),
            (std::vector<std::string>{"R 10 0 0", "R 0 5 0", "F 7.0711 7.0711 0", "F 0 10 0", "F 0 6 0"}));
  EXPECT_EQ(runLcn("G0 @5").error(), "linuxcnc-polar");
  EXPECT_EQ(runLcn("G0 X1 @5 ^3").error(), "linuxcnc-polar");
  EXPECT_EQ(runLcn("G18\nG0 @5 ^3").error(), "linuxcnc-polar");
}

// lcn-3-G33 lcn-3-G33.1
TEST(LinuxCncMotion, CutsThreadsByTheSpindle) {
  const IsoRun run = runLcn("S200 M3\nG33 Z-5 K1\nG33.1 Z-10 K1.25 I2\nG1 X1");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (std::vector<std::string>{"T 0 0 -5", "T 0 0 -10", "T 0 0 -5", "F 1 0 -5"}));
  EXPECT_NEAR(run.path.motions[0].feed, 200.0, 1e-9);
  EXPECT_NEAR(run.path.motions[1].feed, 250.0, 1e-9);
  EXPECT_NEAR(run.path.motions[2].feed, 500.0, 1e-9);
}

// lcn-3-G38.2 lcn-3-G38.5: without a stock a probing move goes to its end.
TEST(LinuxCncMotion, Probes) {
  const IsoRun run = runLcn("G38.2 Z-5\nG38.3 Z-6\nG38.4 Z-5\nG38.5 Z0");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_TRUE(run.tells("linuxcnc-no-probe"));
  EXPECT_EQ(run.end(), Vec3(0, 0, 0));
  EXPECT_EQ(runLcn("G38.2 Z0").error(), "linuxcnc-probe");
  EXPECT_EQ(runLcn("F0\nG38.2 Z-1").error(), "linuxcnc-feed");
}

// lcn-4-G93 lcn-3-A: times of lines, and of an axis that turns.
TEST(LinuxCncMotion, TakesItsTime) {
  const IsoRun inverse = runLcn("G93 G1 X10 F2\nX20 F4");
  ASSERT_EQ(inverse.path.motions.size(), 2u) << inverse.message();
  EXPECT_NEAR(inverse.path.motions[0].time_s, 30.0, 1e-6);
  EXPECT_NEAR(inverse.path.motions[1].time_s, 15.0, 1e-6);
  ControlSettings settings = lcnSettings();
  AxisSettings a;
  a.name = "A";
  settings.axes.push_back(a);
  const IsoRun turned = runLcn("G1 A50\nG1 X10 A60", settings);
  ASSERT_EQ(turned.error(), "") << turned.message();
  double sum = 0.0;
  for (const Motion& m : turned.path.motions) sum += m.time_s;
  EXPECT_NEAR(sum, 30.0 + 6.0, 1e-3);
}

// lcn-4-G95 lcn-4-G96 lcn-4-G97
TEST(LinuxCncMotion, FeedsByTheTurn) {
  const IsoRun run = runLcn("S600 M3 G95 F.2\nG1 X10");
  ASSERT_EQ(run.path.motions.size(), 1u) << run.message();
  EXPECT_NEAR(run.path.motions[0].feed, 120.0, 1e-9);
  const IsoRun surface = runLcn("G18\nG0 X50\nG96 D2000 S100 M3\nG95 F.2\nG1 Z-10\nG97 S300\nG1 Z-20");
  ASSERT_EQ(surface.error(), "") << surface.message();
  // 100 m/min at a radius of 50 mm.
  EXPECT_NEAR(surface.path.motions[1].feed, 0.2 * 100000.0 / (2.0 * M_PI * 50.0), 1e-6);
  EXPECT_NEAR(surface.path.motions[2].feed, 60.0, 1e-9);
}

// Numbers beyond all reason do not hang.
TEST(LinuxCncMotion, RefusesWhatNoMachineDoes) {
  EXPECT_EQ(runLcn("G1 X20000000").error(), "linuxcnc-out-of-range");
  EXPECT_EQ(runLcn("G2 I5 P100000000").error(), "linuxcnc-out-of-range");
  EXPECT_EQ(runLcn("S100 M3 G18\nG76 P1 Z-5 I-1 J.00001 K5").error(), "linuxcnc-out-of-range");
}

}  // namespace
}  // namespace proveout::test
