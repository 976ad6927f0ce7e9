// Drilling cycles of mills (section 10 of the rows): motions of holes by the tables and worked examples of
// the specification.
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Settings = std::map<std::string, double>;

/// The tool starts at (0, 0, 10); G21 G90 G17, F100.
IsoRun cycles(const std::string& text, Settings parameters = {}) {
  parameters.emplace("rapid", 1.0);  // straight ways between the holes
  ControlSettings settings = runAtZero(parameters);
  settings.start = Vec3(0, 0, 10);
  return {ControlId::kFanucMill, "G21 G90 G17 F100 S500\n" + text + "\nM30\n", settings};
}

struct CycleRow {
  const char* name;
  const char* program;
  Lines motions;
};

class FanucCycleTable : public testing::TestWithParam<CycleRow> {};

TEST_P(FanucCycleTable, GivesTheMotionsOfTheHole) {
  const IsoRun run = cycles(GetParam().program);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), GetParam().motions);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, FanucCycleTable,
    testing::Values(
        // fan-10-G81
        CycleRow{"G81", "G81 X5 Y2 Z-10 R2", {"R 5 2 10", "R 5 2 2", "F 5 2 -10", "R 5 2 10"}},
        // fan-10-G82
        CycleRow{"G82", "G99 G82 X5 Z-10 R2 P500", {"R 5 0 10", "R 5 0 2", "F 5 0 -10", "R 5 0 2"}},
        // fan-10-G83, acceptance 26
        CycleRow{"G83",
                 "G83 X5 Z-10 R2 Q5",
                 {"R 5 0 10", "R 5 0 2", "F 5 0 -3", "R 5 0 2", "R 5 0 -2.5", "F 5 0 -8", "R 5 0 2",
                  "R 5 0 -7.5", "F 5 0 -10", "R 5 0 10"}},
        // fan-10-G73, acceptance 27
        CycleRow{"G73",
                 "G99 G73 Z-10 R2 Q5",
                 {"R 0 0 2", "F 0 0 -3", "R 0 0 -2.5", "F 0 0 -8", "R 0 0 -7.5", "F 0 0 -10", "R 0 0 2"}},
        // fan-10-G84
        CycleRow{"G84", "M3 G84 Z-10 R2 P100", {"R 0 0 2", "T 0 0 -10", "T 0 0 2", "R 0 0 10"}},
        // fan-10-G74
        CycleRow{"G74", "M4\nG99 G74 Z-10 R2", {"R 0 0 2", "T 0 0 -10", "T 0 0 2"}},
        // fan-10-G85
        CycleRow{"G85", "G85 Z-10 R2", {"R 0 0 2", "F 0 0 -10", "F 0 0 2", "R 0 0 10"}},
        // fan-10-G86
        CycleRow{"G86", "M3\nG86 Z-10 R2", {"R 0 0 2", "F 0 0 -10", "R 0 0 10"}},
        // fan-10-G88
        CycleRow{"G88", "M3\nG88 Z-10 R2 P100", {"R 0 0 2", "F 0 0 -10", "R 0 0 2", "R 0 0 10"}},
        // fan-10-G89
        CycleRow{"G89", "G99 G89 Z-10 R2 P100", {"R 0 0 2", "F 0 0 -10", "F 0 0 2"}},
        // fan-10-G76: the worked example
        CycleRow{"G76",
                 "G76 X10 Z-20 R2 Q0.2",
                 {"R 10 0 10", "R 10 0 2", "F 10 0 -20", "R 10.2 0 -20", "R 10.2 0 10", "R 10 0 10"}},
        CycleRow{"G76ByVector",
                 "G76 X10 Z-20 R2 I0.1 J-0.2",
                 {"R 10 0 10", "R 10 0 2", "F 10 0 -20", "R 10.1 -0.2 -20", "R 10.1 -0.2 10", "R 10 0 10"}},
        CycleRow{"G76NegativeQ",
                 "G99 G76 Z-20 R2 Q-0.2",
                 {"R 0 0 2", "F 0 0 -20", "R 0.2 0 -20", "R 0.2 0 2", "R 0 0 2"}},
        // fan-10-G87: the worked example
        CycleRow{"G87",
                 "G87 X10 Z-5 R-20 Q3 P200",
                 {"R 10 0 10", "R 13 0 10", "R 13 0 -20", "R 10 0 -20", "F 10 0 -5", "R 13 0 -5", "R 13 0 10",
                  "R 10 0 10"}},
        // fan-10-return: G99 stays when the cycle ends, G98 is the default
        CycleRow{"ReturnLevels",
                 "G99 G81 X1 Z-1 R2\nG98 X2\nG80\nG0 X3\nG81 X4 Z-1 R2",
                 {"R 1 0 10", "R 1 0 2", "F 1 0 -1", "R 1 0 2", "R 2 0 2", "F 2 0 -1", "R 2 0 10", "R 3 0 10",
                  "R 4 0 10", "R 4 0 2", "F 4 0 -1", "R 4 0 10"}},
        CycleRow{"G99StaysBehindG80",
                 "G99 G81 Z-1 R2\nG80\nG81 X4 Z-1 R3",
                 {"R 0 0 2", "F 0 0 -1", "R 0 0 2", "R 4 0 2", "R 4 0 3", "F 4 0 -1", "R 4 0 3"}},
        // fan-10-K fan-10-inc, acceptance 28
        CycleRow{"Repeats",
                 "G91 G99 G81 X10 Z-5 R-8 K3",
                 {"R 10 0 10", "R 10 0 2", "F 10 0 -3", "R 10 0 2", "R 20 0 2", "F 20 0 -3", "R 20 0 2",
                  "R 30 0 2", "F 30 0 -3", "R 30 0 2"}},
        CycleRow{"RepeatsByL",
                 "G91 G99 G81 Y2 Z-5 R-8 L2",
                 {"R 0 2 10", "R 0 2 2", "F 0 2 -3", "R 0 2 2", "R 0 4 2", "F 0 4 -3", "R 0 4 2"}},
        CycleRow{"RepeatsInOnePlace",
                 "G99 G81 X1 Z-1 R10 K2",
                 {"R 1 0 10", "F 1 0 -1", "R 1 0 10", "F 1 0 -1", "R 1 0 10"}},
        CycleRow{"NoRepeatKeepsTheWords",
                 "G99 G81 Z-1 R2 K0\nX5\nX6 K0\nX7",
                 {"R 5 0 10", "R 5 0 2", "F 5 0 -1", "R 5 0 2", "R 7 0 2", "F 7 0 -1", "R 7 0 2"}},
        // fan-10-nomove
        CycleRow{"BlocksWithoutAxes",
                 "G99 G81 X1 Z-1 R10\nF50\nP300\nS100\nX2",
                 {"R 1 0 10", "F 1 0 -1", "R 1 0 10", "R 2 0 10", "F 2 0 -1", "R 2 0 10"}},
        CycleRow{"RAloneDrills",
                 "G99 G81 X1 Z-1 R10\nR9",
                 {"R 1 0 10", "F 1 0 -1", "R 1 0 10", "R 1 0 9", "F 1 0 -1", "R 1 0 9"}},
        CycleRow{"CodeFirstWordsLater", "G99 G81\nX1 Z-1 R10", {"R 1 0 10", "F 1 0 -1", "R 1 0 10"}},
        // fan-10-group1, acceptance 29
        CycleRow{"GroupOneEnds",
                 "G81 X1 Z-1 R1\nG0 X5\nX6",
                 {"R 1 0 10", "R 1 0 1", "F 1 0 -1", "R 1 0 10", "R 5 0 10", "R 6 0 10"}},
        CycleRow{"TheLaterOfMotionAndCycleHolds",
                 "G81 G0 X1 Z9\nX2\nG1 G81 X3 Z-1 R9\nG80 X4",
                 {"R 1 0 9", "R 2 0 9", "R 3 0 9", "F 3 0 -1", "R 3 0 9", "F 4 0 9"}},
        // fan-10-G80
        CycleRow{"G80", "G99 G81 X1 Z-1 R10\nG80\nX2", {"R 1 0 10", "F 1 0 -1", "R 1 0 10", "R 2 0 10"}},
        CycleRow{"ModalWords",
                 "G99 G83 X1 Z-8 R2 Q5\nX2\nG81 X3\nX4 Z-1\nX5 R3",
                 {"R 1 0 10", "R 1 0 2", "F 1 0 -3", "R 1 0 2",  "R 1 0 -2.5", "F 1 0 -8",
                  "R 1 0 2",  "R 2 0 2", "F 2 0 -3", "R 2 0 2",  "R 2 0 -2.5", "F 2 0 -8",
                  "R 2 0 2",  "R 3 0 2", "F 3 0 -8", "R 3 0 2",  "R 4 0 2",    "F 4 0 -1",
                  "R 4 0 2",  "R 5 0 2", "R 5 0 3",  "F 5 0 -1", "R 5 0 3"}},
        CycleRow{"RAboveTheStart",
                 "G0 Z1\nG81 X1 Z-1 R4",
                 {"R 0 0 1", "R 1 0 1", "R 1 0 4", "F 1 0 -1", "R 1 0 1"}},
        CycleRow{
            "InTheZxPlane", "G18 G99 G81 X4 Z3 Y-5 R-1", {"R 4 0 3", "R 4 -1 3", "F 4 -5 3", "R 4 -1 3"}},
        CycleRow{"Polar",
                 "G16 G99 G81 X50 Y30 Z-1 R10\nY120\nG15",
                 {"R 43.3013 25 10", "F 43.3013 25 -1", "R 43.3013 25 10", "R -25 43.3013 10",
                  "F -25 43.3013 -1", "R -25 43.3013 10"}},
        CycleRow{"PolarSteps",
                 "G16 G99 G81 X50 Y0 Z-1 R10\nG91 Y90 K2\nG15",
                 {"R 50 0 10", "F 50 0 -1", "R 50 0 10", "R 0 50 10", "F 0 50 -1", "R 0 50 10", "R -50 0 10",
                  "F -50 0 -1", "R -50 0 10"}},
        // fan-10-rigid: as the worked example
        CycleRow{"Rigid", "M29 S500\nG84 Z-20 R5 F625", {"R 0 0 5", "T 0 0 -20", "T 0 0 5", "R 0 0 10"}},
        CycleRow{"RigidInTheBlock", "G84 Z-20 R5 F625 M29", {"R 0 0 5", "T 0 0 -20", "T 0 0 5", "R 0 0 10"}},
        // fan-10-rigidpeck
        CycleRow{"RigidPecks",
                 "M29 S500\nG99 G84 Z-20 R5 Q10 F625",
                 {"R 0 0 5", "T 0 0 -5", "T 0 0 -4.5", "T 0 0 -15", "T 0 0 -14.5", "T 0 0 -20", "T 0 0 5"}}),
    [](const auto& row) { return std::string(row.param.name); });

