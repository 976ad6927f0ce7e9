// Work frames, shifts and data input of Fanuc-like mills (iso-fanuc, section 6).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace fanuc_frames_test {
namespace {

using Lines = std::vector<std::string>;

/// A program under G54; motions are told from the G54 that the job names.
IsoRun framed(const std::string& body, const Vec3& g54, const Vec3& g55 = Vec3::Zero(),
              std::map<std::string, double> parameters = {}) {
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.parameters.emplace("rapid", 1);  // straight
  settings.work_offsets[0] = g54;
  settings.work_offsets[1] = g55;
  settings.work_given[0] = settings.work_given[1] = true;
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100\n" + body + "M30\n", settings};
}

IsoRun plain(const std::string& body, std::map<std::string, double> parameters = {}) {
  parameters.emplace("rapid", 1);
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100\n" + body + "M30\n", runAtZero(std::move(parameters))};
}

/// Machine X of the end: motions are told from G54.
double machineX(const IsoRun& run, double g54) { return run.end().x() + g54; }

// fan-6-G92; acceptance 12
TEST(FanucFrames, G92ShiftsAllFrames) {
  const IsoRun run = framed("G0 X30 Y0\nG92 X0\nG1 X10\n", Vec3(100, 50, 0));
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_NEAR(machineX(run, 100), 140, 1e-9);
  const IsoRun other = framed("G0 X30 Y0\nG92 X0\nG55 G1 X0\n", Vec3(100, 50, 0));
  EXPECT_NEAR(machineX(other, 100), 30, 1e-9);
}

// fan-6-G52 with G92: "G52 X5 in front: L = 5, work X30 is machine 135; G92 X0 clears L: S = 35."
TEST(FanucFrames, G92ClearsTheLocalShift) {
  EXPECT_NEAR(machineX(framed("G52 X5\nG1 X30\n", Vec3(100, 50, 0)), 100), 135, 1e-9);
  // S = 35 alone: G55 X0 is machine 35, and G52 X0 changes nothing.
  EXPECT_NEAR(machineX(framed("G52 X5\nG1 X30\nG92 X0\nG55 G1 X0\n", Vec3(100, 50, 0)), 100), 35, 1e-9);
  EXPECT_NEAR(machineX(framed("G52 X5\nG1 X30\nG92 X0\nG52 X0\nG55 G1 X0\n", Vec3(100, 50, 0)), 100), 35,
              1e-9);
}

// fan-6-G52; acceptance 13
TEST(FanucFrames, G52IsAbsoluteInTheFrame) {
  EXPECT_EQ(plain("G52 X5\nG1 X1\nG52 X0\nG1 X1\n").motions(), (Lines{"F 6 0 0", "F 1 0 0"}));
  // Twice the same shift is that shift, under G91 too, and it acts without a motion.
  EXPECT_EQ(plain("G52 X5\nG91 G52 X5\nG90 G1 X1\n").motions(), (Lines{"F 6 0 0"}));
  EXPECT_EQ(plain("G52 X5 Y7\nG52 X0\nG1 X1 Y1\n").motions(), (Lines{"F 1 8 0"}));
}

// fan-6-G92.1
TEST(FanucFrames, G921EndsTheShiftsOfTheNamedAxes) {
  EXPECT_EQ(plain("G52 X5\nG92 Y-3\nG1 X1 Y1\nG92.1 X0 Y0\nG1 X2 Y2\n").motions(),
            (Lines{"F 6 4 0", "F 2 2 0"}));
  EXPECT_EQ(plain("G92 X-3 Y-3\nG92.1 X0\nG1 X2 Y2\n").motions(), (Lines{"F 2 5 0"}));
  EXPECT_NE(plain("G92.1\nG1 X2\n").error(), "");
}

// fan-6-G54 fan-6-G54.1
TEST(FanucFrames, ChoosingAFrameMovesNothing) {
  EXPECT_EQ(framed("G55\nG0 X1\n", Vec3(0, 0, 0), Vec3(10, 0, 0)).motions(), (Lines{"R 11 0 0"}));
  const std::string data = "G10 L20 P1 X7\nG10 L20 P2 X20\nG10 L20 P300 X-4\n";
  EXPECT_EQ(plain(data + "G54.1\nG0 X1\n").motions(), (Lines{"R 8 0 0"}));
  EXPECT_EQ(plain(data + "G54.1 P2\nG0 X1\n").motions(), (Lines{"R 21 0 0"}));
  EXPECT_EQ(plain(data + "G54 P2 G0 X1\n").motions(), (Lines{"R 21 0 0"}));
  EXPECT_EQ(plain(data + "G54.1 P300 X1\n").motions(), (Lines{"R -3 0 0"}));
  EXPECT_EQ(plain("G54.1 P301\n").error(), "fanuc-003");
  EXPECT_EQ(plain("G54.1 P0\n").error(), "fanuc-003");
  // The P of a cycle beside G54 is its dwell.
  const IsoRun cycle = plain("G10 L20 P2 X20\nG0 Z5\nG54 G82 X1 Z-1 R1 P500\nG80\n");
  EXPECT_EQ(cycle.error(), "") << cycle.message();
  EXPECT_EQ(cycle.motions()[1], "R 1 0 5");
}

// fan-6-G10L2 fan-6-EXT fan-6-G10L20; acceptance 14
TEST(FanucFrames, G10SetsAndAddsFrames) {
  EXPECT_EQ(plain("G10 L2 P1 X10\nG91 G10 L2 P1 X5\nG90 G0 X0\n").motions(), (Lines{"R 15 0 0"}));
  EXPECT_EQ(plain("G10 L2 P0 X3 Y1\nG10 L2 P2 X10\nG55 G0 X0 Y0\n").motions(), (Lines{"R 13 1 0"}));
  EXPECT_EQ(plain("G10 L2 P6 Z-2\nG59 G0 X1 Z0\n").motions(), (Lines{"R 1 0 -2"}));
  for (const char* bad : {"G10 L2 X1\n", "G10 L2 P7 X1\n", "G10 L2 P1.5 X1\n", "G10 L20 P0 X1\n",
                          "G10 L20 P301 X1\n", "G10 L2 P-1 X1\n"}) {
    EXPECT_NE(plain(bad).error(), "") << bad;
  }
  EXPECT_EQ(plain("G10 L2 P7 X1\n").error(), "fanuc-031");
  EXPECT_EQ(plain("G10 L2 X1\n").error(), "fanuc-031");
  EXPECT_EQ(plain("G10 L2 P1 I30\n").error(), "fanuc-009");
  EXPECT_EQ(plain("G10 P1 X3\n").error(), "fanuc-missing-data");
  EXPECT_EQ(plain("G10 L99 P1 X3\n").error(), "fanuc-010");
}

// fan-6-G10L10 fan-6-G10L11
TEST(FanucFrames, G10SetsLengths) {
  const std::string use = "G43 H1 G1 Z0\n";
  EXPECT_EQ(plain("G10 L10 P1 R50\n" + use).motions(), (Lines{"F 0 0 50"}));
  EXPECT_EQ(plain("G10 L10 P1 R50\nG10 L11 P1 R-0.5\n" + use).motions(), (Lines{"F 0 0 49.5"}));
  EXPECT_EQ(plain("G10 L10 P1 R50\nG10 L1 P1 R0.5\n" + use).motions(), (Lines{"F 0 0 50.5"}));
  EXPECT_EQ(plain("G10 L10 P1 R50\nG91 G10 L10 P1 R2\nG90\n" + use).motions(), (Lines{"F 0 0 52"}));
  EXPECT_EQ(plain("G20\nG10 L10 P1 R2\nG43 H1 G1 Z0\n").motions(), (Lines{"F 0 0 50.8"}));
  EXPECT_EQ(plain("G10 L10 P0 R5\n").error(), "fanuc-030");
  EXPECT_EQ(plain("G10 L10 P1000 R5\n").error(), "fanuc-030");
  EXPECT_EQ(plain("G10 L10 P1 R10000\n").error(), "fanuc-029");
  EXPECT_EQ(plain("G10 L10 P1\n").error(), "fanuc-missing-data");
  EXPECT_EQ(plain("G10 L10 P1 X5\n").error(), "fanuc-009");
}

// fan-6-G10L12 fan-6-G10L13: radii, or diameters with d_is
TEST(FanucFrames, G10SetsRadii) {
  const std::string use = "G0 X-20 Y-20\nG41 D1 G1 X0\nY40\nG40 X-20\n";
  EXPECT_EQ(plain("G10 L12 P1 R5\n" + use).motions()[1], "F -5 -20 0");
  EXPECT_EQ(plain("G10 L12 P1 R5\nG10 L13 P1 R-0.2\n" + use).motions()[1], "F -4.8 -20 0");
  EXPECT_EQ(plain("G10 L12 P1 R10\nG10 L13 P1 R-0.2\n" + use, {{"d_is", 1}}).motions()[1], "F -4.9 -20 0");
}

// offset memory A: one value a number, for H and D; B: geometry and wear
TEST(FanucFrames, OffsetMemories) {
  const std::string use = "G0 X-20 Y-20\nG43 H1 Z0\nG41 D1 G1 X0\nY40\nG40 X-20\n";
  const IsoRun a = plain("G10 L11 P1 R5\n" + use, {{"offset_memory", 0}});
  EXPECT_EQ(a.motions()[1], "R -20 -20 5");
  EXPECT_EQ(a.motions()[2], "F -5 -20 5");
  EXPECT_EQ(plain("G10 P1 R5\n" + use, {{"offset_memory", 0}}).motions()[2], "F -5 -20 5");
  EXPECT_EQ(plain("G10 L10 P1 R5\n", {{"offset_memory", 0}}).error(), "fanuc-029");
  const IsoRun b = plain("G10 L10 P1 R5\nG10 L11 P1 R1\n" + use, {{"offset_memory", 1}});
  EXPECT_EQ(b.motions()[2], "F -6 -20 6");
  EXPECT_EQ(plain("G10 L12 P1 R5\n", {{"offset_memory", 1}}).error(), "fanuc-029");
}

// "New data of the active frame act from the next block."
TEST(FanucFrames, NewDataOfTheActiveFrameAct) {
  EXPECT_EQ(plain("G0 X1\nG10 L2 P1 X10\nG0 X1\nG91 X1\n").motions(),
            (Lines{"R 1 0 0", "R 11 0 0", "R 12 0 0"}));
}

// fan-6-G10L50
TEST(FanucFrames, ParametersFromThePrograms) {
  const std::string use = "G0 X20 Y0\nG41 D1 G1 X0 Y0\nY30\nG40 X-20\n";
  const std::string set = "G10 L12 P1 R5\nG10 L52\nN5003 R00000001\nG11\n";
  // Type B comes by way of the corner: acceptance 17.
  EXPECT_EQ(plain(set + use).motions()[1], "F -5 -5 0");
  EXPECT_EQ(plain("G10 L12 P1 R5\nG10 L50\nN5003 R0\nG11\n" + use).motions()[1], "F -5 0 0");
  EXPECT_EQ(plain("G10 L52\nN5004 Q2 R1\nG11\nG10 L12 P1 R10\n" + use).motions()[1], "F -5 0 0");
  EXPECT_EQ(plain("G10 L52\nN5004 R00000100\nG11\nG10 L12 P1 R10\n" + use).motions()[1], "F -5 0 0");
  // 3410 in least increments: 0.5 mm.
  EXPECT_EQ(plain("G10 L52\nN3410 R500\nG11\nG2 X10 I5.1\n").error(), "");
  const IsoRun unknown = plain("G10 L52\nN1320 P1 R500000\nG11\nG0 X1\n");
  EXPECT_EQ(unknown.error(), "") << unknown.message();
  EXPECT_TRUE(unknown.tells("fanuc-parameter"));
  EXPECT_NE(plain("G10 L52\nN3410\nG11\n").error(), "");
  EXPECT_NE(plain("G10 L52\nX5\nG11\n").error(), "");
}

// fan-6-G10L3 fan-7-life
TEST(FanucFrames, ToolLifeIsNoted) {
  const IsoRun run = plain("G10 L3\nP1 L100\nT1 H1 D1\nT2 H2 D2\nG11\nG0 X1\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_TRUE(run.tells("fanuc-tool-life"));
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0"}));
}

}  // namespace
}  // namespace fanuc_frames_test
}  // namespace proveout::test
