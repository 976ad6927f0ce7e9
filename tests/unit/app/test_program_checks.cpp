// What a machine would not forgive, told from the program, the job and the blank's bounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/machining/programs.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

using app_test::blockJob;
using app_test::ofKind;
using app_test::toolOf;
using testing::HasSubstr;

/// A plate of 60 by 40 by 10 with a mill of 10 and a drill of 6.
Job plate(const std::string& control = "nct") {
  Job job = blockJob("plate", {60, 40, 10}, {toolOf(1, 10), toolOf(2, 6, ToolType::kDrill)});
  job.control = control;
  return job;
}

/// A bar of 50 and an insert, for flexnc and wl4-lathe.
Job bar(const std::string& control) {
  Job job;
  job.name = "bar";
  job.control = control;
  job.stock = CylinderShape{2, {0, 0, -60}, 25, 0, 60};
  for (const int number : {1, 2}) {
    Tool tool;
    tool.number = number;
    tool.type = ToolType::kInsert;
    Insert& insert = tool.insert.emplace();
    insert.orientation = 3;
    insert.nose_radius = 0.4;
    insert.insert_angle_deg = 55;
    insert.lead_angle_deg = 93;
    insert.edge_length = 11;
    job.tools.push_back(tool);
  }
  return job;
}

std::vector<Finding> told(const Job& job, const std::string& program, FindingKind kind) {
  const Result<RunResult> run = app_test::run(job, {program});
  EXPECT_TRUE(run.ok()) << run.error().message;
  if (!run.ok()) return {};
  EXPECT_FALSE(run->alarm) << program;
  return ofKind(run->findings, kind);
}

std::vector<Finding> checked(const Job& job, const std::string& program, FindingKind kind) {
  const MemoryProgramSource memory("part.nc", program);
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  const Result<Blank> blank = openBlank(job, progress);
  EXPECT_TRUE(blank.ok());
  const Result<ReadProgram> read = readProgram(job, 0, &*blank, source, 20, progress);
  EXPECT_TRUE(read.ok());
  return read.ok() ? ofKind(read->findings, kind) : std::vector<Finding>{};
}

// The spindle.

constexpr const char* kSlot = "G0 X-10 Y20 Z5\nZ-3\nG1 X30 F100\nG0 Z20\nM30\n";

