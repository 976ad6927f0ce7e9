// Lathes: systems of G codes, diameters, tools, coordinates, speeds (section 15).
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

/// Path points have X as a radius.
Lines latheMoves(const std::string& text, const ControlSettings& settings = latheAt(0, 0)) {
  const IsoRun run = lathe(text, settings);
  EXPECT_EQ(run.error(), "") << run.message();
  return run.motions();
}

// fan-15-diameter
TEST(FanucLathe, XIsADiameterAndIAndRAreRadii) {
  EXPECT_EQ(latheMoves("G0 X40. Z2.\nG1 X20. F.2\nM30\n"), (Lines{"R 20 0 2", "F 10 0 2"}));
  // G2 from X20 Z0 to X30 Z-5, centre I5 K0: X30 Z0; I is a radius.
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG2 X30. Z-5. I5. K0 F.1\nM30\n"),
            (Lines{"R 10 0 0", "A 15 0 -5 c 15 0 0 -90"}));
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG2 X30. Z-5. R5. F.1\nM30\n").back(), "A 15 0 -5 c 15 0 0 -90");
}

TEST(FanucLathe, NegativeRadiusIsRefused) {
  EXPECT_EQ(lathe("G0 X20. Z0\nG2 X30. Z-5. R-5. F.1\nM30\n").error(), "fanuc-023");
}

// fan-15-uw
TEST(FanucLathe, UAndWAreSteps) {
  EXPECT_EQ(latheMoves("G0 X40. Z2.\nG1 U-4. W-3. F.2\nU2.\nX30. W-1.\nM30\n"),
            (Lines{"R 20 0 2", "F 18 0 -1", "F 19 0 -1", "F 15 0 -2"}));
  ControlSettings settings = latheAt(0, 0);
  AxisSettings c;
  c.name = "C";
  c.number = 4;
  settings.axes.push_back(c);
  const IsoRun run = lathe("G0 C30.\nH15.\nH-5.\nM30\n", settings);
  EXPECT_EQ(run.error(), "") << run.message();
  ASSERT_FALSE(run.path.axes.empty());
  EXPECT_NEAR(run.path.axes.back().rotary[0].to, 40.0, 1e-9);
  EXPECT_EQ(lathe("G0 X10. H5.\nM30\n").error(), "fanuc-009");
}

// fan-15-systems
TEST(FanucLathe, SystemsOfGCodes) {
  const Lines turned{"R 18 0 2", "F 18 0 -30", "F 25 0 -30", "R 25 0 2"};
  EXPECT_EQ(latheMoves("G90 X36. Z-30. F.2\nM30\n", latheAt(50, 2)), turned);
  EXPECT_EQ(latheMoves("G77 X36. Z-30. F.2\nM30\n", latheAt(50, 2, {{"gcode_system", 1}})), turned);
  EXPECT_EQ(latheMoves("G20 X36. Z-30. F.2\nM30\n", latheAt(50, 2, {{"gcode_system", 2}})), turned);
  const Lines steps{"R 18 0 -3"};
  EXPECT_EQ(latheMoves("G91 G0 X-14. Z-5.\nM30\n", latheAt(50, 2, {{"gcode_system", 1}})), steps);
  EXPECT_EQ(latheMoves("G70\nG90 G0 X1.\nM30\n", latheAt(50, 2, {{"gcode_system", 2}})),
            (Lines{"R 12.7 0 2"}));
  EXPECT_EQ(lathe("G91 G0 X1.\nM30\n").error(), "fanuc-010");
  EXPECT_EQ(lathe("G0 U1.\nM30\n", latheAt(50, 2, {{"gcode_system", 1}})).error(), "fanuc-009");
  EXPECT_EQ(latheMoves("G10 P1 U10.\nT0101\nG0 X30.\nM30\n", latheAt(50, 2, {{"gcode_system", 1}})),
            (Lines{"R 20 0 2"}));
  // G92 sets coordinates in B and C, G50 in A.
  for (const double system : {1.0, 2.0})
    EXPECT_EQ(latheMoves("G92 X100. Z10.\nG0 X98. Z10.\nM30\n", latheAt(50, 2, {{"gcode_system", system}})),
              (Lines{"R 24 0 2"}));
}

// fan-15-G50
TEST(FanucLathe, SetsCoordinates) {
  EXPECT_EQ(latheMoves("G50 X100. Z10. S1500\nG0 X98. Z9.\nM30\n", latheAt(50, 2)), (Lines{"R 24 0 1"}));
  EXPECT_EQ(latheMoves("G50 U10. W-1.\nG0 X60. Z1.\nM30\n", latheAt(50, 2)), (Lines{}));
  EXPECT_EQ(latheMoves("G50 X100.\nG50.3 X0\nG0 X48.\nM30\n", latheAt(50, 2)), (Lines{"R 24 0 2"}));
}