struct FaultRow {
  const char* name;
  const char* program;
  const char* code;
};
class FanucCycleFault : public testing::TestWithParam<FaultRow> {};

TEST_P(FanucCycleFault, IsAnAlarm) { EXPECT_EQ(cycles(GetParam().program).error(), GetParam().code); }

INSTANTIATE_TEST_SUITE_P(Rows, FanucCycleFault,
                         testing::Values(
                             // fan-10-missing
                             FaultRow{"NoQ", "G83 Z-10 R2", "fanuc-045"},
                             FaultRow{"ZeroQ", "G73 Z-10 R2 Q0", "fanuc-045"},
                             FaultRow{"NegativeQ", "G83 Z-10 R2 Q-1", "fanuc-045"},
                             FaultRow{"NoZ", "G81 X1 R2", "fanuc-cycle-no-z"},
                             FaultRow{"TinyQ", "G83 Z-1000 R2 Q0.001", "fanuc-003"},
                             FaultRow{"PointOfP", "G82 Z-1 R2 P1.5", "fanuc-007"},
                             // fan-10-G81.1
                             FaultRow{"Chopping", "G81.1 Z-1 Q5 R2 F100", "fanuc-010"},
                             // fan-10-rigiderr
                             FaultRow{"RigidNoS", "S0 M29\nG84 Z-1 R2", "fanuc-200"},
                             FaultRow{"MoveBehindM29", "M29 S500\nG0 X1\nG84 Z-1 R2", "fanuc-203"},
                             FaultRow{"HomeBehindM29", "M29 S500\nG91 G28 Z0\nG84 Z-1 R2", "fanuc-203"},
                             FaultRow{"OtherCycleBehindM29", "M29 S500\nG81 Z-1 R2", "fanuc-203"}),
                         [](const auto& row) { return std::string(row.param.name); });

