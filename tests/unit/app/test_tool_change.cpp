// Start and tool changes with tools of real lengths: right programs are quiet, wrong ones are caught.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/session/programs/clearance.h"
#include "app/session/programs/interpretation.h"
#include "app/session/run/process.h"
#include "app/session/session.h"

namespace proveout {
namespace {

Tool endMill(int number, double length) {
  Tool tool;
  tool.number = number;
  tool.diameter = 12;
  tool.flute_length = 30;
  tool.overall_length = tool.gauge_length = length;
  tool.holder = {{0, 25}, {40, 25}};
  return tool;
}

/// A block of 100 x 80 x 20 and three tools, their lengths in the rows of their numbers.
Job longToolsJob() {
  Job job;
  job.name = "long";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -20}, {100, 80, 0}};
  job.tools = {endMill(1, 150), endMill(2, 60), endMill(3, 210)};
  for (const Tool& tool : job.tools) {
    job.settings.length_offsets[tool.number] = {tool.gauge_length, 0.0};
    job.settings.radius_offsets[tool.number] = {6.0, 0.0};
  }
  job.simulation.resolution_mm = 1.0;
  return job;
}

Result<RunResult> run(const Job& job, const std::string& program) {
  const MemoryProgramSource memory("long.nc", program);
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  return runRecorded(job, {&source}, progress);
}

std::string toldBy(const Job& job, const std::string& program) {
  const Result<RunResult> result = run(job, program);
  if (!result.ok()) return "refused: " + result.error().message;
  std::string told;
  for (const Finding& finding : result->findings) {
    told += findingKindName(finding.kind);
    told += ": " + finding.message + "\n";
  }
  return told;
}

std::vector<Motion> motionsOf(const Job& job, const std::string& program) {
  const Result<RunResult> result = run(job, program);
  EXPECT_TRUE(result.ok() && !result->alarm);
  return result.ok() ? result->setups[0].interpreted.path.motions : std::vector<Motion>();
}

constexpr const char* kHead = "G17 G21 G40 G49 G80 G90 G54\n";

/// A slot 3 deep with tool `number`, at y, begun with G0 X Y above the tool change's place and G43 behind it.
std::string slot(int number, double y) {
  return fmt::format(
      "T{0} M6\nS4000 M3\nG0 X50 Y-20\nG43 H{0} Z50\nG0 X-20 Y{1}\nZ-3\nG1 X120 F800\nG0 Z50\n", number, y);
}

TEST(ToolChange, RightProgramsAreQuietInEveryOrderOfTheTools) {
  std::vector<int> order = {1, 2, 3};
  do {
    const std::string program =
        kHead + slot(order[0], 15) + slot(order[1], 40) + slot(order[2], 65) + "M30\n";
    EXPECT_EQ(toldBy(longToolsJob(), program), "") << program;
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ToolChange, ALongToolBehindAShortOneWithoutARetractTouchesNothing) {
  // The program leaves the short tool in its slot, which is told, and moves in X and Y before G43.
  const std::string told =
      toldBy(longToolsJob(), std::string(kHead) +
                                 "T2 M6\nS4000 M3\nG0 X-20 Y40\nG43 H2 Z-3\nG1 X50 F800\nT3 M6\n"
                                 "S4000 M3\nG0 X20 Y-20\nG43 H3 Z50\nG0 Z-3\nG1 Y100\nG0 Z50\nM30\n");
  EXPECT_EQ(told.find("contact"), std::string::npos) << told;
  EXPECT_EQ(told.find("tool_change: tool change called 3 mm below"), 0u) << told;
}

TEST(ToolChange, TheEndsOfProgramsAreQuiet) {
  Job job = longToolsJob();
  job.start = Vec3(0, 0, 50);
  for (const char* end :
       {"G91 G28 Z0\nG28 X0 Y0\nM30\n", "G49 G28 Z0\nM30\n", "G28 Z0\nT2 M6\nG0 X0 Y0\nM30\n"})
    EXPECT_EQ(toldBy(job, kHead + slot(3, 40) + end), "") << end;
}

TEST(ToolChange, ForgottenLengthsAreCaught) {
  const Result<RunResult> result =
      run(longToolsJob(), std::string(kHead) +
                              "N10 T1 M6\nN20 S4000 M3\nN30 G0 X50 Y40\nN40 Z50\n"
                              "N50 Z-3\nN60 G1 Y100 F800\nN70 G0 Z50\nM30\n");
  ASSERT_TRUE(result.ok());
  ASSERT_FALSE(result->findings.empty());
  EXPECT_EQ(result->findings[0].kind, FindingKind::kRapidContact);
  EXPECT_EQ(result->findings[0].source->block, 40);
}

TEST(ToolChange, TheWrongRowIsCaught) {
  // 90 mm too short: H2 with tool 1, so that the tip is at -40 instead of 50.
  const Result<RunResult> result =
      run(longToolsJob(), std::string(kHead) + "T1 M6\nS4000 M3\nG0 X50 Y40\nN40 G43 H2 Z50\nG0 Z60\nM30\n");
  ASSERT_TRUE(result.ok());
  ASSERT_FALSE(result->findings.empty());
  EXPECT_EQ(result->findings[0].kind, FindingKind::kRapidContact);
  EXPECT_EQ(result->findings[0].source->block, 40);
}

TEST(ToolChange, ARapidIntoThePartIsCaught) {
  const Result<RunResult> result = run(
      longToolsJob(), std::string(kHead) + "T3 M6\nS4000 M3\nG0 X50 Y40\nG43 H3 Z50\nN50 G0 Z-3\nZ50\nM30\n");
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result->findings.size(), 1u);
  EXPECT_EQ(result->findings[0].kind, FindingKind::kRapidContact);
  EXPECT_EQ(result->findings[0].source->block, 50);
  EXPECT_NEAR(*result->findings[0].depth_mm, 3.0, 1e-3);
}

