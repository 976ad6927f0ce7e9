// The FlexNC control besides its cycles: functions, modes, speeds (digest flexnc, 3 and 4).
#include <gtest/gtest.h>

#include <cmath>

#include "core/nc/registry/coverage.h"
#include "flexnc_path.h"

namespace proveout::test {
namespace {

/// The row of the code table, by its first id.
CoverageRow rowServing(const std::string& id) {
  const std::vector<CoverageRow> table = coverageTable(ControlId::kFlexNc).value();
  for (const CoverageRow& row : table) {
    if ((" " + row.ids + " ").find(" " + id + " ") != std::string::npos) return row;
  }
  return {};
}

// fnc-0-decimal
TEST(Flexnc, RefusesCommas) {
  const FlexncPath run(kStart + "G00X10,5\nM02\n");
  EXPECT_EQ(run.error(), "fnc-num");
  EXPECT_EQ(run.first(Severity::kError).where.line, 4);
  EXPECT_EQ(FlexncPath(kStart + "G00X10.Z.5\nM02\n").end(0), Vec2(10.0, 0.5));
}

// fnc-1.3-G17 fnc-1.3-G18 fnc-1.3-G19
TEST(Flexnc, TakesOtherPlanesWithoutArcsAndCompensation) {
  const FlexncPath lines(kStart + "G17G00X10Z0\nG19G01Z-5\nM02\n");
  EXPECT_TRUE(lines.summary.ok());
  EXPECT_TRUE(lines.tells("fnc-plane", Severity::kNote));
  EXPECT_EQ(FlexncPath(kStart + "G00X10Z0\nG17G02X12Z-2I2\nM02\n").error(), "fnc-arc");
  EXPECT_EQ(FlexncPath(kStart + "G00X30Z0\nG03X20Z-10K99999\nM02\n").error(), "fnc-arc") << "100 m";
  EXPECT_EQ(FlexncPath(kStart + "G19G00X10Z0\nG42G01X12\nM02\n").error(), "fnc-arc");
  EXPECT_TRUE(FlexncPath(kStart + "G00X10Z0\nG17\nG18G02X12Z-2I2\nM02\n").summary.ok());
}

// fnc-1.4-G04
TEST(Flexnc, DwellsWithoutMoving) {
  const FlexncPath run(kStart + "G01X10Z0\nG04X1.5\nG01Z-5G04X2\nM02\n");
  EXPECT_EQ(run.count(), 2u);
  const auto dwells = run.events<event::Dwell>();
  ASSERT_EQ(dwells.size(), 2u);
  EXPECT_EQ(dwells[0].seconds, 1.5);
  EXPECT_EQ(dwells[1].seconds, 2.0);
  for (const char* bad : {"G04\n", "G04X0\n", "G04X100000\n", "G04Z1\n"})
    EXPECT_EQ(FlexncPath(kStart + bad + "M02\n").error(), "fnc-dwell") << bad;
}

// fnc-1.5b-feed
TEST(Flexnc, RunsTheNoseCentreAtTheFeed) {
  ControlSettings settings;
  settings.parameters = {{"RT.1", 2.0}};
  const FlexncPath run(kStart + "G00X20Z10\nG42G01Z0\nG03X30Z-10I0K-10\nG01Z-20\nG40X50\nM02\n", settings);
  ASSERT_TRUE(run.summary.ok());
  for (const Motion& motion : run.path.motions) {
    if (motion.kind != MotionKind::kFeed) continue;
    EXPECT_NEAR(motion.feed, 100.0, 1e-9);
    EXPECT_NEAR(motion.time_s, 60.0 * run.path.length(motion) / 100.0, 1e-9);
  }
}

// fnc-1.6-G86 fnc-1.6-G87
TEST(Flexnc, KeepsTheCuttingSpeed) {
  const FlexncPath run("T1M06D1\nG86S90\nM03\nG98F100\nG00X30Z0\nG01Z-5\nG01X20\nG87\nG01Z-8\nM02\n");
  ASSERT_TRUE(run.summary.ok());
  EXPECT_NEAR(run.motion(1).spindle, 1000.0 * 90.0 / (kPi * 60.0), 1e-6);
  EXPECT_GT(run.motion(2).spindle, run.motion(1).spindle);
  EXPECT_EQ(FlexncPath("T1M06D1\nG86\nM02\n").error(), "fnc-spindle");
  ControlSettings limited;
  limited.parameters = {{"MAX_SPEED", 400.0}};
  const FlexncPath slow("T1M06D1\nG86S90\nM03\nG98F100\nG00X30Z0\nG01Z-5\nM02\n", limited);
  EXPECT_NEAR(slow.motion(1).spindle, 400.0, 1e-6);
  EXPECT_TRUE(FlexncPath("T1M06D1\nG86S90\nM03\nG98F100\nG00X30Z0\nG01X0\nM02\n").warns("fnc-surface-speed"));
}

// fnc-1.8-G98 fnc-1.8-G99 fnc-2-F fnc-2-S
TEST(Flexnc, CountsTheFeedInMinutesOrTurns) {
  const FlexncPath run("T1M06D1\nS300M03\nG00X10Z0\nG98F100G01Z-5\nG99F0.1G01Z-10\nS600\nZ-15\nM02\n");
  ASSERT_TRUE(run.summary.ok());
  EXPECT_NEAR(run.motion(1).feed, 100.0, 1e-9);
  EXPECT_NEAR(run.motion(2).feed, 30.0, 1e-9);
  EXPECT_NEAR(run.motion(3).feed, 60.0, 1e-9);
  EXPECT_TRUE(FlexncPath(kStart + "G00X10Z0\nG99G01Z-5\nM02\n").warns("fnc-feed-unit"));
  EXPECT_EQ(FlexncPath("S300M03\nG00X10Z0\nG01Z-5\nM02\n").error(), "fnc-feed");
  EXPECT_EQ(FlexncPath(kStart + "F0\nM02\n").error(), "fnc-feed");
}

// fnc-1.x-persist
TEST(Flexnc, BeginsEachRunWithThePowerOnModes) {
  const std::string text = "S300M03\nF100G00X10Z0\nG01Z-5\nG91G99F0.1G01Z-1\nM02\n";
  const FlexncPath first(text), second(text);
  EXPECT_EQ(first.ends(), second.ends());
  EXPECT_NEAR(second.motion(1).feed, 100.0, 1e-9);  // G98
  EXPECT_EQ(second.end(2), Vec2(10.0, -6.0));
}

// fnc-2-M01 fnc-2-M02 fnc-2-M03 fnc-2-M04 fnc-2-M05 fnc-2-M08 fnc-2-M09 fnc-2-M19
TEST(Flexnc, SendsTheFunctionsOfTheMachine) {
  const FlexncPath run("T3M06D3\nS300M03\nM08\nM01\nM05\nS200M04\nM09\nM19\nM02\n");
  ASSERT_TRUE(run.summary.ok());
  std::string spindle;
  for (const event::Spindle& turn : run.events<event::Spindle>()) spindle += turn.direction + " ";
  EXPECT_EQ(spindle, "cw stop ccw oriented ");
  const auto coolant = run.events<event::Coolant>();
  ASSERT_EQ(coolant.size(), 2u);
  EXPECT_TRUE(coolant[0].on);
  EXPECT_FALSE(coolant[1].on);
  EXPECT_EQ(run.events<event::OptionalStop>().size(), 1u);
  EXPECT_EQ(run.events<event::ToolChange>().at(0).tool, 3);
  EXPECT_EQ(run.events<event::End>().at(0).code, "M02");
}

TEST(Flexnc, StopsTheSpindleAtTheEnd) {
  const auto turns = FlexncPath("S300M03\nM02\n").events<event::Spindle>();
  ASSERT_EQ(turns.size(), 2u);
  EXPECT_EQ(turns[1].direction, "stop");
}

// fnc-3.6-N fnc-3.6-G80 fnc-3.6-Yaxis fnc-4.2-comment fnc-4.2-G92
TEST(Flexnc, TakesLabelsAndCommentsAndRefusesWhatIsNotDescribed) {
  const FlexncPath run(kStart + "// N5 G92 Y1 is a comment\nN5\nN6 G00X10Z0 // here too, G92\nG80\nM02\n");
  EXPECT_TRUE(run.summary.ok());
  EXPECT_EQ(run.count(), 1u);
  EXPECT_EQ(run.motion(0).source.block, 6);
  EXPECT_TRUE(run.tells("fnc-g80", Severity::kNote));
  EXPECT_EQ(FlexncPath(kStart + "G00X0Y0\nM02\n").error(), "fnc-unknown");
  EXPECT_EQ(FlexncPath(kStart + "G92X0\nM02\n").error(), "fnc-unknown");
}

// fnc-4.2-tmpl fnc-4.5-tmps: containers are refused by the tool that reads their text layer; what reaches the
// control of one is refused here. fnc-4.2-need: no parameter may stay open.
TEST(Flexnc, RefusesTemplatesThatNobodyFilled) {
  const FlexncPath open(kStart + "G00X([C]/2)Z[B]\nM02\n");
  EXPECT_TRUE(open.error() == "fnc-num" || open.error() == "fnc-syntax");
  EXPECT_EQ(FlexncPath(kStart + "G00X[C]\nM02\n").error(), "fnc-num");
  EXPECT_EQ(FlexncPath(std::string("TMPL\x01\x02\x00\x03", 8) + "\n").summary.errors, 1);
  EXPECT_EQ(rowServing("fnc-4.2-tmpl").status, "refused");
  EXPECT_EQ(rowServing("fnc-4.5-tmps").status, "refused");
}

// fnc-4.2-add fnc-4.2-help fnc-4.2-ui fnc-4.3-quick fnc-4.5-ui: windows of the shell, which leave no trace in
// a program.
TEST(Flexnc, NotesTheShell) {
  for (const char* id : {"fnc-4.2-add", "fnc-4.2-help", "fnc-4.2-ui", "fnc-4.3-quick", "fnc-4.5-ui"})
    EXPECT_EQ(rowServing(id).status, "noted") << id;
}

// fnc-3.5-none
TEST(Flexnc, HasNoHoleFormOfThreeTemplates) {
  for (const char* call : {"G3.1X60A50R20Z10P1.5B2C-2V0", "G8.1X100A0Z0R25U25P2C-3B2V0",
                           "G13.5X80A8R10G45Z35P1C-2B3V0", "G13.5X80A8R10G45P0C-2K1"})
    EXPECT_EQ(FlexncPath(kStart + call + "\nM02\n").error(), "fnc-c-sign") << call;
}

TEST(Flexnc, TurnsACornerInRapidWhereTheRatesAreKnown) {
  ControlSettings settings;
  settings.rapid_by_default = false;
  settings.rapid_mm_min = Vec3(3000.0, 3000.0, 6000.0);
  const FlexncPath run(kStart + "G00X80Z-30\nM02\n", settings);
  ASSERT_EQ(run.count(), 2u);
  EXPECT_NEAR((run.end(0) - Vec2(80.0, 10.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(run.summary.rapid_s, 60.0 * 80.0 / 6000.0, 1e-9);
  EXPECT_TRUE(FlexncPath(kStart + "G00X80Z-30\nM02\n").tells("fnc-rapid", Severity::kNote));
}

TEST(Flexnc, CarriesTheCorrectorThatIsNotTheTools) {
  ControlSettings settings;
  settings.parameters = {{"RT.7", 0.8}, {"TIP.7", 3.0}, {"DXW.7", 0.5}};
  const FlexncPath run("T2M06D7\nS300M03\nG98F100\nG00X20Z5\nG42G01Z0\nZ-10\nG40X40\nM02\n", settings);
  ASSERT_TRUE(run.summary.ok());
  const std::int32_t set = run.path.motions.back().source.origins;
  const OriginTables& tables = run.path.origins;
  const DataInForce& data = tables.data[tables.modal[tables.sets[static_cast<std::size_t>(set)].modal].data];
  EXPECT_EQ(data.tool, 2);
  EXPECT_EQ(data.nose_tool, 7);
  EXPECT_EQ(data.nose_radius, 0.8);
  EXPECT_EQ(data.tip, 3);
  EXPECT_EQ(data.tool_offset, Vec3(0.5, 0.0, 0.0));
  // Nose centre 0.8 outside of the contour, the touch-off point on it.
  EXPECT_NEAR(run.end(run.count() - 2).x(), 20.5, 1e-9);
}

TEST(Flexnc, ChangesTheCorrectorUnderCompensationAlongOneMotion) {
  ControlSettings settings;
  settings.parameters = {{"RT.1", 1.0}, {"RT.2", 3.0}};
  const FlexncPath run(kStart + "G00X20Z10\nG42G01Z0\nZ-10\nD2\nZ-20\nZ-30\nM02\n", settings);
  ASSERT_TRUE(run.summary.ok());
  const std::vector<Vec2> ends = run.ends();
  EXPECT_NEAR((ends[1] - Vec2(21.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((ends[2] - Vec2(21.0, -10.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((ends[3] - Vec2(23.0, -20.0)).norm(), 0.0, 1e-9);
}

TEST(Flexnc, SwitchesCompensationInAnArcBySpirals) {
  ControlSettings settings;
  settings.parameters = {{"RT.1", 1.0}};
  const FlexncPath run(kStart + "G00X10Z0\nG42G02X20Z-10K-10\nG01Z-20\nG40G03X30Z-30I10\nG00X50\nM02\n",
                       settings);
  ASSERT_TRUE(run.summary.ok()) << run.first(Severity::kError).message;
  const std::vector<Vec2> ends = run.ends();
  EXPECT_NEAR((ends[1] - Vec2(21.0, -10.0)).norm(), 0.0, 1e-9);
  const ArcGeometry& in = run.path.arcs.at(static_cast<std::size_t>(run.motion(1).arc));
  EXPECT_NEAR(in.center.x(), 10.0, 1e-9);
  EXPECT_NEAR(in.center.z(), -10.0, 1e-9);
  EXPECT_NEAR((ends[3] - Vec2(30.0, -30.0)).norm(), 0.0, 1e-9);
  EXPECT_GE(run.motion(3).arc, 0);
}

TEST(Flexnc, WarnsOfCornersThatTheNoseDoesNotFit) {
  ControlSettings settings;
  settings.parameters = {{"RT.1", 2.0}};
  const FlexncPath small(kStart + "G00X20Z10\nG42G01Z0\nZ-10\nG03X21Z-11I1\nG01X40\nM02\n", settings);
  EXPECT_TRUE(small.summary.ok());
  EXPECT_TRUE(small.warns("fnc-comp-radius"));
  const FlexncPath brief(kStart + "G00X20Z10\nG42G01Z0\nZ-10\nX21\nZ-11\nX40\nM02\n", settings);
  EXPECT_TRUE(brief.warns("fnc-comp-short"));
  // A convex radius behind a square corner of a bore: the nose leaves the corner behind the end of the arc.
  ControlSettings bored;
  bored.parameters = {{"RT.1", 0.6}, {"TIP.1", 2.0}};
  const std::string blocks =
      kStart + "G81.2X105Z5\nG12.5A103.24C-1.4G83.7K1P0R1.1X95.6Z21.3\nG81X95Z100\nM02\n";
  EXPECT_TRUE(FlexncPath(blocks, bored).warns("fnc-comp-short"));
  bored.parameters["RT.1"] = 0.1;
  EXPECT_FALSE(FlexncPath(blocks, bored).warns("fnc-comp-short"));
}

}  // namespace
}  // namespace proveout::test
