// GRBL, Mach3 and others beside LinuxCNC. What they do is public practice (their documentation), not a run.
#include <gtest/gtest.h>

#include "tests/unit/nc/linuxcnc/linuxcnc_cases.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

constexpr double kGrblFlavour = 1, kMach3Flavour = 2, kPathPilotFlavour = 3, kSmoothieFlavour = 4,
                 kGrblHalFlavour = 5;

IsoRun runFlavour(double flavour, const std::string& lines, std::map<std::string, double> more = {}) {
  more["flavour"] = flavour;
  return IsoRun(ControlId::kLinuxCnc, lines + "\nM2\n", lcnSettings(more));
}

// lcn-6-grbl: G0 holds from the start, and F through G94.
TEST(LinuxCncFlavours, RunsProgramsOfGrbl) {
  const IsoRun run =
      runFlavour(kGrblFlavour, "G21\nX1\nF100 G94\nG1 X2\nG94\nG2 X4 Y2 J2\nG10 L20 P1 X0\nG0 X1");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0", "F 2 0 0", "A 4 2 0 c 2 2 0 -270", "R 5 2 0"}));
}

// lcn-6-grbl: no cycles, no variables, no compensation: errors by number.
TEST(LinuxCncFlavours, RefusesWhatGrblHasNot) {
  for (const char* line : {"G81 X1 Z-1 R2 F9", "G41 D1", "G43 H1", "G90.1", "G64 P.1", "G5 I1 J1 P1 Q1 X3"})
    EXPECT_EQ(runFlavour(kGrblFlavour, line).error(), "linuxcnc-error-20") << line;
  EXPECT_EQ(runFlavour(kGrblFlavour, "G0 G1 X1").error(), "linuxcnc-error-24");
  EXPECT_EQ(runFlavour(kGrblFlavour, "G1 X1").error(), "linuxcnc-error-22");
  EXPECT_EQ(runFlavour(kGrblFlavour, "G4").error(), "linuxcnc-error-28");
  EXPECT_EQ(runFlavour(kGrblFlavour, "G0 X1 R3").error(), "linuxcnc-error-36");
  EXPECT_EQ(runFlavour(kGrblFlavour, "G0 X1 X2").error(), "linuxcnc-error-25");
}

// lcn-6-grbl: what the parser of GRBL 1.1h itself says of these lines, behind G21 G90 F100 G1 at 0.
TEST(LinuxCncFlavours, TellsErrorsOfGrblByItsNumbers) {
  const std::vector<std::pair<std::string, int>> lines{
      {"G2 I5", 26},
      {"G2 Z1 I5", 32},
      {"G2 X2 K3", 35},
      {"G2 X2 Y0 I5 K3", 33},
      {"G2 X10 R4", 34},
      {"G2 X10 R5 P1", 36},
      {"X#1", 2},
      {"#1=3", 1},
      {"X[1+2]", 2},
      {"O100 SUB", 20},
      {"O1", 20},
      {"G59.1", 23},
      {"G43.1 X1", 37},
      {"G43.1 Z1", 0},
      {"G43 H1", 20},
      {"M13", 20},
      {"T300", 38},
      {"F-1", 4},
      {"N5 X1", 0},
      {"X1 N-3", 4},
      {"G0.5", 23},
      {"M3.5", 23},
      {"G28.2", 20},
      {"G90.1", 20},
      {"G61.1", 20},
      {"G61", 0},
      {"G80 X3", 31},
      {"G10 L2 P1", 26},
      {"G10 X1", 28},
      {"G10 L2 P7 X1", 29},
      {"G10 L2 P1 R4 X1", 20},
      {"G10 L20 X4", 0},
      {"G92", 26},
      {"G28 G0 X1", 24},
      {"G0 G49 X1", 24},
      {"G4", 28},
      {"G53 G2 X3 I1", 30},
      {"G91 G53 G0 X-4", 0},
      {"G93 G1 X5", 22},
      {"X5 P2", 36},
      {"D1", 20},
      {"Q1 X3", 20},
      {"G81 X1 Z-1 R1", 20},
      {"G64", 20},
      {"G5 X1", 20},
      {"M98 P1", 20},
      {"M19", 20},
      {"X1 X2", 25},
      {"G17 G18", 21},
      {"M3 M4", 21},
      {"A4", 20},
      {"X", 2},
      {"G0 X1 (note) Y2 ; end", 0},
      {"/G0 X3", 0},
      {"T0.5 X2", 0},
      {"G1 Y2 N7", 0},
      {"F0 G1 X1", 22},
      {"X1234567890123456789012345678901234567890123456789012345678901234567890123456789012345678", 11}};
  for (const auto& [line, number] : lines) {
    const IsoRun run = runFlavour(kGrblFlavour, "G21 G90 F100\nG0 X0\nG1\n" + line);
    EXPECT_EQ(run.error(), number == 0 ? "" : "linuxcnc-error-" + std::to_string(number)) << line;
  }
  // In words.
  const IsoRun run = runFlavour(kGrblFlavour, "#1=3");
  EXPECT_TRUE(run.message().starts_with("error:1 ")) << run.message();
  // Smoothie reads as GRBL does, grblHAL takes what LinuxCNC does.
  EXPECT_EQ(runFlavour(kSmoothieFlavour, "X[1+2]").error(), "linuxcnc-error-2");
  EXPECT_EQ(runFlavour(kGrblHalFlavour, "X[1+2]").motions(), (Lines{"R 3 0 0"}));
}

