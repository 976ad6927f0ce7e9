// Cutter compensation of LinuxCNC, against rs274 (2.9).
// Points are machine coordinates: those of rs274 with its offsets and turns added.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

// clang-format off: one case a row
const std::vector<LcnCase> kLcnCompensationCases{
    // lcn-4-G42 lcn-4-corner
    {"closed contour outside",
     "T1 M6\nG0 Y-20\nG42 G1 X10 Y0\nX50\nY30\nX10\nY0\nG40 G1 X0 Y-20",
     {"R 0 -20 0", "F 13.0902 -5 0", "F 50 -5 0", "A 55 0 0 c 50 0 0 90", "F 55 30 0",
      "A 50 35 0 c 50 30 0 90", "F 10 35 0", "A 5 30 0 c 10 30 0 90", "F 5 0 0", "F 0 -20 0"},
     ""},
    // lcn-4-G41.1 lcn-4-corner
    {"closed contour, left",
     "G41.1 D10 G1 X10 Y0\nY-30\nX50\nY0\nX10\nG40 G1 X0 Y20",
     {"F 10 5 0", "A 15 0 0 c 10 0 0 -90", "F 15 -25 0", "F 45 -25 0", "F 45 -5 0", "F 10 -5 0", "F 0 20 0"},
     ""},
    // lcn-4-G41.1
    {"an arc inside",
     "G41.1 D6 G1 X10\nG3 X20 Y10 J10\nG1 Y20\nG40 G0 X0",
     {"F 10 3 0", "A 17 10 0 c 10 10 0 90", "F 17 20 0", "R 0 20 0"},
     ""},
    // lcn-4-corner
    {"slanted corners",
     "G41.1 D6 G1 X10\nX20 Y10\nX10 Y20\nG40 G1 X0",
     {"F 8.7574 3 0", "F 15.7574 10 0", "F 7.8787 17.8787 0", "F 0 20 0"},
     ""},
    // lcn-4-gouge
    {"a concave corner that is too narrow",
     "G41.1 D10 G1 X20 Y0\nX23\nY3\nX40",
     {"F 20 5 0"},
     "linuxcnc-comp"},
    // lcn-4-entry
    {"the way in too short", "T1 M6\nG42 G1 X4 Y0", {}, "linuxcnc-comp"},
    // lcn-4-entry
    {"only Z in the way in", "G41.1 D4 G1 Z-1", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"another frame", "G41.1 D4 G1 X10\nG55", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"G28 inside", "G41.1 D4 G1 X10\nG28", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"tool change inside", "G41.1 D4 G1 X10\nT1 M6", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"another plane", "G41.1 D4 G1 X10\nG18", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"on when on", "G41.1 D4 G1 X10\nG41.1 D4", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"G92 inside", "G41.1 D4 G1 X10\nG92 X0", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"G43 inside", "G41.1 D4 G1 X10\nG43.1 Z1", {}, "linuxcnc-comp"},
    // lcn-4-comperr
    {"G53 inside", "G41.1 D4 G1 X10\nG53 G1 X2", {}, "linuxcnc-comp"},
    // lcn-4-gouge
    {"an arc smaller than the tool", "G41.1 D10 G1 X10\nG3 X14 Y4 J4", {}, "linuxcnc-comp"},
    // lcn-4-G40
    {"an arc right behind",
     "G41.1 D4 G1 X10\nX20\nG40\nG3 X30 R10",
     {"F 10 2 0", "F 20 2 0"},
     "linuxcnc-comp"},
    // lcn-4-G40
    {"G40 alone, then a step",
     "G41.1 D4 G1 X10\nX20\nG40\nG91 G1 X1",
     {"F 10 2 0", "F 20 2 0", "F 21 0 0"},
     ""},
    // lcn-4-G42.1
    {"from the right",
     "G42.1 D6 G1 X10\nY10\nX0\nG40\nG1 X-20",
     {"F 10 -3 0", "A 13 0 0 c 10 0 0 90", "F 13 10 0", "A 10 13 0 c 10 10 0 90", "F 0 13 0", "F -20 10 0"},
     ""},
    // lcn-4-G41
    {"by the tool of D", "G41 D2 G1 X10\nY10\nG40 X0", {"F 7 3 0", "F 7 10 0", "F 0 10 0"}, ""},
    // lcn-4-corner
    {"a corner of less than 0.05 rad",
     "G41.1 D4 G1 X20\nX30\nX40 Y0.49\nX50 Y-1\nG40 X60",
     {"F 20 2 0", "F 30 2 0", "F 39.9021 2.4876 0", "A 40.2947 2.4682 0 c 40 0.49 0 -11.28",
      "F 50.2947 0.9782 0", "F 60 -1 0"},
     ""},
    // lcn-4-corner
    {"the way in by an arc",
     "G0 X-20\nG41.1 D4 G2 X0 Y0 R15\nG1 X10\nG40 X20",
     {"R -20 0 0", "A 0.7327 2 0 c -8.6087 -9.6248 0 -88.5892", "F 10 2 0", "F 20 0 0"},
     ""},
    // lcn-4-corner
    {"rapids go straight around corners",
     "G0 X-20\nG41.1 D4 G1 X0\nX10\nG0 Y-5 Z2\nG1 X0\nG40 X20",
     {"R -20 0 0", "F 0 2 0", "F 10 2 0", "R 12 0 0", "R 12 -5 2", "A 10 -7 2 c 10 -5 2 -90", "F 0 -7 2",
      "F 20 -5 2"},
     ""},
    // lcn-4-gouge
    {"a line that runs back is told at its end",
     "G0 X-24 Y8\nT1 M6\nG41 G1 X0 Y0\nG1 Y6\nX9\nG1 Y0",
     {"R -24 8 0", "F -5 6.9371 0"},
     "linuxcnc-comp"},
    // lcn-4-orient
    {"orientation 2 by L",
     "G18 G8\nG0 X20 Z5\nG41.1 D2 L2 G1 X10 Z0\nZ-10\nX15\nG40 G1 X30",
     {"R 20 0 5", "F 8.5528 0 -0.1056", "A 8 0 -1 c 9 0 -1 -63.4349", "F 8 0 -11", "A 9 0 -12 c 9 0 -11 -90",
      "F 14 0 -12", "F 30 0 -10"},
     ""},
    // lcn-4-corner: a way that turns back beside an arc stays on its side
    {"back along an arc by a line",
     "G0 X-23.1 Z16\nG18\nG41.1 D7.22 G1 X0 Z0\nG91 G2 Z14.742986906 X30.737503690 K13.873642550 "
     "I12.250050341\n"
     "G1 Z-25.7\nG40\nG90 G1 X50",
     {"R -23.1 0 16", "F -2.2224 0 -2.8521", "A 27.1275 0 -2.4929 c 12.2501 0 13.8736 -83.1403",
      "F 27.1275 0 -10.957", "F 50 0 -10.957"},
     ""},
    // lcn-4-corner
    {"back from a line to an arc",
     "G0 X-26 Y1.07\nG41.1 D6.056 G1 X0 Y0\nG91 G2 X2.409329722 Y-7.439064305 I6.365933914 J-2.047924216\n"
     "G90 G1 X-20 Y4.711\nG91 G2 X5.292172091 Y-17.292792749 I-5.334008980 J-11.088571956\nG40\nG1 X-60",
     {"R -26 1.07 0", "F -1.8686 3.1075 0", "A 0.8014 -10.0117 0 c 6.3659 -2.0479 0 -272.894",
      "F -10.1775 -4.0591 0", "A -12.0929 -14.1085 0 c -25.334 -6.3776 0 -38.9762", "F -74.7078 -12.5818 0"},
     ""},
    // lcn-4-comperr
    {"not in YZ", "G19\nG41.1 D4", {}, "linuxcnc-comp"},

};
// clang-format on

