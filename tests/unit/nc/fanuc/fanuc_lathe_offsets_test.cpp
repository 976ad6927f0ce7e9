// Tool offsets of lathes: geometry and wear, machine moves, and what variables tell of a lathe.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

/// Offset 1: X 10, Z 3, worn by -0.2 and 0.5; the turret at X50 Z2.
ControlSettings worn(std::map<std::string, double> parameters = {}) {
  parameters.insert({{"offset_x.1", 10}, {"offset_z.1", 3}, {"wear_x.1", -0.2}, {"wear_z.1", 0.5}});
  return latheAt(50, 2, std::move(parameters));
}

// fan-15-T
TEST(FanucLatheOffsets, WearMovesWithTheNextMotionOfItsAxis) {
  // Absolute words go to the place; the step goes the change of the wear farther, of geometry it does not.
  EXPECT_EQ(turned("G21 T0101\nG0 X40.\nZ0\nM30\n", worn()), (Lines{"R 49.8 2", "R 49.8 3.5"}));
  EXPECT_EQ(turned("G21 T0101\nG0 U-4.\nW-1.\nM30\n", worn()), (Lines{"R 45.8 2", "R 45.8 1.5"}));
  EXPECT_EQ(turned("G21 T0101\nG0 X40. Z0\nT0100\nU0\nW0\nM30\n", worn()),
            (Lines{"R 49.8 3.5", "R 50 3.5", "R 50 3"}));
  EXPECT_TRUE(lathe("G21 T0101\nG0 X40.\nM30\n", worn()).tells("fanuc-setting"));
}

TEST(FanucLatheOffsets, WearMovesWithTheBlockOfT) {
  const ControlSettings settings = worn({{"wear_moves", 1}});
  EXPECT_EQ(turned("G21 T0101\nG0 U-4.\nM30\n", settings), (Lines{"R 49.8 2.5", "R 45.8 2.5"}));
  EXPECT_EQ(turned("G21 G0 X40. T0101\nZ0\nT0100\nM30\n", settings),
            (Lines{"R 49.8 2.5", "R 49.8 3.5", "R 50 3"}));
  EXPECT_EQ(turned("G21 G98 G1 F100\nT0101\nM30\n", settings), (Lines{"F 49.8 2.5"}));
  EXPECT_EQ(lathe("G21 G98 G1\nT0101\nM30\n", settings).error(), "fanuc-011");
}

// fan-5-latheoffset
TEST(FanucLatheOffsets, MachineMovesSuspendTheOffset) {
  ControlSettings settings = worn();
  settings.reference_points[0] = Vec3(100, 0, 200);
  // The turret goes to the machine's point, whatever the offset is; the next block has the offset again.
  EXPECT_EQ(turned("G21 T0101\nG0 X40. Z0\nG53 X0 Z0\nX40. Z0\nM30\n", settings),
            (Lines{"R 49.8 3.5", "R 0 0", "R 49.8 3.5"}));
  EXPECT_EQ(turned("G21 T0101\nG0 X40. Z0\nG28 U0 W0\nX40. Z0\nM30\n", settings),
            (Lines{"R 49.8 3.5", "R 200 200", "R 49.8 3.5"}));
  EXPECT_EQ(turned("G21 T0101\nG0 X40. Z0\nG28 U0\nW-1.\nM30\n", settings),
            (Lines{"R 49.8 3.5", "R 200 3.5", "R 200 2.5"}));
  const IsoRun run = lathe("G21 T0101\nG0 X40. Z0\nG53 X0 Z0\nX40. Z0\nG28 U0 W0\nX40.\nM30\n", settings);
  EXPECT_FALSE(run.tells("fanuc-length-ended")) << "the offset of a lathe comes back by itself";
}

/// The value of a variable behind blocks.
double latheValue(const std::string& blocks, int variable, const ControlSettings& settings) {
  const IsoRun run = lathe(fmt::format("G21\n{}\n#101=#{}\nG0 Z[#101+0]\nM30\n", blocks, variable), settings);
  EXPECT_EQ(run.error(), "") << run.message();
  return run.end().z();
}

// fan-13-position: a lathe has X and Z as axes 1 and 2
TEST(FanucLatheOffsets, ZIsTheSecondAxis) {
  const ControlSettings settings = latheAt(50, 2);
  EXPECT_NEAR(latheValue("G0 X40. Z7.", 5001, settings), 40.0, 1e-9);
  EXPECT_NEAR(latheValue("G0 X40. Z7.", 5002, settings), 7.0, 1e-9);
  EXPECT_NEAR(latheValue("G10 L2 P2 Z-3.", 5242, settings), -3.0, 1e-9);
  // Haas counts Y in between.
  EXPECT_NEAR(latheValue("G0 X40. Z7.", 5003, latheAt(50, 2, {{"flavour", 1}})), 7.0, 1e-9);
}

// fan-13-modal: codes as the system of G codes in force writes them
TEST(FanucLatheOffsets, ModalCodesAreThoseOfTheSystem) {
  struct Row {
    double system;
    const char* blocks;
    int variable;
    double code;
  };
  for (const Row& row : {Row{0, "G97 S500 M3\nG90 X40. Z1. F.2", 4001, 90},
                         {0, "G97 S500 M3\nG92 X40. Z1. F1.", 4001, 92},
                         {0, "G94 X40. Z1. F.2", 4001, 94},
                         {0, "G97 S500 M3\nG32 Z1. F1.", 4001, 32},
                         {0, "G98", 4005, 98},
                         {0, "G99", 4005, 99},
                         {0, "G1 Z1. F.2", 4001, 1},
                         {0, "G96 S100", 4002, 96},
                         {0, "G18", 4016, 18},
                         {0, "", 4003, 0},
                         {0, "G85 Z-1. R0 F.1", 4010, 85},
                         {0, "G89 X-1. R0 F.1", 4010, 89},
                         {1, "G97 S500 M3\nG77 X40. Z1. F.2", 4001, 77},
                         {1, "G97 S500 M3\nG33 Z1. F1.", 4001, 33},
                         {1, "G95", 4005, 95},
                         {1, "G91", 4003, 91},
                         {2, "G97 S500 M3\nG20 X40. Z1. F.2", 4001, 20},
                         {2, "G97 S500 M3\nG21 X40. Z1. F1.", 4001, 21},
                         {2, "", 4006, 71}}) {
    const std::string unit = row.system == 2 ? "G71" : "G21";
    const IsoRun run = lathe(fmt::format("{}\n{}\n#101=#{}\nG80\n{}G0 Z[#101+0]\nM30\n", unit, row.blocks,
                                         row.variable, row.system == 0 ? "" : "G90 "),
                             latheAt(50, 2, {{"gcode_system", row.system}}));
    EXPECT_EQ(run.error(), "") << row.blocks << run.message();
    EXPECT_NEAR(run.end().z(), row.code, 1e-9) << row.system << " " << row.blocks;
  }
}

/// Length offsets of mills are no codes of a lathe.
TEST(FanucLatheOffsets, CodesOfMillsAreRefused) {
  for (const char* code : {"G43 Z1.", "G44 Z1.", "G45 X1.", "G48 X1.", "G49"})
    EXPECT_EQ(lathe(std::string("G21\n") + code + "\nM30\n").error(), "fanuc-010") << code;
}

}  // namespace
}  // namespace proveout::test