// fan-10-rigiderr
TEST(FanucCycles, RigidTappingNeedsFeed) {
  const IsoRun run(ControlId::kFanucMill, "S500 M29\nG84 Z-1 R2\nM30\n");
  EXPECT_EQ(run.error(), "fanuc-201");
}

// fan-10-missing
TEST(FanucCycles, MissingRIsTheStartLevel) {
  const IsoRun run = cycles("G81 X1 Z-1");
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 10", "F 1 0 -1", "R 1 0 10"}));
  EXPECT_TRUE(run.tells("fanuc-cycle-no-r"));
}

// fan-10-rigid: lead 625/500 = 1.25 mm; 25 mm at 625 mm/min take 2.4 s each way
TEST(FanucCycles, RigidTapsTakeTheTimeOfTheirLead) {
  const IsoRun run = cycles("M29 S500\nG99 G84 Z-20 R5 F625");
  ASSERT_EQ(run.path.motions.size(), 3u);
  EXPECT_NEAR(run.path.motions[1].time_s, 2.4, 1e-9);
  EXPECT_NEAR(run.path.motions[2].time_s, 2.4, 1e-9);
}

// fan-10-rigid: per turn F is the lead
TEST(FanucCycles, RigidTapsPerTurn) {
  const IsoRun run = cycles("G95 M29 S500\nG99 G84 Z-20 R5 F1.25");
  ASSERT_EQ(run.path.motions.size(), 3u);
  EXPECT_NEAR(run.path.motions[1].time_s, 2.4, 1e-9);
}

