// Drilling and threading cycles of LinuxCNC, against rs274 (2.9).
// Points are machine coordinates: those of rs274 with its offsets and turns added.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

// clang-format off: one case a row
const std::vector<LcnCase> kLcnCyclesCases{
    // lcn-3-G81 lcn-3-G99 lcn-3-sticky
    {"G81 in the state of the start, G99",
     "G0 Z10\nG81 X5 Y5 Z-3 R2\nX10\nG91 G81 X5 Z-4 R-1 L3",
     {"R 0 0 10", "R 5 5 10", "R 5 5 2", "F 5 5 -3", "R 5 5 2", "R 10 5 2", "F 10 5 -3", "R 10 5 2",
      "R 15 5 9", "F 15 5 5", "R 15 5 9", "R 20 5 9", "F 20 5 5", "R 20 5 9", "R 25 5 9", "F 25 5 5",
      "R 25 5 9"},
     ""},
    // lcn-3-G98
    {"G98",
     "G0 Z10\nG98 G81 X5 Y5 Z-3 R2\nX10",
     {"R 0 0 10", "R 5 5 10", "R 5 5 2", "F 5 5 -3", "R 5 5 10", "R 10 5 10", "R 10 5 2", "F 10 5 -3",
      "R 10 5 10"},
     ""},
    // lcn-3-G83
    {"G83",
     "G0 Z10\nG98 G83 X5 Y5 Z-10 R2 Q5",
     {"R 0 0 10", "R 5 5 10", "R 5 5 2", "F 5 5 -3", "R 5 5 2", "R 5 5 -2.746", "F 5 5 -8", "R 5 5 2",
      "R 5 5 -7.746", "F 5 5 -10", "R 5 5 10"},
     ""},
    // lcn-3-G73
    {"G73",
     "G0 Z10\nG99 G73 X10 Z-10 R2 Q5\nG73 X1 Z-10 R0 Q3",
     {"R 0 0 10", "R 10 0 10", "R 10 0 2", "F 10 0 -3", "R 10 0 -2.746", "F 10 0 -8", "R 10 0 -7.746",
      "F 10 0 -10", "R 10 0 2", "R 1 0 2", "R 1 0 0", "F 1 0 -3", "R 1 0 -2.746", "F 1 0 -6", "R 1 0 -5.746",
      "F 1 0 -9", "R 1 0 -8.746", "F 1 0 -10", "R 1 0 0"},
     ""},
    // lcn-3-G81
    {"R above the tool",
     "G0 Z1\nG98 G81 X5 Z-3 R4",
     {"R 0 0 1", "R 0 0 4", "R 5 0 4", "F 5 0 -3", "R 5 0 4"},
     ""},
    // lcn-3-L
    {"steps with L",
     "G91 G81 X5 Z-2 R1 L2",
     {"R 0 0 1", "R 5 0 1", "F 5 0 -1", "R 5 0 1", "R 10 0 1", "F 10 0 -1", "R 10 0 1"},
     ""},
    // lcn-3-L
    {"L at one place",
     "G81 X5 Z-2 R1 L2",
     {"R 0 0 1", "R 5 0 1", "F 5 0 -2", "R 5 0 1", "F 5 0 -2", "R 5 0 1"},
     ""},
    // lcn-3-L lcn-3-polar
    {"steps in degrees with L",
     "G0 X10 Y0\nG91 G81 R-1 Z-1 ^90 L3",
     {"R 10 0 0", "R 0 10 0", "R 0 10 -1", "F 0 10 -2", "R 0 10 -1", "R -10 0 -1", "F -10 0 -2", "R -10 0 -1",
      "R 0 -10 -1", "F 0 -10 -2", "R 0 -10 -1"},
     ""},
    // lcn-4-G18
    {"in the plane XZ", "G18 G81 X1 Y-3 Z1 R2", {"R 0 2 0", "R 1 2 1", "F 1 -3 1", "R 1 2 1"}, ""},
    // lcn-3-G87
    {"G87",
     "S500 M3\nG0 Z10\nG87 X5 Z-5 R2 I1 J1 K1\nX9",
     {"R 0 0 10", "R 5 0 10", "R 5 0 2",  "R 6 1 2",   "R 6 1 -5", "R 5 0 -5", "F 5 0 1",
      "F 5 0 -5", "R 6 1 -5", "R 6 1 2",  "R 5 0 2",   "R 9 0 2",  "R 10 1 2", "R 10 1 -5",
      "R 9 0 -5", "F 9 0 1",  "F 9 0 -5", "R 10 1 -5", "R 10 1 2", "R 9 0 2"},
     ""},
    // lcn-3-G82
    {"G82",
     "G0 Z10\nG82 X2 Z-1 R2 P.5\nX3",
     {"R 0 0 10", "R 2 0 10", "R 2 0 2", "F 2 0 -1", "R 2 0 2", "R 3 0 2", "F 3 0 -1", "R 3 0 2"},
     ""},
    // lcn-3-G85 lcn-3-G89
    {"G85 and G89",
     "G0 Z10\nG98 G85 X2 Z-1 R2\nX3\nG89 X4 Z-2 R1 P.2",
     {"R 0 0 10", "R 2 0 10", "R 2 0 2", "F 2 0 -1", "F 2 0 2", "R 2 0 10", "R 3 0 10", "R 3 0 2", "F 3 0 -1",
      "F 3 0 2", "R 3 0 10", "R 4 0 10", "R 4 0 1", "F 4 0 -2", "F 4 0 10"},
     ""},
    // lcn-3-G86
    {"G86",
     "S500 M3\nG0 Z10\nG86 X2 Z-1 R2 P.5",
     {"R 0 0 10", "R 2 0 10", "R 2 0 2", "F 2 0 -1", "R 2 0 2"},
     ""},
    // lcn-3-cycleerr
    {"G83 without Q", "G0 Z10\nG83 X1 Z-1 R2", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-cycleerr
    {"G82 without P", "G0 Z10\nG82 X1 Z-1 R2", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-cycleerr
    {"L0", "G0 Z10\nG81 X1 Z-1 R2 L0", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-cycleerr
    {"R below Z", "G0 Z10\nG81 Z3 R2", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-cycleerr
    {"no R", "G0 Z10\nG81 X1 Z-1", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-cycleerr
    {"no Z", "G0 Z10\nG81 X1 R1", {"R 0 0 10"}, "linuxcnc-cycle"},
    // lcn-3-sticky
    {"another code forgets R",
     "G0 Z10\nG81 X1 Z-1 R2\nG82 X2 Z-1 P1",
     {"R 0 0 10", "R 1 0 10", "R 1 0 2", "F 1 0 -1", "R 1 0 2"},
     "linuxcnc-cycle"},
    // lcn-3-sticky
    {"a motion between forgets R",
     "G0 Z10\nG81 X1 Z-1 R2\nG0 X5\nG81 X2 Z-1",
     {"R 0 0 10", "R 1 0 10", "R 1 0 2", "F 1 0 -1", "R 1 0 2", "R 5 0 2"},
     "linuxcnc-cycle"},
    // lcn-3-G80
    {"G80 ends the series",
     "G0 Z10\nG81 X1 Z-1 R2\nG80\nX5",
     {"R 0 0 10", "R 1 0 10", "R 1 0 2", "F 1 0 -1", "R 1 0 2"},
     "linuxcnc-axis-words"},
    // lcn-3-sticky
    {"R above in a series, G99",
     "G0 Z10\nG81 X1 Z-1 R2\nX5 R6\nX7 R1",
     {"R 0 0 10", "R 1 0 10", "R 1 0 2", "F 1 0 -1", "R 1 0 2", "R 5 0 6", "F 5 0 -1", "R 5 0 6", "R 7 0 6",
      "R 7 0 1", "F 7 0 -1", "R 7 0 1"},
     ""},
    // lcn-3-G98
    {"R above in a series, G98",
     "G0 Z10\nG82 X29.5 Z-13.3 R0 P1\nG98\nG81 X-5 Z1 R3\nY12",
     {"R 0 0 10", "R 29.5 0 10", "R 29.5 0 0", "F 29.5 0 -13.3", "R 29.5 0 0", "R -5 0 10", "R -5 0 3",
      "F -5 0 1", "R -5 0 10", "R -5 12 10", "R -5 12 3", "F -5 12 1", "R -5 12 10"},
     ""},
    // lcn-3-G84 lcn-3-cycleerr
    {"G84 needs the spindle", "G0 Z10\nG84 X1 Z-1 R2", {"R 0 0 10"}, "linuxcnc-spindle-stopped"},
    // lcn-3-G84 lcn-3-cycleerr
    {"G84 the other way", "S100 M4\nG0 Z10\nG84 X1 Z-1 R2", {"R 0 0 10"}, "linuxcnc-spindle-stopped"},
    // lcn-3-G84
    {"G84", "S100 M3\nG0 Z10\nG84 X1 Z-1 R2", {"R 0 0 10", "R 1 0 10", "R 1 0 2", "T 1 0 -1", "T 1 0 2"}, ""},
    // lcn-3-G74
    {"G74", "S100 M4\nG0 Z10\nG74 X1 Z-1 R2", {"R 0 0 10", "R 1 0 10", "R 1 0 2", "T 1 0 -1", "T 1 0 2"}, ""},
    // lcn-3-cycleerr
    {"inverse time", "G93 F3\nG0 Z10\nG81 X1 Z-1 R2", {"R 0 0 10"}, "linuxcnc-feed"},
    // lcn-3-cycleerr
    {"compensation",
     "G0 Z10\nG41.1 D4 G1 X20\nX30\nG81 X1 Z-1 R2",
     {"R 0 0 10", "F 20 2 10"},
     "linuxcnc-comp"},
    // lcn-3-sticky
    {"the units change in a series",
     "G0 Z10\nG83 Y-5 Z-6 R6 Q5.796\nG20\nX-3",
     {"R 0 0 10",          "R 0 -5 10",
      "R 0 -5 6",          "F 0 -5 0.204",
      "R 0 -5 6",          "R 0 -5 0.458",
      "F 0 -5 -5.592",     "R 0 -5 6",
      "R 0 -5 -5.338",     "F 0 -5 -6",
      "R 0 -5 6",          "R -76.2 -5 152.4",
      "F -76.2 -5 5.1816", "R -76.2 -5 152.4",
      "R -76.2 -5 5.4356", "F -76.2 -5 -142.0368",
      "R -76.2 -5 152.4",  "R -76.2 -5 -141.7828",
      "F -76.2 -5 -152.4", "R -76.2 -5 152.4"},
     ""},
    // lcn-3-G76
    {"G76 with a taper at the end",
     "G18 G8 G95 S200 M3\nG0 X20 Z2\nG76 P1.5 Z-20 I-2 J0.5 R1.5 K1.2 Q29.5 H1 E1 L2",
     {"R 20 0 2",
      "R 20.7 0 1.7171",
      "R 17.5 0 1.7171",
      "T 17.5 0 -18.604",
      "T 18.7 0 -19.604",
      "R 20.7 0 -19.604",
      "R 20.4063 0 1.5509",
      "R 17.2063 0 1.5509",
      "T 17.2063 0 -18.7701",
      "T 18.4063 0 -19.7701",
      "R 20.4063 0 -19.7701",
      "R 20.16 0 1.4116",
      "R 16.96 0 1.4116",
      "T 16.96 0 -18.9095",
      "T 18.16 0 -19.9095",
      "R 20.16 0 -19.9095",
      "R 20 0 1.3211",
      "R 16.8 0 1.3211",
      "T 16.8 0 -19",
      "T 18 0 -20",
      "R 20 0 -20",
      "R 20 0 1.3211",
      "R 16.8 0 1.3211",
      "T 16.8 0 -19",
      "T 18 0 -20",
      "R 20 0 -20"},
     ""},
    // lcn-3-G76
    {"G76 inside, taper at both ends",
     "G18 G8 S200 M3\nG0 X20 Z2\nG76 P1.5 Z-20 I2 J0.7 K1.2 E2 L3",
     {"R 20 0 2", "R 19.5 0 2", "T 21.5 0 2", "T 22.7 0 0", "T 22.7 0 -18", "T 21.5 0 -20", "R 19.5 0 -20",
      "R 20 0 2", "T 22 0 2", "T 23.2 0 0", "T 23.2 0 -18", "T 22 0 -20", "R 20 0 -20"},
     ""},
    // lcn-3-G76
    {"G76 by diameters",
     "G18 G7 S200 M3\nG0 X20 Z2\nG91 G76 P1.5 Z-20 I2 J0.7 K1.2 Q30",
     {"R 10 0 2", "R 9.75 0 1.7979", "R 11.35 0 1.7979", "T 11.35 0 -17.8557", "R 9.75 0 -17.8557",
      "R 10 0 1.6536", "R 11.6 0 1.6536", "T 11.6 0 -18", "R 10 0 -18"},
     ""},
    // lcn-3-G76
    {"G76 with R2",
     "G18 G8 S200 M3\nG0 X20 Z2\nG76 P1 Z-5 I-1 J.3 K.6 R2",
     {"R 20 0 2", "R 20.3 0 2", "R 18.7 0 2", "T 18.7 0 -5", "R 20.3 0 -5", "R 20.1757 0 2", "R 18.5757 0 2",
      "T 18.5757 0 -5", "R 20.1757 0 -5", "R 20.0804 0 2", "R 18.4804 0 2", "T 18.4804 0 -5",
      "R 20.0804 0 -5", "R 20 0 2", "R 18.4 0 2", "T 18.4 0 -5", "R 20 0 -5"},
     ""},
    // lcn-3-G76
    {"G76 K not above J",
     "G18 G8 S200 M3\nG0 X20 Z2\nG76 P1 Z-5 I-1 J.3 K.3",
     {"R 20 0 2"},
     "linuxcnc-thread"},
    // lcn-3-G76
    {"G76 without the spindle",
     "G18 G8\nG0 X20 Z2\nG76 P1 Z-5 I-1 J.3 K.6",
     {"R 20 0 2"},
     "linuxcnc-spindle-stopped"},
};
// clang-format on

TEST(LinuxCncCycles, GoesWhereTheInterpreterGoes) { checkLcnCases(kLcnCyclesCases); }

// lcn-3-G88: the tool is taken out by hand, here up to R; the interpreter prints no motion for it.
TEST(LinuxCncCycles, StopsAtTheBottomOfG88) {
  const IsoRun run = runLcn("S100 M3\nG0 Z10\nG88 X1 Z-2 R2 P0\nX2");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (std::vector<std::string>{"R 0 0 10", "R 1 0 10", "R 1 0 2", "F 1 0 -2", "R 1 0 2",
                                                     "R 2 0 2", "F 2 0 -2", "R 2 0 2"}));
}

// lcn-3-G84: outside of G17 the interpreter swaps axes of taps; nobody wants that.
TEST(LinuxCncCycles, RefusesTapsInOtherPlanes) {
  EXPECT_EQ(runLcn("S100 M3\nG18 G84 X-23 Y-5 Z-3.89 R5.89").error(), "linuxcnc-cycle-plane");
  EXPECT_EQ(runLcn("S100 M4\nG19 G74 X-23 Y-5 Z-3.89 R5.89").error(), "linuxcnc-cycle-plane");
}

// lcn-3-cycleerr: pecks without end.
TEST(LinuxCncCycles, RefusesStrokesWithoutEnd) {
  EXPECT_EQ(runLcn("G0 Z10\nG83 X1 Z-1000 R2 Q.00001").error(), "linuxcnc-out-of-range");
  EXPECT_EQ(runLcn("G0 Z10\nG81 X1 Z-1 R2 L90000000").error(), "linuxcnc-out-of-range");
}

// Figures of the interpreter: G98 behind G99 in a series.
TEST(LinuxCncCycles, GoesToTheLevelOfReturnFromR) {
  const auto of = [](const std::string& text) {
    return IsoRun(ControlId::kLinuxCnc, "G21 G90 F100\nG0 X0 Y0 Z10\n" + text + "G80\nM2\n").motions();
  };
  const std::vector<std::string> at_r = of("G99 G81 X1 Y1 Z-5 R8\nG98 X2\n");
  ASSERT_EQ(at_r.size(), 9u);
  EXPECT_EQ(at_r[5], "R 2 1 10");
  const std::vector<std::string> above = of("G99 G81 X1 Y1 Z-5 R8\nG98 X2 R5\nX3 R7\n");
  ASSERT_EQ(above.size(), 13u);
  EXPECT_EQ(above[5], "R 2 1 8");
  EXPECT_EQ(above[8], "R 2 1 10");
}

}  // namespace
}  // namespace proveout::test
