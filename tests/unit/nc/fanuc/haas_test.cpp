// Haas mills: what section 18 of the specification has otherwise than Fanuc-like mills.
#include <gtest/gtest.h>

#include "tests/support/five_axis_runs.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Settings = std::map<std::string, double>;

ControlSettings haasSettings(Settings parameters = {}) {
  parameters["flavour"] = 1;
  parameters.emplace("rapid", 1.0);  // straight ways
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.radius_offsets[1] = {2.0, 0.0};
  return settings;
}
/// Units mm, F100 S500; the tool starts at (0, 0, 0).
IsoRun haas(const std::string& text, const ControlSettings& settings = haasSettings()) {
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100. S500\n" + text + "\nM30\n", settings};
}

struct HaasRow {
  const char* name;
  const char* program;
  Lines motions;
};
class HaasTable : public testing::TestWithParam<HaasRow> {};

TEST_P(HaasTable, GivesTheMotions) {
  const IsoRun run = haas(GetParam().program);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), GetParam().motions);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, HaasTable,
    testing::Values(
        // haas-18-M97, acceptance 54
        HaasRow{
            "M97", "G0 G90\nM97 P100 L2\nG90 Y1.\nM30\nN100 G91 X1.\nM99", {"R 1 0 0", "R 2 0 0", "R 2 1 0"}},
        HaasRow{"M97Nested",
                "G0\nM97 P1\nY5.\nM30\nN1 X1.\nM97 P2\nX3.\nM99\nN2 X2.\nM99",
                {"R 1 0 0", "R 2 0 0", "R 3 0 0", "R 3 5 0"}},
        HaasRow{"M97None", "G0\nM97 P1 L0\nY5.\nM30\nN1 X1.\nM99", {"R 0 5 0"}},
        // haas-18-M98L
        HaasRow{"M98L", "G0\nM98 P12 L3\nM30\nO00012\nG91 X1.\nM99", {"R 1 0 0", "R 2 0 0", "R 3 0 0"}},
        // haas-18-G154 haas-18-G110
        HaasRow{"G154",
                "G10 L20 P7 X10. Y5.\nG154 P7 G0 X1. Y1.\nG116 X2.\nG110 X3.",
                {"R 11 6 0", "R 12 6 0", "R 3 6 0"}},
        // haas-18-G52 haas-18-G92
        HaasRow{"G52",
                "G52 X5.\nG0 X1.\nG55 X2.\nG92 X0\nX1.\nG52 X0\nX2.",
                {"R 6 0 0", "R 7 0 0", "R 8 0 0", "R 9 0 0"}},
        // haas-18-G101 haas-18-G100
        HaasRow{"Mirror",
                "G1 X10. Y5.\nG101 X0\nX10. Y6.\nX11.\nG100 X0\nX1.",
                {"F 10 5 0", "F -10 6 0", "F -11 6 0", "F 1 6 0"}},
        HaasRow{"MirrorTurnsArcs", "G101 X0\nG2 X10. Y10. R10.", {"A -10 10 0 c -10 0 0 90"}},
        // haas-18-G77
        HaasRow{"G77",
                "G0 Z10.\nG77 X10. Z-5. R-20. Q3.",
                {"R 0 0 10", "R 10 0 10", "R 13 0 10", "R 13 0 -20", "R 10 0 -20", "F 10 0 -5", "R 13 0 -5",
                 "R 13 0 10", "R 10 0 10"}},
        // haas-18-Ropt
        HaasRow{"NoR",
                "G0 Z1.\nG81 X3. Z-1.\nX4.",
                {"R 0 0 1", "R 3 0 1", "F 3 0 -1", "R 3 0 1", "R 4 0 1", "F 4 0 -1", "R 4 0 1"}},
        // haas-18-L
        HaasRow{"Repeats",
                "G91 G99 G81 X2. Z-3. R0 L2\nL0 X5.\nX1.",
                {"R 2 0 0", "F 2 0 -3", "R 2 0 0", "R 4 0 0", "F 4 0 -3", "R 4 0 0", "R 5 0 0", "F 5 0 -3",
                 "R 5 0 0"}},
        // haas-18-G73, acceptance 52: bottoms of falling pecks
        HaasRow{"G83Falling",
                "G99 G83 Z-10. R0 I3. J.5 K1.5",
                {"F 0 0 -3", "R 0 0 0", "R 0 0 -0.46", "F 0 0 -5.5", "R 0 0 0", "R 0 0 -2.96", "F 0 0 -7.5",
                 "R 0 0 0", "R 0 0 -4.96", "F 0 0 -9", "R 0 0 0", "R 0 0 -6.46", "F 0 0 -10", "R 0 0 0"}},
        HaasRow{"G73Falling",
                "G99 G73 Z-6. R0 I3. J1. K1.",
                {"F 0 0 -3", "R 0 0 -0.46", "F 0 0 -5", "R 0 0 -2.46", "F 0 0 -6", "R 0 0 0"}},
        HaasRow{"G73OutEachK",
                "G99 G73 Z-8. R0 Q2. K4.",
                {"F 0 0 -2", "R 0 0 0.54", "F 0 0 -4", "R 0 0 0", "R 0 0 -1.46", "F 0 0 -6", "R 0 0 -3.46",
                 "F 0 0 -8", "R 0 0 0"}},
        // haas-18-G84
        HaasRow{"RigidAlways", "G99 G84 Z-5. R0", {"T 0 0 -5", "T 0 0 0"}},
        // haas-18-G141
        HaasRow{"SpaceCompensation",
                "G141 D1 G1 X10. Y0. Z0. I0 J0 K1.\nX20. I1. K0\nX30. I3. K4.\nG40 X40.",
                {"F 10 0 2", "F 22 0 0", "F 31.2 0 1.6", "F 40 0 0"}},
        // haas-18-G103 haas-18-G187
        HaasRow{"Noted", "G103 P1\nG187 P3 E0.05\nG0 X1.\nG103\nX2.", {"R 1 0 0", "R 2 0 0"}},
        // haas-18-M
        HaasRow{"NotedFunctions", "M31\nG0 X1. M83\nM84\nM33\nM36\nM46 X2.", {"R 1 0 0", "R 2 0 0"}},
        // haas-18-G70, acceptance 48
        HaasRow{"G70",
                "G81 R2. Z-1. L0\nG99 G70 I40. J30. L6\nG80",
                {"R 34.641 20 0", "R 34.641 20 2", "F 34.641 20 -1", "R 34.641 20 2", "R 0 40 2", "F 0 40 -1",
                 "R 0 40 2", "R -34.641 20 2", "F -34.641 20 -1", "R -34.641 20 2", "R -34.641 -20 2",
                 "F -34.641 -20 -1", "R -34.641 -20 2", "R 0 -40 2", "F 0 -40 -1", "R 0 -40 2",
                 "R 34.641 -20 2", "F 34.641 -20 -1", "R 34.641 -20 2"}},
        HaasRow{"G70AboutAPoint",
                "G81 G99 R0 Z-1. G70 X100. Y10. I5. L2",
                {"R 105 10 0", "F 105 10 -1", "R 105 10 0", "R 95 10 0", "F 95 10 -1", "R 95 10 0"}},
        // haas-18-G71, acceptance 49
        HaasRow{"G71",
                "G99 G81 R0 Z-1. L0\nG71 I25. J15. K30. L3",
                {"R 24.1481 6.4705 0", "F 24.1481 6.4705 -1", "R 24.1481 6.4705 0", "R 17.6777 17.6777 0",
                 "F 17.6777 17.6777 -1", "R 17.6777 17.6777 0", "R 6.4705 24.1481 0", "F 6.4705 24.1481 -1",
                 "R 6.4705 24.1481 0"}},
        // haas-18-G72, acceptance 50
        HaasRow{"G72",
                "G99 G81 R0 Z-1. L0\nG72 I10. J30. L4\nG80 X0",
                {"F 0 0 -1", "R 0 0 0", "R 8.6603 5 0", "F 8.6603 5 -1", "R 8.6603 5 0", "R 17.3205 10 0",
                 "F 17.3205 10 -1", "R 17.3205 10 0", "R 25.9808 15 0", "F 25.9808 15 -1", "R 25.9808 15 0",
                 "R 0 15 0"}},
        // haas-18-macro
        HaasRow{"While", "#1= 0\nWH [#1 LT 2] DO1\nG1 X#1 Y1.\n#1= #1 + 1\nEND1", {"F 0 1 0", "F 1 1 0"}},
        HaasRow{"WhileOverNothing", "WH[1 EQ 2] DO1\nG1 X1.\nEND1\nG1 X2.", {"F 2 0 0"}},
        HaasRow{"GotoVariable", "#1= 20\nGOTO#1\nG0 X9.\nN20 G0 X1.", {"R 1 0 0"}}),
    [](const auto& row) { return std::string(row.param.name); });