TEST(StandingSpindle, TheBlockThatStoppedItIsNamed) {
  const auto found = told(plate(), "T1 M6\nS500 M3\nG0 X-10 Y20 Z5\nM5\nZ-3\nG1 X30 F100\nG0 Z20\nM30\n",
                          FindingKind::kSpindleOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_EQ(found[0].source->line, 6u);
  EXPECT_THAT(found[0].message, HasSubstr("since M5 (part.nc:4)"));
  ASSERT_EQ(found[0].causes.size(), 1u) << "no speed would make it turn";
  EXPECT_EQ(found[0].causes[0].source->line, 4u);
}

TEST(StandingSpindle, M5InPlaceOfM3IsNoSpindleOfThePerson) {
  const auto found = told(plate(), std::string("T1 M6\nS500 M5\n") + kSlot, FindingKind::kSpindleOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_THAT(found[0].message, HasSubstr("since M5 (part.nc:2)"));
}

TEST(StandingSpindle, M3WithoutAnySpeedIsToldSo) {
  const auto found = told(plate(), std::string("T1 M6\nM3\n") + kSlot, FindingKind::kSpindleOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_THAT(found[0].message, HasSubstr("no speed S was given for M3 (part.nc:2)"));
  EXPECT_EQ(found[0].message.find("never starts"), std::string::npos);
}

TEST(StandingSpindle, WithoutM3ItWeighsTheSameOnEveryControl) {
  const std::pair<Job, std::string> cases[] = {
      {plate("nct"), std::string("T1 M6\nS500\n") + kSlot},
      {plate("wl4-mill"), std::string("%N\nT1 M6\nS500\n") + kSlot},
      {bar("wl4-lathe"), "%N\nG54 G90 G95\nT1 M6\nG0 X40 Z2\nG1 Z-20 F0.1\nX60\nM2\n"},
      {bar("flexnc"), "T1M06\nG99F0.1\nG0X20Z2\nG1Z-20\nX30\nM02\n"}};
  for (const auto& [job, program] : cases) {
    const auto found = told(job, program, FindingKind::kSpindleOff);
    ASSERT_EQ(found.size(), 1u) << job.control;
    EXPECT_EQ(found[0].severity, Severity::kWarning) << job.control;
    EXPECT_THAT(found[0].message, HasSubstr("M3 is missing")) << job.control;
  }
}

TEST(StandingSpindle, AStartThatComesLaterIsNamed) {
  const auto found =
      told(plate(), "T1 M6\nG0 X-10 Y20 Z5\nZ-3\nG1 X30 F100\nG0 Z20\nS500 M3\nX-10\nZ-5\nG1 X30\nG0 Z20\n",
           FindingKind::kSpindleOff);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_THAT(found[0].message, HasSubstr("started only later, in part.nc:6"));
}

// Tool changes.

/// A slot with tool 1, `leave`, a hole with tool 2.
std::string twoTools(const std::string& leave, const std::string& call = "T2 M6\n") {
  return "G21 G90\nT1 M6\nS1000 M3\nG0 X-10 Y20 Z5\nG1 Z-4 F200\nX25\n" + leave + call +
         "S800 M3\nG0 X50 Y10 Z5\nG1 Z-5\nG0 Z50\nM30\n";
}

TEST(LowToolChange, WithoutARetractItIsTold) {
  for (const bool cuts : {true, false}) {
    const auto found = cuts ? told(plate(), twoTools(""), FindingKind::kToolChange)
                            : checked(plate(), twoTools(""), FindingKind::kToolChange);
    ASSERT_EQ(found.size(), 1u) << cuts;
    EXPECT_EQ(found[0].severity, Severity::kWarning);
    EXPECT_EQ(found[0].source->line, 7u);
    EXPECT_EQ(found[0].tool, 1);
    EXPECT_EQ(found[0].where, Vec3(25, 20, -4));
    EXPECT_THAT(found[0].message,
                HasSubstr("tool change called 4 mm below the top of the part, without a retract"));
  }
}

TEST(LowToolChange, OnTheOtherMillingControlToo) {
  const auto found = told(plate("wl4-mill"),
                          "%N\nG54 G90 G94\nT1 M6\nS1000 M3\nG0 X-10 Y20 Z5\nG1 Z-4 F200\nX25\n"
                          "T2 M6\nG0 X50 Y10 Z5\nG1 Z-5 F100\nG0 Z50\nM2\n",
                          FindingKind::kToolChange);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].source->line, 8u);
}

TEST(LowToolChange, WhatRetractsIsQuiet) {
  Job job = plate();
  job.settings.reference_points[0] = Vec3(0, 0, 200);
  for (const char* leave : {"G0 Z1\n", "G0 Z0\n", "G28 G91 Z0\nG90\n", "G53 G0 Z200\n", "G0 Y80\n"})
    EXPECT_TRUE(told(job, twoTools(leave), FindingKind::kToolChange).empty()) << leave;
  EXPECT_TRUE(told(job, twoTools("", "G0 Z50 T2 M6\n"), FindingKind::kToolChange).empty());
  EXPECT_TRUE(told(job, twoTools("", "T1 M6\nG0 Z20\nT2 M6\n"), FindingKind::kToolChange).empty())
      << "it is in";
  job.settings.tool_change.z = 150;
  EXPECT_TRUE(told(job, twoTools(""), FindingKind::kToolChange).empty())
      << "the job says how high the machine goes";
}

TEST(LowToolChange, BesideTheBlankIsNotClear) {
  EXPECT_EQ(told(plate(), twoTools("G1 X68\n"), FindingKind::kToolChange).size(), 1u);
  EXPECT_TRUE(told(plate(), twoTools("G1 X72\n"), FindingKind::kToolChange).empty());
}

TEST(LowToolChange, AFixtureIsAnObstacle) {
  Job job = plate();
  job.fixtures.push_back({"clamp", BoxShape{{20, 45, -10}, {30, 60, 20}}});
  const auto found = told(job, twoTools("G0 Z5\nX25 Y37\n"), FindingKind::kToolChange);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("15 mm below the top of fixture 'clamp'"));
}

