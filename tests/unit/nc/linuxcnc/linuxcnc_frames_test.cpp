// Frames, shifts and tool offsets of LinuxCNC, against rs274 (2.9).
// Points are machine coordinates: those of rs274 with its offsets and turns added.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

// clang-format off: one case a row
const std::vector<LcnCase> kLcnFramesCases{
    // lcn-4-G10L2 lcn-4-G54
    {"G10 L2 with R",
     "G10 L2 P1 X10 Y20 Z30 R90\nG0 X5 Y0 Z0\nG2 X7 Y4 I3",
     {"R 10 25 30"},
     "linuxcnc-arc-radius"},
    // lcn-4-G10L2
    {"P beyond 9", "G10 L2 P10 X1", {}, "linuxcnc-data"},
    // lcn-4-G10L2
    {"no P", "G10 L2 X1", {}, "linuxcnc-data"},
    // lcn-4-G10L20
    {"R with L20", "G10 L20 P1 R4", {}, "linuxcnc-data"},
    // lcn-4-G92 lcn-4-G92.1 lcn-4-G92.2
    {"G92 and its kin",
     "G0 X5 Y6 Z7\nG92 X0 Y0 Z0\nG0 X10\nG92.2\nG0 X0\nG92.3\nG0 X1\nG92.1\nG0 X2",
     {"R 5 6 7", "R 15 6 7", "R 0 6 7", "R 6 6 7", "R 2 6 7"},
     ""},
    // lcn-4-G52
    {"G52 and G92 share a shift", "G52 X5 Y5\nG0 X0 Y0\nG92 X1\nG0 X2", {"R 5 5 0", "R 6 5 0"}, ""},
    // lcn-4-G92
    {"G92 without words", "G92", {}, "linuxcnc-axis-words"},
    // lcn-4-G92 lcn-4-G10L2
    {"G92 in a turned frame",
     "G0 X3 Y2\nG10 L2 P1 X1 Y1 R30\nG92 X0 Y0\nG0 X1 Y0\nG10 L20 P1 X5 Y5\nG91 G0 X1",
     {"R 3 2 0", "R 3.866 2.5 0", "R 4.7321 3 0"},
     ""},
    // lcn-4-G92
    {"G92 in a turned frame at the origin", "G10 L2 P1 R90\nG92 X5\nG0 X10 Y0", {"R 0 5 0"}, ""},
    // lcn-4-G10L20
    {"G10 L20", "G0 X5 Y6 Z7\nG10 L20 P2 X0 Y0 Z0\nG55 G0 X1 Y1 Z1", {"R 5 6 7", "R 6 7 8"}, ""},
    // lcn-4-G54 lcn-4-G59.3
    {"all frames",
     "G10 L2 P6 X6\nG10 L2 P7 X7\nG10 L2 P8 X8\nG10 L2 P9 X9\nG59 G0 X0\nG59.1 X0\nG59.2 X0\nG59.3 X0\nG54 "
     "X0",
     {"R 6 0 0", "R 7 0 0", "R 8 0 0", "R 9 0 0", "R 0 0 0"},
     ""},
    // lcn-4-G10L10 lcn-4-G43
    {"G10 L10", "G0 Z5\nG92 Z0\nG10 L10 P1 Z10\nT1 M6 G43\nG0 Z1", {"R 0 0 5", "R 0 0 -4"}, ""},
    // lcn-4-G10L10
    {"G10 L11", "T1 M6\nG0 Z12\nG43\nG10 L11 P1 Z0\nG43\nG0 Z1", {"R 0 0 12", "R 0 0 13"}, ""},
    // lcn-4-G10L1
    {"G10 L1", "G10 L1 P1 X3 Z20\nT1 M6\nG43\nG0 X0 Z1", {"R 3 0 21"}, ""},
    // lcn-4-G10L1
    {"tool not in the table", "G10 L1 P9 Z20", {}, "linuxcnc-tool"},
    // lcn-4-G43keep lcn-4-G49
    {"the offset stays until G43",
     "T1 M6 G43\nG0 Z10\nT2 M6\nG0 Z10 X1\nG43\nG0 Z10\nG49\nG0 Z3",
     {"R 0 0 60", "R 1 0 60", "R 1 0 40", "R 1 0 3"},
     ""},
    // lcn-4-G43.1 lcn-4-G43.2
    {"G43.1 and G43.2",
     "G43.1 X1 Z2\nG0 X0 Z0\nG43.1 X3\nG0 X0\nG43.2 H2\nG0 X0 Z0",
     {"R 1 0 2", "R 3 0 2", "R 3 0 32"},
     ""},
    // lcn-4-G43
    {"G43 of a tool that is not there", "G43 H5", {}, "linuxcnc-tool"},
    // lcn-4-G43.2
    {"G43.2 without words", "G43.2", {}, "linuxcnc-tool"},
    // lcn-4-G28
    {"G28", "G0 X5\nG28", {"R 5 0 0", "R 0 0 0"}, ""},
    // lcn-4-G28.1 lcn-4-G28
    {"G28.1 and a way",
     "G0 X5 Y1\nG28.1\nG28 X7 Z5\nG0 X9\nG28",
     {"R 5 1 0", "R 7 1 5", "R 5 1 0", "R 9 1 0", "R 5 1 0"},
     ""},
    // lcn-4-G30.1 lcn-4-G30
    {"G30.1",
     "G0 X5 Y1\nG30.1\nG0 X9 Z2\nG30 Z4\nG91 G30 Y3",
     {"R 5 1 0", "R 9 1 2", "R 9 1 4", "R 9 1 0", "R 9 4 0", "R 9 1 0"},
     ""},
    // lcn-4-G28
    {"G28 in a turned frame",
     "G10 L2 P0 Y21 Z10 R2\nG0 X5 Y5\nG28.1\nG0 X10 Z3\nG28 X19.4 Z17",
     {"R 4.8225 26.1715 0", "R 9.8194 26.3459 13", "R 19.2137 26.674 27", "R 4.8225 26.1715 0"},
     ""},
    // lcn-4-G53
    {"G53 with an offset",
     "G10 L2 P1 X10 Y20 R30\nT1 M6 G43\nG0 X1 Y2 Z3\nG53 G0 Z80\nG53 G1 X4",
     {"R 9.866 22.2321 53", "R 9.866 22.2321 80", "F 4 22.2321 80"},
     ""},
};
// clang-format on

TEST(LinuxCncFrames, GoesWhereTheInterpreterGoes) { checkLcnCases(kLcnFramesCases); }

// lcn-4-G10L0
TEST(LinuxCncFrames, ReadsTheToolTableAnew) {
  const IsoRun run = runLcn("G10 L1 P1 Z20\nG43 H1\nG0 Z1\nG10 L0\nG43 H1\nG0 Z1");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (std::vector<std::string>{"R 0 0 21", "R 0 0 51"}));
}

// lcn-4-G28: without a stored point machine zero is taken, told once.
TEST(LinuxCncFrames, TellsThatNobodyStoredThePoint) {
  EXPECT_TRUE(runLcn("G0 X5\nG28").tells("linuxcnc-machine-zero"));
}

// lcn-4-G20: the interpreter's own book of offsets is wrong behind this.
TEST(LinuxCncFrames, TellsOfUnitsThatChangeBesideALength) {
  EXPECT_TRUE(runLcn("T1 M6 G43\nG20 G0 Z1").tells("linuxcnc-units-with-length"));
}

}  // namespace
}  // namespace proveout::test