struct HaasFault {
  const char* name;
  const char* program;
  const char* code;
};
class HaasFaults : public testing::TestWithParam<HaasFault> {};

TEST_P(HaasFaults, AreRefused) { EXPECT_EQ(haas(GetParam().program).error(), GetParam().code); }

INSTANTIATE_TEST_SUITE_P(
    Rows, HaasFaults,
    testing::Values(
        // haas-18-group
        HaasFault{"TwoOfAGroup", "G0 G1 X1.", "fanuc-group-clash"},
        HaasFault{"TwoFrames", "G54 G55", "fanuc-group-clash"},
        // haas-18-M96
        HaasFault{"M96", "M96 P10 Q1", "fanuc-no-input"}, HaasFault{"M109", "M109 P501", "fanuc-no-input"},
        // haas-18-G02
        HaasFault{"FullCircleByR", "G2 X0 Y0 R5.", "fanuc-arc-full-r"},
        HaasFault{"FullCircleByRAlone", "G3 R5.", "fanuc-arc-full-r"},
        // haas-18-G136
        HaasFault{"G136", "G136 B1 C2", "fanuc-010"}, HaasFault{"G35", "G35 R1. Z-1.", "fanuc-010"},
        HaasFault{"G37", "G37 Z-1.", "fanuc-010"},
        // haas-18-G143: without a rotary axis
        HaasFault{"G143", "G143 H1", "fanuc-machine-data"},
        HaasFault{"G234", "G234 H1", "fanuc-machine-data"}, HaasFault{"G254", "G254", "fanuc-machine-data"},
        HaasFault{"G154Missing", "G154", "fanuc-missing-data"},
        HaasFault{"G154Range", "G154 P100", "fanuc-003"}, HaasFault{"M97Missing", "M97 P5", "fanuc-078"},
        HaasFault{"PatternAlone", "G70 I5. L3", "fanuc-pattern-no-cycle"},
        HaasFault{"PatternNoCount", "G81 Z-1. R0 L0\nG70 I5.", "fanuc-missing-data"},
        HaasFault{"NoAxisOfMirror", "G101", "fanuc-mirror-axes"},
        HaasFault{"ArcInSpaceComp", "G141 D1 G1 X1.\nG2 X2. R3.", "fanuc-space-comp"},
        HaasFault{"PecksThatEnd", "G83 Z-10. R0 I2. J1.", "fanuc-003"},
        HaasFault{"G84J", "G84 Z-10. R0 J20", "fanuc-cycle-data"}),
    [](const auto& row) { return std::string(row.param.name); });