TEST(LowToolChange, WhatStandsNearCounts) {
  Job job = plate();
  job.stock = CylinderShape{0, {0, 20, -10}, 10, 0, 60};  // a bar lying along X, its top at Z0
  EXPECT_EQ(told(job, twoTools("G0 Z-4\n"), FindingKind::kToolChange).size(), 1u);
  job.tools[0].diameter = 2;
  EXPECT_TRUE(told(job, twoTools("G0 Y34\nZ-3.5\n"), FindingKind::kToolChange).empty());  // its side is lower
  EXPECT_EQ(told(job, twoTools("G0 Y34\nZ-5\n"), FindingKind::kToolChange).size(), 1u);
}

TEST(LowToolChange, ATurretIsIndexedOutsideOfTheBlank) {
  const std::string low = "%N\nG54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X60 Z2\nX46\nG1 Z-20 F0.1\n",
                    change = "T2 M6\nG0 X60 Z5\nM5\nM2\n";
  const auto found = told(bar("wl4-lathe"), low + change, FindingKind::kToolChange);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("inside of what the blank sweeps"));
  EXPECT_TRUE(told(bar("wl4-lathe"), low + "X60\n" + change, FindingKind::kToolChange).empty());
  EXPECT_TRUE(told(bar("wl4-lathe"), low + "G0 Z2\n" + change, FindingKind::kToolChange).empty());
}

// Times.

TEST(LongDwell, MillisecondsReadAsSeconds) {
  const std::string program =
      "T1 M6\nS1000 M3\nG0 X-10 Y20 Z5\nG1 Z-1 F200\nG4 P500\nX20\nG4 P2000\nG0 Z20\nM30\n";
  const auto found = told(plate(), program, FindingKind::kDwell);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].source->line, 7u);
  EXPECT_EQ(found[0].spots, 2u);
  EXPECT_THAT(found[0].message,
              HasSubstr("P is read in seconds by this control; on other controls it is in milliseconds"));
  EXPECT_EQ(checked(plate(), program, FindingKind::kDwell).size(), 1u);
}

TEST(LongDwell, ManyShortOnesOutOfProportion) {
  std::string holes = "T2 M6\nS800 M3\nG0 X10 Y10 Z5\n";
  for (int i = 0; i < 4; ++i) holes += "G1 Z-1 F500\nG4 P10\nG0 Z5\n";
  EXPECT_EQ(told(plate(), holes + "M30\n", FindingKind::kDwell).size(), 1u);
}

TEST(LongDwell, UsualOnesAreQuiet) {
  for (const char* dwell : {"G4 P0.5\n", "G4 P5\n", "G4 P20\n"}) {
    const std::string program =
        std::string("T1 M6\nS1000 M3\nG0 X-10 Y20 Z5\nG1 Z-1 F200\n") + dwell + "X20\nG0 Z20\nM30\n";
    EXPECT_TRUE(told(plate(), program, FindingKind::kDwell).empty()) << dwell;
  }
}

TEST(LongDwell, OtherControlsHaveOtherWords) {
  const auto wl4 =
      told(plate("wl4-mill"), "%N\nT1 M6\nS500 M3\nG0 X-10 Y20 Z5\nG1 Z-1 F200\nG4 E500\nX20\nG0 Z20\nM2\n",
           FindingKind::kDwell);
  ASSERT_EQ(wl4.size(), 1u);
  EXPECT_THAT(wl4[0].message, HasSubstr("E is read in seconds"));
  const auto flexnc = told(bar("flexnc"), "T1M06\nS500M03\nG99F0.1\nG0X20Z2\nG04X500\nG1Z-5\nX30\nM02\n",
                           FindingKind::kDwell);
  ASSERT_EQ(flexnc.size(), 1u);
  EXPECT_THAT(flexnc[0].message, HasSubstr("X is read in seconds"));
}