// lcn-6-grbl: G49 takes axis words and leaves them, / skips nothing, K across an arc is nothing.
TEST(LinuxCncFlavours, GoesWhereGrblGoes) {
  const IsoRun run = runFlavour(
      kGrblFlavour, "F100\nG49 X7\n/X3\nG2 X5 Y0 I1 K4\nG91 G53 G0 X-4\nG53 G90\nG28.1 G0 X8\nG28");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 3 0 0", "A 5 0 0 c 4 0 0 -180", "R -4 0 0", "R 8 0 0", "R -4 0 0"}));
  EXPECT_TRUE(run.tells("linuxcnc-unused-word"));
}

// lcn-6-grblarc: other tolerances, and a full circle names an end.
TEST(LinuxCncFlavours, HoldsArcsToTheRulesOfGrbl) {
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 I5").error(), "linuxcnc-error-26");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X0 Y0 I5").motions(), (Lines{"A 0 0 0 c 5 0 0 -360"}));
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X10 Y0 I5.01").error(), "linuxcnc-error-33");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X10 Y0 I5.002").error(), "");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X0 I0").error(), "linuxcnc-error-33");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X0.004 I0").error(), "linuxcnc-error-33");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X400 Y0 I200.05").error(), "");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X20 R9.9").error(), "linuxcnc-error-34");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X20").error(), "linuxcnc-error-35");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G2 X0 Y0 I5 P2").error(), "linuxcnc-error-36");
}

// lcn-6-E
TEST(LinuxCncFlavours, RefusesExtruders) {
  EXPECT_EQ(runFlavour(kSmoothieFlavour, "F100 G1 X1 E3").error(), "linuxcnc-extruder");
  EXPECT_EQ(runFlavour(kGrblFlavour, "F100 G1 X1 E3").error(), "linuxcnc-extruder");
}

// lcn-6-grbldollar
TEST(LinuxCncFlavours, RefusesCommandsOfTheSender) {
  for (const char* line : {"$H", "?", "!", "~", "$J=G91 X1 F9", " $X"})
    EXPECT_EQ(runFlavour(kGrblFlavour, line).error(), "linuxcnc-sender-command") << line;
}

// lcn-6-mach3: circles, rotation, factors, polar words, frames by P, dwells.
TEST(LinuxCncFlavours, RunsCodesOfMach3) {
  const IsoRun circle = runFlavour(kMach3Flavour, "F100\nG0 X5\nG12 I3\nG13 I2");
  EXPECT_EQ(circle.error(), "") << circle.message();
  EXPECT_EQ(circle.motions(), (Lines{"R 5 0 0", "F 8 0 0", "A 8 0 0 c 5 0 0 -360", "F 5 0 0", "F 7 0 0",
                                     "A 7 0 0 c 5 0 0 360", "F 5 0 0"}));
  const IsoRun turned = runFlavour(kMach3Flavour, "F100\nG68 A10 B0 R90\nG0 X12 Y0\nG69\nG0 X1 Y1");
  EXPECT_EQ(turned.error(), "") << turned.message();
  EXPECT_EQ(turned.motions(), (Lines{"R 10 2 0", "R 1 1 0"}));
  const IsoRun scaled = runFlavour(kMach3Flavour, "F100\nG51 X2 Y2\nG0 X3 Y1\nG50\nG0 X3");
  EXPECT_EQ(scaled.error(), "") << scaled.message();
  EXPECT_EQ(scaled.motions(), (Lines{"R 6 2 0", "R 3 2 0"}));
  const IsoRun polar = runFlavour(kMach3Flavour, "G16\nG0 X10 Y90\nG15\nG0 X1");
  EXPECT_EQ(polar.motions(), (Lines{"R 0 10 0", "R 1 10 0"}));
  EXPECT_EQ(runFlavour(kMach3Flavour, "G54 P300").error(), "linuxcnc-data");
  const IsoRun dwell = runFlavour(kMach3Flavour, "G4 P500", {{"dwell_unit", 1}});
  EXPECT_TRUE(dwell.tells("linuxcnc-setting"));
  EXPECT_NEAR(dwell.summary.cycle_s, 0.5, 1e-9);
  const IsoRun centre = runFlavour(kMach3Flavour, "F100 G0 X10\nG2 X20 Y0 I15 J0", {{"arc_centre", 1}});
  EXPECT_EQ(centre.motions(), (Lines{"R 10 0 0", "A 20 0 0 c 15 0 0 -180"}));
  // They are codes of no other control of the kin.
  EXPECT_EQ(runFlavour(0, "G12 I3").error(), "linuxcnc-unknown-code");
}