// haas-18-G04, acceptance 53
TEST(HaasMill, DwellWithAPointCountsSeconds) {
  const auto seconds = [](const std::string& text) {
    double sum = 0.0;
    for (const auto& e : haas(text).path.events) sum += e.event.as<event::Dwell>() ? e.event.time_s : 0.0;
    return sum;
  };
  EXPECT_NEAR(seconds("G4 P2."), 2.0, 1e-9);
  EXPECT_NEAR(seconds("G4 P2"), 0.002, 1e-9);
  EXPECT_NEAR(seconds("G82 Z-1. R0 P1.5"), 1.5, 1e-9);
  EXPECT_NEAR(seconds("G82 Z-1. R0 P15"), 0.015, 1e-9);
  EXPECT_NEAR(seconds("G83 Z-1. R0 Q1. P15"), 0.015, 1e-9);
}

// haas-18-G84: out twice as fast
TEST(HaasMill, TapsGoOutFasterByJ) {
  const IsoRun run = haas("G99 G84 Z-5. R0 J2");
  ASSERT_EQ(run.path.motions.size(), 2u);
  EXPECT_NEAR(run.path.motions[0].time_s, 2.0 * run.path.motions[1].time_s, 1e-9);
}

// haas-18-dec: Setting 162 off
TEST(HaasMill, IntegersInIncrements) {
  const IsoRun run = haas("G1 X50 Y50. F200", haasSettings({{"decimal", 1}}));
  EXPECT_EQ(run.motions(), (Lines{"F 0.05 50 0"}));
  ASSERT_EQ(run.path.motions.size(), 1u);
  EXPECT_NEAR(run.path.motions[0].time_s, std::hypot(0.05, 50.0) / 200.0 * 60.0, 1e-9);
  EXPECT_EQ(haas("G1 X50 Y50.").motions(), (Lines{"F 50 50 0"}));
}