TEST(ToolChange, TheMachineGoesUpAndOnlyUp) {
  // Above a block whose top is at 0: 100 mm, and the longest tool.
  const std::string program = std::string(kHead) + "T2 M6\nG43 H2 G0 X1 Y2 Z5\nT3 M6\nG0 Z400\nT1 M6\nM30\n";
  const std::vector<Motion> motions = motionsOf(longToolsJob(), program);
  ASSERT_EQ(motions.size(), 3u);  // the last change is below where the machine stands
  EXPECT_EQ(motions[1].kind, MotionKind::kRapid);
  EXPECT_EQ(motions[1].source.line, 4u);
  EXPECT_EQ(motions[1].tool, 2);
  EXPECT_EQ(motions[1].to, Vec3(1, 2, 100 + 210 - 60));
  EXPECT_EQ(motions[2].from, Vec3(1, 2, 100));  // tool 3 at the same place of the machine
}

TEST(ToolChange, TheJobSaysWhereTheMachineGoes) {
  Job job = longToolsJob();
  job.settings.work_offsets[0] = {10, 20, -30};
  job.settings.tool_change.x = 300;
  job.settings.tool_change.y = -40;
  job.settings.tool_change.z = 500;
  const std::vector<Motion> motions =
      motionsOf(job, std::string(kHead) + "T1 M6\nG43 H1 G0 X1 Y2 Z5\nT2 M6\nG91 G0 X5\nM30\n");
  ASSERT_EQ(motions.size(), 6u);
  EXPECT_EQ(motions[3].to, Vec3(1, 2, 500 + 30 - 150));
  EXPECT_EQ(motions[4].to, Vec3(290, -60, 500 + 30 - 150));
  EXPECT_EQ(motions[5].from, Vec3(290, -60, 500 + 30 - 60));
  EXPECT_EQ(motions[5].to, Vec3(295, -60, 500 + 30 - 60));
}

TEST(ToolChange, CompensationStartsAnewBehindIt) {
  Job job = longToolsJob();
  const std::vector<Motion> motions =
      motionsOf(job, std::string(kHead) +
                         "T2 M6\nG43 H2 G0 X-20 Y40 Z5\nG1 G41 D2 X0 F500\nX50\nT2 M6\nX80\nG40 X100\nM30\n");
  // Straight up, and on beside the contour.
  const auto up = std::find_if(motions.begin() + 1, motions.end(),
                               [](const Motion& m) { return m.kind == MotionKind::kRapid; });
  ASSERT_NE(up, motions.end());
  EXPECT_EQ(up->from.head<2>(), up->to.head<2>());
  for (auto m = up; m != motions.end(); ++m) EXPECT_EQ(m->to.z(), 250.0);
  EXPECT_NEAR((up - 1)->from.y(), 46, 1e-9);
  EXPECT_NEAR((up + 1)->to.y(), 46, 1e-9);
}

TEST(ToolChange, ItKeepsToTheLimitsThatItDoesNotKnowOf) {
  Job job = longToolsJob();
  job.settings.limits[2] = AxisLimit{-100, 260};
  const std::string program = kHead + slot(1, 40) + slot(2, 60) + "M30\n";
  EXPECT_EQ(toldBy(job, program), "");
  job.settings.limits[2].reset();
  job.settings.parameters["N1002.3"] = 255;  // the control's own end of the stroke
  EXPECT_EQ(toldBy(job, program), "");
  job.settings.tool_change.z = 300;  // what the job names counts, and is beyond
  EXPECT_NE(toldBy(job, program).find("overtravel"), std::string::npos);
}