// Limits of machine and tools.

const std::string kTwoSpeeds =
    "T1 M6\nS5000 M3\nG0 X-10 Y20 Z5\nG1 Z-1 F200\nX20 F2000\nX30 F2400\nX40 F900\nG0 Z20\n"
    "T2 M6\nS9000 M3\nG0 X50 Y10 Z5\nG1 Z-5 F100\nG0 Z50\nM30\n";

TEST(Limits, WithoutAnyNothingIsTold) {
  EXPECT_TRUE(told(plate(), kTwoSpeeds, FindingKind::kFeedRate).empty());
  EXPECT_TRUE(told(plate(), kTwoSpeeds, FindingKind::kSpindleSpeed).empty());
}

TEST(Limits, AFeedAboveTheMachinesIsOneFinding) {
  Job job = plate();
  job.limits.max_feed = 1000;
  for (const bool cuts : {true, false}) {
    const auto found = cuts ? told(job, kTwoSpeeds, FindingKind::kFeedRate)
                            : checked(job, kTwoSpeeds, FindingKind::kFeedRate);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::kWarning);
    EXPECT_EQ(found[0].source->line, 5u);
    EXPECT_EQ(found[0].spots, 2u);
    EXPECT_THAT(found[0].message,
                HasSubstr("2400 mm/min is more than the machine's max_feed of 1000 mm/min"));
    EXPECT_THAT(found[0].message, HasSubstr("the worst in part.nc:6"));
  }
  job.limits.max_feed = 2400;
  EXPECT_TRUE(told(job, kTwoSpeeds, FindingKind::kFeedRate).empty());
}

TEST(Limits, AFeedPerToothOfATool) {
  Job job = plate();
  job.limits.tools[1] = {0.0, 0.1, 4};  // 2400 / (5000 * 4) = 0.12
  const auto found = told(job, kTwoSpeeds, FindingKind::kFeedRate);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].source->line, 6u);
  EXPECT_THAT(found[0].message, HasSubstr("0.12 mm per tooth"));
}

TEST(Limits, ASpeedAboveTheLowerOfBoth) {
  Job job = plate();
  job.limits.max_rpm = 8000;
  job.limits.tools[1].max_rpm = 4000;
  const auto found = told(job, kTwoSpeeds, FindingKind::kSpindleSpeed);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].tool, 1);
  EXPECT_THAT(found[0].message, HasSubstr("5000 rpm, more than max_rpm of tool 1, 4000 rpm"));
  EXPECT_EQ(found[1].tool, 2);
  EXPECT_THAT(found[1].message, HasSubstr("9000 rpm, more than max_rpm of the machine, 8000 rpm"));
}

TEST(Limits, OfConstantSurfaceSpeedTheLimitedOneCounts) {
  Job job = bar("wl4-lathe");
  job.limits.max_rpm = 1500;
  const auto program = [](const std::string& limit) {
    return "%N\nG54 G90 G95\nT1 M6\n" + limit + "G96 S300 M3\nG0 X60 Z-1\nG1 X20 F0.1\nG0 X60\nM5\nM2\n";
  };
  EXPECT_EQ(told(job, program("G51 S4000\n"), FindingKind::kSpindleSpeed).size(), 1u);
  EXPECT_TRUE(told(job, program("G51 S1200\n"), FindingKind::kSpindleSpeed).empty());
}

// Drills.

TEST(DrillMoves, SidewaysThroughMaterialIsTold) {
  const auto found = told(plate(), "T2 M6\nS800 M3\nG0 X10 Y10 Z5\nG1 Z-3 F100\nX30\nX40\nG0 Z20\nM30\n",
                          FindingKind::kDrillSideways);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kWarning);
  EXPECT_EQ(found[0].source->line, 5u);
  EXPECT_EQ(found[0].spots, 2u);
  EXPECT_EQ(found[0].tool, 2);
}