// fan-15-G50S fan-15-G96 fan-15-G98: acceptance row 46
TEST(FanucLathe, SurfaceSpeedAndItsLimit) {
  const IsoRun run = lathe(
      "G50 S1500\nG96 S200 M3\nG0 X50. Z0\nG99 G1 Z-1. F.2\nG0 X40.\nG1 Z-2.\nG98 G1 Z-3. F100\nG97 S500\n"
      "G1 Z-4.\nM30\n",
      latheAt(60, 5));
  EXPECT_EQ(run.error(), "") << run.message();
  const auto& m = run.path.motions;
  ASSERT_EQ(m.size(), 6U);
  EXPECT_NEAR(m[1].spindle, 1273.2395, 1e-3);
  EXPECT_NEAR(m[1].feed, 0.2 * 1273.2395, 1e-3);
  EXPECT_NEAR(m[3].feed, 0.2 * 1500.0, 1e-6);
  EXPECT_NEAR(m[4].feed, 100.0, 1e-9);
  EXPECT_NEAR(m[5].spindle, 500.0, 1e-9);
}

// fan-15-T haas-18-T
TEST(FanucLathe, ToolsBringTheirOffsets) {
  ControlSettings settings = latheAt(50, 2, {{"offset_x.1", 10.0}, {"offset_z.1", 3.0}, {"wear_x.1", -0.2}});
  // The turret goes where the tip comes to the programmed point: 0.5 (10 - 0.2) = 4.9 and 3 from it.
  EXPECT_EQ(latheMoves("T0101\nG0 X40. Z0\nT0100\nG0 X40. Z0\nM30\n", settings),
            (Lines{"R 24.9 0 3", "R 20 0 0"}));
  EXPECT_EQ(latheMoves("G0 T101 X40. Z0\nM30\n", settings), (Lines{"R 24.9 0 3"}));
  EXPECT_EQ(latheMoves("G0 T0201 X40. Z0\nM30\n", settings), (Lines{"R 24.9 0 3"}));
  settings.parameters["geometry_by"] = 1.0;
  settings.parameters["offset_x.2"] = 20.0;
  EXPECT_EQ(latheMoves("G0 T0201 X40. Z0\nM30\n", settings), (Lines{"R 29.9 0 0"}));
  settings.parameters["lathe_t"] = 1.0;
  EXPECT_EQ(latheMoves("G0 T11 X40. Z0\nM30\n", settings), (Lines{"R 24.9 0 3"}));
  const IsoRun run = lathe("T0101\nG0 X40.\nT0303\nX30.\nM30\n", settings);
  EXPECT_EQ(run.path.motions.back().tool, 30);  // two digits
}

// fan-6-G10lathe
TEST(FanucLathe, WritesOffsets) {
  EXPECT_EQ(latheMoves("G10 P10001 X10. Z3. R.8 Q3\nG10 P1 X-.2\nG10 P1 U.1\nT0101\nG0 X40. Z0\nM30\n",
                       latheAt(50, 2)),
            (Lines{"R 24.95 0 3"}));
  // P0: the shift of all work frames, from the next block on.
  EXPECT_EQ(latheMoves("G10 P0 Z-5.\nG0 X50. Z0\nM30\n", latheAt(50, 2)), (Lines{"R 25 0 -5"}));
  EXPECT_EQ(latheMoves("G10 P0 W-5.\nG10 P0 W-1.\nG0 X50. Z0\nM30\n", latheAt(50, 2)), (Lines{"R 25 0 -6"}));
  EXPECT_EQ(lathe("G10 X1.\nM30\n").error(), "fanuc-031");
  EXPECT_EQ(lathe("G10 P5000 X1.\nM30\n").error(), "fanuc-031");
}

// fan-15-G54
TEST(FanucLathe, FramesAndWorkShift) {
  ControlSettings settings = latheAt(50, 2);
  settings.work_offsets[1] = Vec3(0, 0, -100);
  settings.work_given[1] = true;
  EXPECT_EQ(latheMoves("G55 G0 X50. Z0\nG10 P0 Z2.\nZ0\nM30\n", settings),
            (Lines{"R 25 0 -100", "R 25 0 -98"}));
}