TEST(ToolChange, ItsTimeIsTheEventsAndThatOfTheWay) {
  Job job = longToolsJob();
  job.settings.tool_change_s = 7.0;
  job.settings.rapid_mm_min = Vec3::Constant(6000);
  const std::string program = std::string(kHead) + "T2 M6\nG43 H2 G0 X1 Y2 Z5\nT1 M6\nM30\n";
  const Result<RunResult> result = run(job, program);
  ASSERT_TRUE(result.ok());
  const Toolpath& path = result->setups[0].interpreted.path;
  ASSERT_EQ(path.motions.size(), 2u);
  EXPECT_NEAR(path.motions[1].time_s, (100 + 210 - 60 - 5) / 100.0, 1e-9);
  for (const auto& at : path.events) {
    EXPECT_TRUE(at.event.as<event::ToolChange>() == nullptr || at.event.time_s == 7.0);
  }
}

TEST(ToolChange, WhatIsInTheSpindleAtPowerOnHasItsLength) {
  Job job = longToolsJob();
  job.tools.resize(1);
  const Result<RunResult> result =
      run(job, std::string(kHead) + "S4000 M3\nG0 X-20 Y40\nG43 H1 Z-3\nG1 X120 F800\nG0 Z50\nM30\n");
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->findings.empty());
  EXPECT_NEAR(result->setups[0].initial_mm3 - result->surface().volume_mm3, 100 * 12 * 3, 1.0);
}

TEST(ToolChange, AStartThatTheJobGivesStays) {
  Job job = longToolsJob();
  job.start = Vec3(-50, -50, 30);
  const std::vector<Motion> motions = motionsOf(job, std::string(kHead) + "G0 X-40\nT3 M6\nM30\n");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].from, Vec3(-50, -50, 30));
}

TEST(ToolChange, ToolsWithoutLengthsAreChangedAboveTheBlank) {
  Job job = longToolsJob();
  for (Tool& tool : job.tools) tool.gauge_length = 0.0;
  job.settings.length_offsets.clear();
  const std::vector<Motion> motions =
      motionsOf(job, std::string(kHead) + "T1 M6\nG0 X-20 Y40 Z-3\nG1 X50 F800\nT2 M6\nG0 X60\nM30\n");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[2].to, Vec3(50, 40, 100));
  EXPECT_EQ(motions[3].to, Vec3(60, 40, 100));
}

TEST(ToolChange, APlaceInTheBlankIsRefused) {
  Job job = longToolsJob();
  job.settings.tool_change.x = 50;
  job.settings.tool_change.y = 84;
  job.settings.tool_change.z = 205;
  const std::string program = std::string(kHead) + "T1 M6\nM30\n";
  const Result<RunResult> inside = run(job, program);
  ASSERT_FALSE(inside.ok());
  EXPECT_EQ(inside.error().kind, ErrorKind::kInput);
  EXPECT_NE(inside.error().message.find("tool 3"), std::string::npos) << inside.error().message;
  job.settings.tool_change.y = 86.5;  // beside it by more than the radius
  EXPECT_TRUE(run(job, program).ok());
  job.settings.tool_change.y = 84;
  job.settings.tool_change.z = 210;
  EXPECT_TRUE(run(job, program).ok());
}

TEST(ToolChange, AHeightThatIsTooLowIsTold) {
  Job job = longToolsJob();
  job.settings.tool_change.z = 205;
  const Result<RunResult> low = run(job, std::string(kHead) + "T1 M6\nM30\n");
  ASSERT_TRUE(low.ok());
  const auto& told = low->setups[0].interpreted.path.diagnostics.all();
  const auto about = [](const Diagnostic& d) { return d.code == "tool-change"; };
  EXPECT_EQ(std::count_if(told.begin(), told.end(), about), 1);
  job.settings.tool_change.z = 215;
  const Result<RunResult> high = run(job, std::string(kHead) + "T1 M6\nM30\n");
  ASSERT_TRUE(high.ok());
  const auto& quiet = high->setups[0].interpreted.path.diagnostics.all();
  EXPECT_EQ(std::count_if(quiet.begin(), quiet.end(), about), 0);
}