TEST(LinuxCncCompensation, GoesWhereTheInterpreterGoes) { checkLcnCases(kLcnCompensationCases); }

// lcn-4-gouge: the interpreter runs a nearly full turn in an arc that its corner has used up; told here.
TEST(LinuxCncCompensation, TellsArcsThatACornerUsesUp) {
  const IsoRun run = runLcn(
      "G0 X-39 Y6\nT1 M6\nG42 G1 X0 Y0\nG91 G3 X0.1516 Y-0.1697 I2.1938 J1.8078\n"
      "G2 X10.0168 Y-13.4744 I-4.4949 J-13.8019\nG90 G1 X-16\nG40 X-60");
  EXPECT_EQ(run.error(), "linuxcnc-comp");
}

// lcn-4-orient: tool 3 of the table, 0.8 mm, orientation 2; figures of rs274.
TEST(LinuxCncCompensation, TurnsByTheTipOfTheTable) {
  const IsoRun run = runLcn(
      "G10 L1 P1 X0 Z0 R0.4 Q2\nT1 M6 G43\nG18 G7\nG0 X30 Z5\nG42 G1 X20 Z0\nZ-10\nX30 Z-15\n"
      "G40 G0 X40");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (std::vector<std::string>{"R 15 0 5", "F 10 0 -0.5657", "F 10 0 -10.2343",
                                                     "F 14.8828 0 -15.1172", "R 20 0 -15"}));
}

// lcn-5-M6 lcn-5-M61 lcn-4-G28: behind a tool change the program goes on from where the tool is, else from
// where it would be without compensation.
TEST(LinuxCncComp, LeavesARestThatAToolChangeTakes) {
  const std::string contour = "G41.1 D4 G1 X10\nY10\nG40\n";
  EXPECT_EQ(runLcn(contour + "G0 Z5").motions().back(), "R 10 10 5");
  EXPECT_EQ(runLcn(contour + "T1 M6\nG0 Z5").motions().back(), "R 8 10 5");
  EXPECT_EQ(runLcn(contour + "M61 Q1\nG91 G0 X1").motions().back(), "R 9 10 0");
  const std::vector<std::string> home = runLcn(contour + "G28").motions();
  EXPECT_EQ((std::vector<std::string>{home[2], home[3]}), (std::vector<std::string>{"R 10 10 0", "R 0 0 0"}));
}

}  // namespace
}  // namespace proveout::test