// lcn-6-mach3: heads of posts, labels, parameters, the end that starts again.
TEST(LinuxCncFlavours, ReadsProgramsOfMach3) {
  const IsoRun head =
      runFlavour(kMach3Flavour, "G00G20G17G90G40G49G80\nG71G91.1\nF100\nG1 X3\nG70\nX1\nG81 G71 Y1 Z-1 R2");
  EXPECT_EQ(head.error(), "") << head.message();
  EXPECT_EQ(head.motions()[0], "F 3 0 0");
  EXPECT_EQ(head.motions()[1], "F 25.4 0 0");
  EXPECT_EQ(head.motions().back(), "R 25.4 1 2");
  const IsoRun calls = IsoRun(
      ControlId::kLinuxCnc, "F100 G91\nM98 P1234 L2\nG1 Y1\nM30\nO1234\nG1 X2\nM98 P7\nM99\nO7\nG1 Z1\nM99\n",
      lcnSettings({{"flavour", kMach3Flavour}}));
  EXPECT_EQ(calls.error(), "") << calls.message();
  EXPECT_EQ(calls.motions(), (Lines{"F 2 0 0", "F 2 0 1", "F 4 0 1", "F 4 0 2", "F 4 1 2"}));
  EXPECT_EQ(runFlavour(kMach3Flavour, "#10320=4 #0=3\nG0 X#10320 Y#0").motions(), (Lines{"R 4 3 0"}));
  EXPECT_EQ(runFlavour(kMach3Flavour, "#10321=4").error(), "linuxcnc-parameter-number");
  EXPECT_EQ(runFlavour(0, "#5602=4").error(), "linuxcnc-parameter-number");
  EXPECT_EQ(runFlavour(kMach3Flavour, "o1 if [1]\no1 endif").error(), "linuxcnc-o-word");
  const IsoRun again = runFlavour(kMach3Flavour, "G0 X3\nM47\nG0 X9");
  EXPECT_EQ(again.motions(), (Lines{"R 3 0 0"}));
  EXPECT_TRUE(again.tells("linuxcnc-main-m99"));
  EXPECT_EQ(runFlavour(0, "M47").error(), "linuxcnc-unknown-code");
  EXPECT_EQ(runFlavour(0, "G0 G80 X1").error(), "linuxcnc-group-clash");
}

// lcn-6-mach3: P is the radius of compensation, and the number of a work system.
TEST(LinuxCncFlavours, TakesPOfMach3) {
  const IsoRun run =
      runFlavour(kMach3Flavour, "F100\nG41 P2 G1 X10\nY10\nG40 G0 X0 Y0\nG59 P2\nG10 L2 P2 X5\nG0 X1");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(),
            runLcn("F100\nG41.1 D4 G1 X10\nY10\nG40 G0 X0 Y0\nG55\nG10 L2 P2 X5\nG0 X1").motions());
  EXPECT_EQ(runFlavour(kMach3Flavour, "G41 P2 D1").error(), "linuxcnc-comp");
  EXPECT_EQ(runFlavour(0, "G41 P2").error(), "linuxcnc-unused-word");
}

// lcn-6-other
TEST(LinuxCncFlavours, KnowsOthers) {
  EXPECT_EQ(runFlavour(kPathPilotFlavour, "M998").error(), "linuxcnc-unknown-code");
  EXPECT_EQ(runFlavour(kPathPilotFlavour, "G47 P1").error(), "linuxcnc-unknown-code");
  EXPECT_EQ(runFlavour(kSmoothieFlavour, "G0 X5 Y6 Z7\nG28").motions().back(), "R 0 0 0");
  EXPECT_EQ(runFlavour(kGrblHalFlavour, "G91\nM98 P100 L2\nM30\nO100\nG0 X1\nM99").motions(),
            (Lines{"R 1 0 0", "R 2 0 0"}));
  EXPECT_EQ(runFlavour(kGrblHalFlavour, "F100 G0 Z10\nG81 X1 Z-1 R2").error(), "");
  EXPECT_EQ(runFlavour(kGrblHalFlavour, "G41 D1").error(), "linuxcnc-error-20");
  EXPECT_EQ(runFlavour(kPathPilotFlavour, "G37 H1").error(), "linuxcnc-unknown-code");
  EXPECT_EQ(runFlavour(kPathPilotFlavour, "F100 G0 Z10\nG81 X1 Z-1 R2").error(), "");
}

}  // namespace
}  // namespace proveout::test