TEST(ToolChange, Wl4MillsDoTheSame) {
  Job job = longToolsJob();
  job.control = "wl4-mill";
  std::string program = "%LONG\nG54 G17 G90 G94\n";
  for (const int tool : {2, 3, 1}) {
    program += fmt::format("T{0} M6\nS4000 M3\nG0 X-20 Y{1}\nG43 H{0} Z50\nZ-3\nG1 X120 F800\nX110\n", tool,
                           15 + 20 * tool);
  }
  const std::string left_low = toldBy(job, program + "G0 Z50\nM30\n");
  EXPECT_EQ(left_low.find("contact"), std::string::npos) << left_low;
  const std::string forgotten =
      toldBy(job, "%LONG\nG54 G17 G90 G94\nT1 M6\nS4000 M3\nG0 X50 Y40\nZ50\nM30\n");
  EXPECT_NE(forgotten.find("rapid_contact"), std::string::npos) << forgotten;
  // What stands in the block of M6 goes from the place of the tool change: by steps, too.
  const std::vector<Motion> motions =
      motionsOf(job, "%LONG\nG54 G17 G90 G94\nT2 M6\nG43 H2 G0 X1 Y2 Z5\nT1 M6 X9\nG91 Z-10\nM30\n");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1].to, Vec3(1, 2, 250));
  EXPECT_EQ(motions[2].to, Vec3(9, 2, 160));
  EXPECT_EQ(motions[3].to, Vec3(9, 2, 150));
}

/// A bar of 40 x 60 whose face is at Z0, an insert and a drill that stands out by 120.
Job latheJob() {
  Job job;
  job.name = "lathe";
  job.control = "wl4-lathe";
  job.stock = CylinderShape{2, {0, 0, -60}, 20.0, 0.0, 60.0};
  Tool insert;
  insert.number = 1;
  insert.type = ToolType::kInsert;
  Insert shape;
  shape.orientation = 3;
  shape.nose_radius = 0.4;
  shape.insert_angle_deg = 80;
  shape.lead_angle_deg = 95;
  shape.edge_length = 12;
  insert.insert = shape;
  Tool drill;
  drill.number = 2;
  drill.type = ToolType::kDrill;
  drill.diameter = 10;
  drill.flute_length = 60;
  drill.overall_length = drill.gauge_length = 120;
  job.tools = {insert, drill};
  job.settings.length_offsets[2] = {120, 0.0};
  return job;
}

TEST(ToolChange, ADrillOnALatheIsClearOfTheBar) {
  const std::string turn =
      "%BAR\nG54 G18 G90 G94\nT1 M6\nS1000 M3\nG0 X36 Z2\nG1 Z-20 F200\nX42\nG0 X60 Z5\n";
  const std::string drill = "T2 M6\nG17 G43 H2\nG0 X0 Z5\nG1 Z-15 F100\nG0 Z5\n";
  EXPECT_EQ(toldBy(latheJob(), turn + drill + "M30\n"), "");
  EXPECT_EQ(toldBy(latheJob(), "%BAR\nG54 G18 G90 G94\nS1000 M3\n" + drill + "M30\n"), "");
  const std::string forgotten =
      toldBy(latheJob(), "%BAR\nG54 G18 G90 G94\nS1000 M3\nT2 M6\nG0 X0\nZ5\nG1 Z-15 F100\nG0 Z5\nM30\n");
  EXPECT_NE(forgotten.find("rapid_contact"), std::string::npos) << forgotten;
}

TEST(ToolChange, ATurretOfInsertsTurnsWhereTheProgramSays) {
  Job job = latheJob();
  job.tools.resize(1);
  const std::string program = "%BAR\nG54 G18 G90 G94\nS1000 M3\nG0 X60 Z5\nT1 M6\nX50\nM30\n";
  EXPECT_EQ(motionsOf(job, program).size(), 2u);
  job.settings.tool_change.x = 80;
  job.settings.tool_change.z = 100;
  const std::vector<Motion> motions = motionsOf(job, program);
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1].to, Vec3(30, 0, 100));
  EXPECT_EQ(motions[2].to, Vec3(80, 0, 100));
  job.settings.tool_change.y = 3;
  EXPECT_FALSE(run(job, program).ok());
}

TEST(ToolChange, ABarThatBoresBackwardsStartsClear) {
  Job job = latheJob();
  job.tools.resize(1);
  job.tools[0].insert->orientation = 1;
  job.tools[0].insert->holder = {{-5, 0}, {-25, 0}, {-25, -80}, {-5, -80}};
  EXPECT_NEAR(toolReach(job.tools), 80, 1e-9);
  const Box3 blank{{-20, -20, -60}, {20, 20, 0}};
  EXPECT_NEAR(controlSettings(job, blank).start.z(), 90, 1e-9);
  job.tools[0].insert->orientation = 3;
  job.tools[0].insert->holder.clear();
  EXPECT_EQ(controlSettings(job, blank).start, kTurningProcess.start(blank));
}

TEST(ToolChange, ChannelsHaveItsHeightInTheirOwnFrames) {
  ControlSettings control, channel;
  control.work_offsets[0] = {0, 0, -100};
  channel.work_offsets[0] = {0, 0, -250};
  control.tool_change.z = 60;
  control.tool_change.by_default = true;
  EXPECT_EQ(placeInChannel(control, channel).z, -90);
  control.tool_change.by_default = false;
  EXPECT_EQ(placeInChannel(control, channel).z, 60);
}

}  // namespace
}  // namespace proveout
