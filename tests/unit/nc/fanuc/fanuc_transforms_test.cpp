// Rotation, scaling, mirroring and polar data of Fanuc-like mills (iso-fanuc, section 9).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace fanuc_transforms_test {
namespace {

using Lines = std::vector<std::string>;

IsoRun mill(const std::string& body, std::map<std::string, double> parameters = {}) {
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.parameters.emplace("rapid", 1);  // straight
  settings.radius_offsets[1] = {5.0, 0.0};
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100\n" + body + "M30\n", settings};
}
Lines motions(const std::string& body, std::map<std::string, double> parameters = {}) {
  const IsoRun run = mill(body, std::move(parameters));
  EXPECT_EQ(run.error(), "") << body << run.message();
  return run.motions();
}

// fan-9-G68 fan-9-G69; acceptance 21
TEST(FanucTransforms, Rotates) {
  EXPECT_EQ(motions("G68 X10 Y0 R30\nG1 X30 Y10\n"), (Lines{"F 22.3205 18.6603 0"}));
  EXPECT_EQ(motions("G68 X0 Y0 R90\nG1 X10 Y0\nG69\nX10 Y0\n"), (Lines{"F 0 10 0", "F 10 0 0"}));
  // Without a centre it is the tool's place, without an angle the angle is 0.
  EXPECT_EQ(motions("G1 X10 Y10\nG68 R90\nX20 Y10\n"), (Lines{"F 10 10 0", "F 10 20 0"}));
  EXPECT_EQ(motions("G68 X0 Y0\nG1 X20 Y10\n"), (Lines{"F 20 10 0"}));
  // The centre is absolute under G91 too.
  EXPECT_EQ(motions("G0 X10\nG91 G68 X0 Y0 R90\nG90 G1 X20 Y0\n"), (Lines{"R 10 0 0", "F 0 20 0"}));
  EXPECT_EQ(motions("G18 G68 X0 Z0 R90\nG1 Z10 X0\n"), (Lines{"F 10 0 0"}));
}

// fan-9-G68inc; acceptance 22
TEST(FanucTransforms, StepsTurnAboutTheTool) {
  EXPECT_EQ(motions("G1 X10\nG68 X0 Y0 R90\nG91 X5\n"), (Lines{"F 10 0 0", "F 10 5 0"}));
  // Then an absolute word counts about the centre, and the other axis from where the program has it.
  EXPECT_EQ(motions("G1 X10\nG68 X0 Y0 R90\nG91 X5\nG90 X20\n"), (Lines{"F 10 0 0", "F 10 5 0", "F 0 20 0"}));
  EXPECT_EQ(motions("G1 X10\nG68 X0 Y0 R90\nX20\n"), (Lines{"F 10 0 0", "F 0 20 0"}));
  EXPECT_EQ(motions("G1 X10\nG68 X0 Y0 R90\nZ5\n"), (Lines{"F 10 0 0", "F 10 0 5"}));
}

TEST(FanucTransforms, StepsBehindG69CountFromTheUnturnedPlace) {
  const IsoRun run = mill("G68 X0 Y0 R90\nG1 X10 Y0\nG69\nG91 X5\n");
  EXPECT_EQ(run.motions(), (Lines{"F 0 10 0", "F 15 10 0"}));
  EXPECT_TRUE(run.tells("fanuc-step-after-frame"));
  EXPECT_FALSE(mill("G68 X0 Y0 R90\nG1 X10 Y0\nG69\nX5 Y5\n").tells("fanuc-step-after-frame"));
}

TEST(FanucTransforms, AngleUnderG91) {
  const std::string body = "G68 X0 Y0 R30\nG91 G68 X0 Y0 R60\nG90 G1 X10 Y0\n";
  EXPECT_EQ(motions(body), (Lines{"F 5 8.6603 0"}));
  EXPECT_EQ(motions(body, {{"g68_r_incremental", 1}}), (Lines{"F 0 10 0"}));
}

TEST(FanucTransforms, PlaneAndFramesInRotation) {
  EXPECT_EQ(mill("G68 X0 Y0 R30\nG18\nG1 X1\n").error(), "fanuc-144");
  EXPECT_EQ(mill("G51 X0 Y0 P2000\nG18\nG1 X1\n").error(), "fanuc-049");
  EXPECT_EQ(mill("G68 X0 Y0 R30\nG69 G18\nG1 X1\n").error(), "");
  EXPECT_TRUE(mill("G68 X0 Y0 R30\nG55\nG1 X1 Y1\n").tells("fanuc-frame-in-rotation"));
}

// Compensation acts after the rotation: the square of section 8 turned by 90 degrees.
TEST(FanucTransforms, CompensationActsAfterTheRotation) {
  EXPECT_EQ(motions("G68 X0 Y0 R90\nG0 X-20 Y-20\nG41 D1 G1 X0\nY40\nX40\nG40 Y60\n"),
            (Lines{"R 20 -20 0", "F 20 -5 0", "F -45 -5 0", "F -45 40 0", "F -60 40 0"}));
}

// fan-9-G51 fan-9-G50; acceptance 23
TEST(FanucTransforms, Scales) {
  EXPECT_EQ(motions("G51 X0 Y0 P2000\nG1 X10 Y5\nG50\nX10 Y5\n"), (Lines{"F 20 10 0", "F 10 5 0"}));
  EXPECT_EQ(motions("G51 X0 Y0 P2.\nG1 X10 Y5\n"), (Lines{"F 20 10 0"}));
  EXPECT_EQ(motions("G51 X0 Y0 P200000\nG1 X10 Y5\n", {{"scale_unit", 0.00001}}), (Lines{"F 20 10 0"}));
  EXPECT_EQ(motions("G51 X10 Y0 Z0 P500\nG1 X20 Y10 Z10\n"), (Lines{"F 15 5 5"}));
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J3000\nG1 X10 Y5 Z1\n"), (Lines{"F 20 15 1"}));
  EXPECT_EQ(motions("G51 X0 Y0 I-1000 J1000\nG1 X10 Y5\n"), (Lines{"F -10 5 0"}));
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J3000\nG1 X10 Y5\n", {{"decimal", 1}}), (Lines{"F 0.02 0.015 0"}));
  // The centre is where the tool is.
  EXPECT_EQ(motions("G1 X10 Y10\nG51 P2000\nX20 Y10\n"), (Lines{"F 10 10 0", "F 30 10 0"}));
  EXPECT_EQ(mill("G51 X0 Y0 P0\n").error(), "fanuc-142");
  EXPECT_EQ(mill("G51 X0 Y0 P-2000\n").error(), "fanuc-142");
  EXPECT_EQ(mill("G41 D1 G1 X5 Y5\nG51 X0 Y0 P2000\n").error(), "fanuc-141");
}

// Q and the retract of G73 are not scaled: R 4, Z -12, pecks of 5, 0.5 back.
TEST(FanucTransforms, PecksAreNotScaled) {
  EXPECT_EQ(motions("G0 Z10\nG51 X0 Y0 Z0 P2000\nG99 G73 X5 Z-6 R2 Q5\nG80\n"),
            (Lines{"R 0 0 10", "R 10 0 10", "R 10 0 4", "F 10 0 -1", "R 10 0 -0.5", "F 10 0 -6",
                   "R 10 0 -5.5", "F 10 0 -11", "R 10 0 -10.5", "F 10 0 -12", "R 10 0 4"}));
}

// fan-9-G51arc
TEST(FanucTransforms, ArcsWithUnequalFactors) {
  // R times the larger factor.
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J1000\nG2 X10 Y0 R5\n"), (Lines{"A 20 0 0 c 10 0 0 -180"}));
  EXPECT_EQ(motions("G51 X0 Y0 I1000 J2000\nG2 X5 Y5 R5\n").size(), 1u);
  // Start, centre and end by themselves: from (0,0) about (10,0) to (10,5), radius 10 to 5.
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J1000\nG2 X5 Y5 I5 J0\n"), (Lines{"A 10 5 0 c 10 0 0 -90"}));
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J1000\nG3 I5\n"), (Lines{"A 0 0 0 c 10 0 0 360"}));
  // Equal factors keep arcs.
  EXPECT_EQ(motions("G51 X0 Y0 P2000\nG2 X5 Y5 I5 J0\n"), (Lines{"A 10 10 0 c 10 0 0 -90"}));
}

// fan-9-G51.1 fan-9-G50.1
TEST(FanucTransforms, Mirrors) {
  EXPECT_EQ(motions("G51.1 X10\nG1 X30 Y5\nG50.1 X0\nX30 Y5\n"), (Lines{"F -10 5 0", "F 30 5 0"}));
  EXPECT_EQ(motions("G51.1 X0 Y0\nG1 X30 Y5\nG50.1 X0\nX30 Y5\n"), (Lines{"F -30 -5 0", "F 30 -5 0"}));
  EXPECT_EQ(motions("G51.1 X0 Y0\nG50.1\nG1 X30 Y5\n"), (Lines{"F 30 5 0"}));
}

// fan-9-mirrorcomp
TEST(FanucTransforms, OneMirroredAxisSwaps) {
  EXPECT_EQ(motions("G51.1 X0\nG2 X10 Y10 I10 J0\n"), (Lines{"A -10 10 0 c -10 0 0 90"}));
  EXPECT_EQ(motions("G51.1 X0 Y0\nG2 X10 Y10 I10 J0\n"), (Lines{"A -10 -10 0 c -10 0 0 -90"}));
  EXPECT_EQ(motions("G51.1 X0\nG68 X0 Y0 R30\nG1 X10 Y0\n"), (Lines{"F -8.6603 5 0"}));
  // The picture of the compensated square is the mirrored picture.
  EXPECT_EQ(motions("G51.1 X0\nG0 X-20 Y-20\nG41 D1 G1 X0\nY40\nX40\nG40 Y60\n"),
            (Lines{"R 20 -20 0", "F 5 -20 0", "F 5 45 0", "F -40 45 0", "F -40 60 0"}));
}

// fan-9-order; acceptance 24
TEST(FanucTransforms, Order) {
  EXPECT_EQ(motions("G51.1 X0\nG51 X0 Y0 P2000\nG68 X0 Y0 R90\nG1 X10 Y5\n"), (Lines{"F 10 20 0"}));
  EXPECT_EQ(motions("G51 X0 Y0 P2000\nG68 X0 Y0 R90\nG1 X10 Y5\n"), (Lines{"F -10 20 0"}));
  // The order in which they are switched on does not count.
  EXPECT_EQ(motions("G68 X0 Y0 R90\nG51 X0 Y0 P2000\nG51.1 X0\nG1 X10 Y5\n"), (Lines{"F 10 20 0"}));
  // The centre of the rotation is scaled, and mirrored: S(c) = (20,0), then (-20,0).
  EXPECT_EQ(motions("G51 X0 Y0 P2000\nG68 X10 Y0 R90\nG1 X15 Y0\n"), (Lines{"F 20 10 0"}));
  EXPECT_EQ(motions("G51.1 X0\nG51 X0 Y0 P2000\nG68 X10 Y0 R90\nG1 X15 Y0\n"), (Lines{"F -20 10 0"}));
  // Unequal factors: scaling first, then rotation.
  EXPECT_EQ(motions("G51 X0 Y0 I2000 J1000\nG68 X0 Y0 R90\nG1 X10 Y5\n"), (Lines{"F -5 20 0"}));
  // A negative factor acts as the mirror.
  EXPECT_EQ(motions("G51 X0 Y0 I-2000 J2000\nG68 X0 Y0 R90\nG1 X10 Y5\n"), (Lines{"F 10 20 0"}));
  EXPECT_TRUE(mill("G68 X0 Y0 R90\nG51 X0 Y0 I-2000 J2000\n").tells("fanuc-negative-factor"));
  EXPECT_TRUE(mill("G51 X0 Y0 P2000\nG68 X0 Y0 R90\nG50\nG69\n").tells("fanuc-transform-order"));
  EXPECT_FALSE(mill("G51 X0 Y0 P2000\nG68 X0 Y0 R90\nG69\nG50\n").tells("fanuc-transform-order"));
}

// fan-9-G16 fan-9-G15; acceptance 25
TEST(FanucTransforms, PolarData) {
  EXPECT_EQ(motions("G16 G1 X50 Y30\nY120\nY210\n"),
            (Lines{"F 43.3013 25 0", "F -25 43.3013 0", "F -43.3013 -25 0"}));
  EXPECT_EQ(motions("G16 G1 X50 Y30\nG91 Y90\nY90\nG15 G90 X1 Y1\n"),
            (Lines{"F 43.3013 25 0", "F -25 43.3013 0", "F -43.3013 -25 0", "F 1 1 0"}));
  // G91 radius: the pole is the tool.
  EXPECT_EQ(motions("G1 X10\nG16 G91 X5 Y90\n"), (Lines{"F 10 0 0", "F 10 5 0"}));
  // The pole is the zero of the frame in force.
  EXPECT_EQ(motions("G52 X100\nG16 G1 X50 Y90\n"), (Lines{"F 100 50 0"}));
  EXPECT_EQ(motions("G16 G1 X50 Y0\nG3 Y90 R50\n"), (Lines{"F 50 0 0", "A 0 50 0 c 0 0 0 90"}));
  EXPECT_EQ(mill("G16 G1 X50 Y0\nG3 Y90 I-50\n").error(), "fanuc-polar-arc");
}

}  // namespace
}  // namespace fanuc_transforms_test
}  // namespace proveout::test
