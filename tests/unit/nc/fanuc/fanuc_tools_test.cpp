// Tools, length offsets and position offsets of Fanuc-like mills (iso-fanuc, section 7).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace fanuc_tools_test {
namespace {

using Lines = std::vector<std::string>;

IsoRun mill(const std::string& body, std::map<std::string, double> parameters = {}) {
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.parameters.emplace("rapid", 1);  // straight
  settings.length_offsets[1] = {50.0, 0.0};
  settings.length_offsets[2] = {70.0, 0.5};
  settings.radius_offsets[1] = {5.0, 0.0};
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100\n" + body + "M30\n", settings};
}

// fan-7-G43 fan-7-G44 fan-7-G49; acceptance 15: the spindle nose. Motions are told of the nose here, as no
// tool is in it.
TEST(FanucTools, LengthOffsets) {
  EXPECT_EQ(mill("G43 H1 G0 Z10\nG44 H1 Z10\nG49 Z10\n").motions(),
            (Lines{"R 0 0 60", "R 0 0 -40", "R 0 0 10"}));
  EXPECT_EQ(mill("G43 H2 G0 Z10\nH1 Z10\nH0 Z10\n").motions(), (Lines{"R 0 0 80.5", "R 0 0 60", "R 0 0 10"}));
  // The block with the axis ends at the compensated point, as a step too.
  EXPECT_EQ(mill("G91 G43 H1 G0 Z0\nZ1\n").motions(), (Lines{"R 0 0 50", "R 0 0 51"}));
  EXPECT_EQ(mill("G0 Z5\nG91 G43 H1 Z2\nG49 Z0\n").motions(), (Lines{"R 0 0 5", "R 0 0 57", "R 0 0 7"}));
}

// fan-7-g43alone
TEST(FanucTools, G43AloneActsWithTheNextMotionOfItsAxis) {
  const IsoRun run = mill("G43 H1\nG0 X5\nZ10\n");
  EXPECT_EQ(run.motions(), (Lines{"R 5 0 0", "R 5 0 60"}));
  EXPECT_TRUE(run.tells("fanuc-length-waits"));
  EXPECT_EQ(mill("G43 H1\nG91 G0 X5\nZ3\nZ1\n").motions(), (Lines{"R 5 0 0", "R 5 0 53", "R 5 0 54"}));
  EXPECT_EQ(mill("G43 H1 Z0\nG49\nG0 X1\nG91 Z-1\n").motions(), (Lines{"R 0 0 50", "R 1 0 50", "R 1 0 -1"}));
  EXPECT_FALSE(mill("G43 H1 Z10\n").tells("fanuc-length-waits"));
  // Twice the same number waits for nothing.
  EXPECT_EQ(mill("G43 H1 G0 Z0\nG43 H1\nG91 Z1\n").motions(), (Lines{"R 0 0 50", "R 0 0 51"}));
  // Two numbers before a motion: the last counts.
  EXPECT_EQ(mill("G43 H1\nG43 H2\nG91 G0 Z1\n").motions(), (Lines{"R 0 0 71.5"}));
}

// Acceptance 58, fan-5-lengthsuspend: machine moves are of the nose, and end the vector of their axis.
TEST(FanucTools, MachineMovesEndTheVector) {
  ControlSettings settings = runAtZero({{"rapid", 1}});
  settings.work_offsets[0] = Vec3(0, 0, -300);
  settings.work_given[0] = true;
  settings.start = Vec3(0, 0, 100);
  settings.length_offsets[1] = {50.0, 0.0};
  settings.gauge_lengths[1] = 50.0;
  settings.tool = 1;
  const std::string head = "O1\nG21 G90 G17 G54\nG43 H1 G0 Z5\nG90 G0 G53 Z0\n";
  const IsoRun run(ControlId::kFanucMill, head + "Z10\nM30\n", settings);
  EXPECT_EQ(run.error(), "") << run.message();
  const Lines all = run.motions();
  ASSERT_GE(all.size(), 3u);
  EXPECT_EQ(all[all.size() - 2], "R 0 0 250");
  EXPECT_EQ(all.back(), "R 0 0 10");
  EXPECT_TRUE(run.tells("fanuc-length-ended"));
  EXPECT_FALSE(
      IsoRun(ControlId::kFanucMill, head + "G43 H1 Z10\nM30\n", settings).tells("fanuc-length-ended"));
  EXPECT_FALSE(IsoRun(ControlId::kFanucMill, head + "X10\nM30\n", settings).tells("fanuc-length-ended"));
}

// Types A, B, C by length_type
TEST(FanucTools, AxisOfTheLength) {
  EXPECT_EQ(mill("G18 G43 H1 G0 Y10 Z10\n", {{"length_type", 0}}).motions(), (Lines{"R 0 10 60"}));
  EXPECT_EQ(mill("G18 G43 H1 G0 Y10 Z10\n", {{"length_type", 1}}).motions(), (Lines{"R 0 60 10"}));
  EXPECT_EQ(mill("G43 H1 G0 X10\nH2 X10 Y1\n", {{"length_type", 2}}).motions(),
            (Lines{"R 60 0 0", "R 80.5 1 0"}));
  EXPECT_EQ(mill("G43 H1\n", {{"length_type", 2}}).error(), "fanuc-027");
}

// fan-7-hmissing
TEST(FanucTools, AMissingNumberIsToldWithItsTool) {
  const IsoRun run = mill("T7 M6\nG43 H9 G0 Z10\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions().back(), "R 0 0 10");
  bool told = false;
  for (const Diagnostic& d : run.path.diagnostics.all()) {
    told = told || (d.code == "fanuc-offset-missing" && d.message.find("H9") != std::string::npos &&
                    d.message.find("tool 7") != std::string::npos);
  }
  EXPECT_TRUE(told);
  EXPECT_EQ(mill("G43 H1000 Z1\n").error(), "fanuc-030");
  EXPECT_EQ(mill("G43 H1.5 Z1\n").error(), "fanuc-007");
}

// fan-7-T fan-7-M06
TEST(FanucTools, TChoosesAndM06Brings) {
  const auto tools = [](const IsoRun& run) {
    std::vector<int> all;
    for (const Motion& m : run.path.motions) all.push_back(m.tool);
    return all;
  };
  EXPECT_EQ(tools(mill("T1 M6\nG0 X1\nT2\nX2\nM6\nX3\nM6 T5\nX4\n")), (std::vector<int>{1, 1, 2, 5}));
  EXPECT_TRUE(mill("M6\nG0 X1\n").tells("fanuc-no-t"));
}

// fan-7-G45 fan-7-G46 fan-7-G47 fan-7-G48
TEST(FanucTools, PositionOffsets) {
  EXPECT_EQ(mill("G91 G45 G1 X20 D1\nG46 X20\nG47 X20\nG48 X20\n").motions(),
            (Lines{"F 25 0 0", "F 40 0 0", "F 70 0 0", "F 80 0 0"}));
  EXPECT_EQ(mill("G91 G45 G1 X-20 Y20 D1\n").motions(), (Lines{"F -25 25 0"}));
  EXPECT_EQ(mill("D1\nG45 G1 X20\nG45 X10\n").motions(), (Lines{"F 25 0 0", "F 5 0 0"}));
  EXPECT_EQ(mill("G91 G45 G1 X0 D1\nG46 X-0\n").motions(), (Lines{"F 5 0 0", "F 10 0 0"}));
  // A quarter circle grows with its ends.
  EXPECT_EQ(mill("G91 G45 G3 X30 Y30 J30 D1\n").motions(), (Lines{"A 35 35 0 c 0 35 0 90"}));
  EXPECT_EQ(mill("G41 D1 G1 X10 Y10\nG45 X20\n").error(), "fanuc-042");
}

}  // namespace
}  // namespace fanuc_tools_test
}  // namespace proveout::test