// haas-18-G28: Z before the others
TEST(HaasMill, HomesAllAxes) {
  ControlSettings settings = haasSettings();
  settings.reference_points[0] = Vec3(-10, 20, 300);
  EXPECT_EQ(haas("G0 X5. Y6. Z7.\nG28", settings).motions(), (Lines{"R 5 6 7", "R 5 6 300", "R -10 20 300"}));
  EXPECT_EQ(haas("G0 X5. Y6. Z7.\nG91 G28 Z0", settings).motions(), (Lines{"R 5 6 7", "R 5 6 300"}));
}

// haas-18-G53: under G91 too, with G49 and M5
TEST(HaasMill, MachineCoordinates) {
  ControlSettings settings = haasSettings();
  settings.reference_points[0] = Vec3(0, 0, 100);
  EXPECT_EQ(haas("G0 X1.\nG91 G53 G49 X10. M5", settings).motions(), (Lines{"R 1 0 0", "R 10 0 0"}));
}

// haas-18-G52: Setting 33 at YASNAC makes it a frame of its own
TEST(HaasMill, LocalFrameByItself) {
  EXPECT_EQ(haas("G0 X1.\nG52 X5. Y1.\nX1. Y1.\nG54 X1.", haasSettings({{"setting_33", 1}})).motions(),
            (Lines{"R 1 0 0", "R 6 2 0", "R 1 2 0"}));
}

// haas-18-G107: on a cylinder of radius 20 mm, 90 degrees are 31.416 mm
TEST(HaasMill, Cylinder) {
  ControlSettings settings = haasSettings();
  AxisSettings table;
  table.name = "C";
  table.number = 4;
  table.center = Vec3::Zero();
  settings.axes.push_back(table);
  const IsoRun run = haas("G0 Z25. C0\nG107 C20.\nG1 Z20. F100.\nC90. X10.\nG107 C0\nG0 Z30.", settings);
  EXPECT_EQ(run.error(), "") << run.message();
  double time = 0.0;
  for (const Motion& m : run.path.motions)
    if (m.source.line == 6) time += m.time_s;
  EXPECT_NEAR(time, 60.0 * std::hypot(20.0 * kPi / 2.0, 10.0) / 100.0, 1e-6);
}

/// X is where the program says: what it reads.
double readsX(const std::string& text) { return haas(text).end().x(); }

// haas-18-vars: #10100 and #10500 are #100 and #500, the others storage; tool data are 0 until written
TEST(HaasMacro, FurtherVariables) {
  EXPECT_EQ(readsX("#100= 7.\nG1 X#10100"), 7.0);
  EXPECT_EQ(readsX("#10999= 8.\nG1 X#999"), 8.0);
  EXPECT_EQ(readsX("#10300= 9.\nG1 X#10300"), 9.0);
  EXPECT_EQ(readsX("G1 X5.\nX#10301 Y1."), 5.0);  // never written: no word
  const IsoRun tools = haas("G1 X5.\nX[#8550 + 1]");
  EXPECT_EQ(tools.end().x(), 1.0);
  EXPECT_TRUE(tools.tells("fanuc-tool-data"));
  EXPECT_EQ(readsX("#8550= 4.\nG1 X#8550"), 4.0);
}

// haas-18-offsets: H geometry #2001, H wear #2201
TEST(HaasMacro, NumbersOfOffsets) {
  ControlSettings settings = haasSettings();
  settings.length_offsets[3] = {50.0, -0.5};
  EXPECT_EQ(haas("G1 X#2003 Y#2203", settings).end(), Vec3(50.0, -0.5, 0.0));
}

// haas-18-macro: #3000 = 5 is alarm 1005
TEST(HaasMacro, AlarmsCountFromAThousand) { EXPECT_EQ(haas("#3000= 5 (NO PART)").error(), "fanuc-1005"); }

// haas-18-Ropt haas-18-L
TEST(HaasMill, TellsNoMissingR) { EXPECT_FALSE(haas("G81 X3. Z-1.").tells("fanuc-cycle-no-r")); }

}  // namespace
}  // namespace proveout::test