// fan-10-rigidpeck
TEST(FanucCycles, FullPecksOfTapsGoOutToR) {
  EXPECT_EQ(cycles("M29 S500\nG99 G84 Z-20 R5 Q10 F625", {{"rigid_peck", 1}}).motions(),
            (Lines{"R 0 0 5", "T 0 0 -5", "T 0 0 5", "T 0 0 -15", "T 0 0 5", "T 0 0 -20", "T 0 0 5"}));
}

TEST(FanucCycles, RigidWithoutM29BySetting) {
  const IsoRun run = cycles("G99 G84 Z-20 R5 Q10 F625", {{"g84_rigid", 1}});
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions().size(), 7u);
}

TEST(FanucCycles, ShiftAndPecksBySetting) {
  EXPECT_EQ(cycles("G99 G76 Z-2 R2 Q0.2", {{"g76_shift", 3}}).motions(),
            (Lines{"R 0 0 2", "F 0 0 -2", "R 0 -0.2 -2", "R 0 -0.2 2", "R 0 0 2"}));
  EXPECT_EQ(cycles("G99 G83 Z-4 R2 Q5", {{"g83_clearance", 1}}).motions(),
            (Lines{"R 0 0 2", "F 0 0 -3", "R 0 0 2", "R 0 0 -2", "F 0 0 -4", "R 0 0 2"}));
  EXPECT_EQ(cycles("G99 G73 Z-4 R2 Q5", {{"g73_retract", 1}}).motions(),
            (Lines{"R 0 0 2", "F 0 0 -3", "R 0 0 -2", "F 0 0 -4", "R 0 0 2"}));
}

TEST(FanucCycles, DwellCountsMilliseconds) {
  const IsoRun run = cycles("G99 G82 Z-1 R2 P1500");
  double dwell = 0.0;
  for (const auto& e : run.path.events) dwell += e.event.time_s;
  EXPECT_NEAR(dwell, 1.5, 1e-9);
}

// One note a setting that the path depends on.
TEST(FanucCycles, TellsTheSettingOfThePecks) {
  const IsoRun run = cycles("G99 G83 Z-4 R2 Q5\nX1");
  int notes = 0;
  for (const Diagnostic& d : run.path.diagnostics.all())
    notes += d.message.find("g83_clearance") != std::string::npos ? 1 : 0;
  EXPECT_EQ(notes, 1);
}

}  // namespace
}  // namespace proveout::test