// fan-15-drawing
TEST(FanucLathe, DirectDrawing) {
  // X50 at 30 degrees from X20: dz = 15 / tan 30, towards -Z with 150 degrees.
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG1 X50. ,A150. F.1\nM30\n"), (Lines{"R 10 0 0", "F 25 0 -25.9808"}));
  // Two lines: 90 degrees up from (X20, Z0), 180 degrees through X60 Z-30: they meet at X60 Z0.
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG1 ,A90. F.1\nX60. Z-30. ,A180.\nM30\n"),
            (Lines{"R 10 0 0", "F 30 0 0", "F 30 0 -30"}));
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG1 ,A90. ,C2. F.1\nX60. Z-30. ,A180.\nM30\n"),
            (Lines{"R 10 0 0", "F 28 0 0", "F 30 0 -2", "F 30 0 -30"}));
  EXPECT_EQ(latheMoves("G0 X20. Z0\nG1 X60. ,R5. F.1\nZ-30.\nM30\n"),
            (Lines{"R 10 0 0", "F 25 0 0", "A 30 0 -5 c 25 0 -5 90", "F 30 0 -30"}));
  EXPECT_EQ(lathe("G0 X20. Z0\nG1 ,A180. F.1\nX60. Z-30. ,A180.\nM30\n").error(), "fanuc-057");
}

// fan-15-nose: acceptance row 47
TEST(FanucLathe, NoseCompensationOfAChamfer) {
  const std::string text = "T0101\nG0 X10. Z2.\nG42 G1 X20. Z0 F.1\nX30. Z-5.\nZ-20.\nG40 X40.\nM30\n";
  const IsoRun run = lathe(text, latheAt(50, 10, {{"nose_radius.1", 0.8}, {"tip.1", 3}}));
  EXPECT_EQ(run.error(), "") << run.message();
  // The nose centre, tip + (r, r), stays 0.8 off the chamfer x - z = 10.
  const auto centre = [](const Vec3& p) { return Vec2(p.x() + 0.8, p.z() + 0.8); };
  bool chamfer = false;
  for (const Motion& m : run.path.motions) {
    const Vec2 a = centre(m.from), b = centre(m.to);
    const Vec2 way = b - a;
    if (std::abs(std::abs(way.x()) - std::abs(way.y())) > 1e-9 || way.norm() < 5.0) continue;
    chamfer = true;
    EXPECT_NEAR((b.x() + b.y() - 10.0) / std::sqrt(2.0), 0.8, 1e-6);
  }
  EXPECT_TRUE(chamfer);
  // Without compensation the nose is r (sqrt 2 - 1) off.
  EXPECT_NEAR((0.8 + 0.8) / std::sqrt(2.0) - 0.8, 0.3314, 1e-4);
}

/// The nose of the tool counts where the tables have none.
TEST(FanucLathe, NoseOfTheTool) {
  ControlSettings settings = latheAt(50, 10);
  settings.inserts[1].nose_center = Vec2(0.8, 0.8);
  const std::string text = "T0101\nG0 X10. Z2.\nG42 G1 X20. Z0 F.1\nX30. Z-5.\nZ-20.\nG40 X40.\nM30\n";
  const IsoRun run = lathe(text, settings);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_TRUE(run.tells("fanuc-offset-missing"));
  EXPECT_EQ(run.motions(), lathe(text, latheAt(50, 10, {{"nose_radius.1", 0.8}, {"tip.1", 3}})).motions());
}

// Acceptance row 57.
TEST(FanucLathe, HeadOfAProgram) {
  const IsoRun run = lathe(
      "O1\nG28 U0 W0\nT0101\nG50 S2500\nG96 S150 M3\nG0 X52. Z2.\nG99 G1 X20. F.2\nM30\n", latheAt(200, 100));
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 26 0 2", "F 10 0 2"}));
  // 1000 v / (pi d): 918.2 at X52, 2387.3 at X20; the mean over the way is in between.
  EXPECT_GT(run.path.motions.back().spindle, 918.2);
  EXPECT_LT(run.path.motions.back().spindle, 2387.4);
}

// fan-9-doubleturret fan-9-G68.1
TEST(FanucLathe, RotationAndDoubleTurrets) {
  EXPECT_EQ(lathe("G68\nM30\n").error(), "fanuc-010");
  EXPECT_EQ(latheMoves("G68.1 X0 Z0 R90.\nG1 X20. Z0 F.1\nG69.1\nX20. Z0\nM30\n"),
            (Lines{"F 0 0 -10", "F 10 0 0"}));
}

// fan-16-G36 fan-16-G37
TEST(FanucLathe, MeasuringToolsIsRefused) {
  EXPECT_EQ(lathe("G36 X10.\nM30\n").error(), "fanuc-010");
  EXPECT_EQ(lathe("G37 Z10.\nM30\n").error(), "fanuc-010");
}

}  // namespace
}  // namespace proveout::test