TEST(DrillMoves, HolesAndMovesThroughAirAreQuiet) {
  for (const char* body :
       {"G1 Z-8 F100\nG0 Z5\n", "G81 Z-8 R2 F100\nX30\nG80\n", "G1 Z1 F100\nX40\nZ-4\nG0 Z5\n"})
    EXPECT_TRUE(told(plate(), std::string("T2 M6\nS800 M3\nG0 X10 Y10 Z5\n") + body + "G0 Z20\nM30\n",
                     FindingKind::kDrillSideways)
                    .empty())
        << body;
  EXPECT_TRUE(told(plate(), std::string("T1 M6\nS500 M3\n") + kSlot, FindingKind::kDrillSideways).empty());
}

// Units.

/// A contour of 50 by 30 round a boss, in the unit of the blank times `scale`.
std::string contour(double scale, const std::string& head) {
  const auto at = [&](double x, double y) { return fmt::format("X{:.4f} Y{:.4f}\n", scale * x, scale * y); };
  return head + "T1 M6\nS1000 M3\nG0 " + at(5, 5) +
         fmt::format("Z{:.4f}\nG1 Z{:.4f} F100\n", 5 * scale, -4 * scale) + at(55, 5) + at(55, 35) +
         at(5, 35) + at(5, 5) + fmt::format("G0 Z{:.4f}\nM30\n", 50 * scale);
}

TEST(ProgramUnit, InchesReadAsMillimetres) {
  for (const bool cuts : {true, false}) {
    const std::string program = contour(1 / 25.4, "G90\nG21\n");
    const auto found = cuts ? told(plate(), program, FindingKind::kProgramUnit)
                            : checked(plate(), program, FindingKind::kProgramUnit);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::kWarning);
    EXPECT_EQ(found[0].source->line, 2u);
    EXPECT_THAT(found[0].message, HasSubstr("inches read as millimetres would fit, is G21 right?"));
  }
}

TEST(ProgramUnit, MillimetresReadAsInches) {
  const auto found = told(plate(), contour(1, "G90\nG20\n"), FindingKind::kProgramUnit);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("millimetres read as inches would fit, is G20 right?"));
}

TEST(ProgramUnit, OfProgramsThatDoNotSayItTheJobIsNamed) {
  const auto found = told(plate(), contour(1 / 25.4, ""), FindingKind::kProgramUnit);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("power-on unit is \"mm\""));
}

TEST(ProgramUnit, RightOnesAndSmallCutsAreQuiet) {
  EXPECT_TRUE(told(plate(), contour(1, "G21\n"), FindingKind::kProgramUnit).empty());
  EXPECT_TRUE(told(plate(), contour(1 / 25.4, "G20\n"), FindingKind::kProgramUnit).empty());
  const std::string head = "G21 G90\nT1 M6\nS1000 M3\n";
  for (const char* body :
       {"G0 X0 Y0 Z5\nG1 Z-3 F100\nG0 Z20\n", "G0 X10 Y10 Z5\nG1 Z-1 F100\nX13 Y12\nG0 Z20\n",
        "G0 X1 Y1 Z5\nG1 Z-6 F100\nX2.5\nY2\nX1\nY1\nG0 Z20\n"})
    EXPECT_TRUE(told(plate(), head + body + "M30\n", FindingKind::kProgramUnit).empty()) << body;
}

// What only a reading tells.

TEST(ReadProgram, ToolsThatTheJobLacksAreErrors) {
  const MemoryProgramSource memory("part.nc", "T7 M6\nS500 M3\nG0 X10\nG1 Z-1 F100\nM30\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  Job job = plate();
  Result<ReadProgram> read = readProgram(job, 0, nullptr, source, 20, progress);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->setup.interpreted.path.diagnostics.errorCount(), 1);
  job.tools.clear();
  read = readProgram(job, 0, nullptr, source, 20, progress);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->setup.interpreted.path.diagnostics.errorCount(), 0) << "no tools are known";
}

}  // namespace
}  // namespace proveout
