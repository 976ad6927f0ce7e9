// Five axes on the manual's machines: length along the tool, turns of space, tilted planes, dynamic zero, the
// tool's direction, the control's own data of the machine. Positions are those that the manual prints, and
// those that its equations give on the test machines.
//
// Rows: nct-3-G43.1 nct-3-G53.1 nct-3-G54.2 nct-3-G68.1 nct-3-G68.2 nct-3-G69.1 nct-25.1-N3200
// nct-25.1-N3201 nct-25.1-N3204 nct-25.1-N3205 nct-25.1-N3208 nct-25.1-N3209 nct-25.1-N3212-RD
// nct-25.1-N3213 nct-25.1-N3216 nct-25.2-G43.1 nct-25.2-G49 nct-25.2-FOS nct-25.3-G68.1 nct-25.3-G69.1
// nct-25.4-G54.2 nct-25.4-FOS nct-25.4-SUSP nct-25.4-VAR nct-25.4.1-G10L21 nct-25.6-G68.2 nct-25.6-G69.1
// nct-25.7-G68.2P1 nct-25.8-G68.2P2 nct-25.8-G68.2P2Q0 nct-25.9-G68.2P3 nct-25.10-G68.2P4 nct-25.11-G53.1
// nct-25.1-N3206 nct-25.1-N3210 nct-25.1-N3219 nct-25.1-N3222 nct-25.13-G92 nct-25.13-G51 nct-25.13-G51.1
// nct-25-UNREACH nct-25.11-FOS nct-25.11-SEL nct-25.13-G52 nct-25.13-G68 nct-25.19-PCS nct-25.19-TLC
// nct-25.19-5041
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/machine/machine_chain.h"
#include "core/nc/kinematics/five_axis_model.h"
#include "core/nc/registry/interpreter.h"
#include "tests/support/five_axis_runs.h"
#include "tests/support/test_machines.h"

namespace proveout {
namespace {

using namespace test;  // NOLINT

TEST(LengthAlongTool, TheTipHoldsItsPlaceAtTheEnds) {
  const Outcome out = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 Z100 H1\nA45\nG49 Z300",
                            settingsOf(test::machineCA(), Vec3::Zero()));
  expectTip(out, 2, {0, 0, 100});
  expectTip(out, 3, {0, 0, 100});
  const Vec3 axis = endOf(out, 3).axis;
  EXPECT_LT((axis - Vec3(0, -std::sqrt(0.5), std::sqrt(0.5))).norm(), 1e-12);
  // With G49 the numbers are those of the control point again: it has gone to Y-70.7107.
  expectTip(out, 4, {0, 0, 300 - 70.7107});
  // Between the ends the tip leaves its place: at A22.5 it is where the manual's equations say.
  bool seen = false;
  for (const Motion& m : out.path.motions) {
    if (m.source.line != 3 || m.axis < 0) continue;
    seen = seen || (out.path.pointAt(m, 0.5) - Vec3(0, 2.9130, 92.9674)).norm() < kPrinted;
  }
  EXPECT_TRUE(seen);
}

TEST(LengthAlongTool, UnprogrammedAxesKeepTheirProgrammedCoordinate) {
  const Outcome out = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 A30 C60 H1\nA45",
                            settingsOf(test::machineCA(), Vec3::Zero()));
  expectTip(out, 2, {0, 0, 100});
  expectTip(out, 3, {0, 0, 100});
  EXPECT_NEAR(rotaryAt(out, 3, "C"), 60.0, 1e-12);
}

TEST(LengthAlongTool, AloneItMovesNothing) {
  const Outcome out = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 H1\n#1=#5003\nX[#1+5]",
                            settingsOf(test::machineCA(), Vec3::Zero()));
  for (const Motion& m : out.path.motions) EXPECT_NE(m.source.line, 2u);
  expectTip(out, 4, {5, 0, 0});  // the tip is at Z100 - H1, and the programmed Z says so
}

TEST(LengthAlongTool, ByTransformationTheCoordinatesChange) {
  ControlSettings settings = settingsOf(test::machineCA(), Vec3::Zero());
  settings.parameters["N3212.FOS"] = 1.0;
  const Outcome first = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 Z100 H1\nA45", settings);
  expectTip(first, 3, {0, 70.7107, 129.2893});
  const Outcome second = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 A30 C60 H1", settings);
  expectTip(second, 2, {-43.3013, 25, 13.3975});
}

TEST(LengthAlongTool, AWrongLengthShowsInThePath) {
  ControlSettings settings = settingsOf(test::machineCA(), Vec3::Zero());
  settings.length_offsets[1] = {90.0, 0.0};  // the tool is 100 long
  const Outcome out = runOf("G54 G49 G0 G90 X0 Y0 Z100 A0 C0\nG43.1 Z100 H1\nA90", settings);
  expectTip(out, 2, {0, 0, 90});
  expectTip(out, 3, {0, 10, 100});
}

/// G43 with a head that leans: the first feed is told of, once; not with the tool along Z, not with G43.1,
/// not behind G53.1, not on tables.
TEST(LengthAlongTool, ALengthBesideTheToolIsTold) {
  const auto lineTold = [](const std::string& program, const MachineModel& machine) {
    const Outcome out = runOf("G54 G49 G0 G90 X0 Y0 Z100\n" + program, settingsOf(machine, Vec3::Zero()));
    EXPECT_EQ(out.error, "") << program;
    int line = 0;
    for (const Diagnostic& d : out.path.diagnostics.all()) {
      if (d.code != "nct-length-beside-tool") continue;
      EXPECT_EQ(line, 0) << program;
      line = d.where.line;
    }
    return line;
  };
  EXPECT_EQ(lineTold("B30 C0\nG43 Z50 H1\nG1 X5 F100\nX6", test::machineCB()), 4);
  EXPECT_EQ(lineTold("G43 Z50 H1\nG1 X5 F100\nX9 B10", test::headTable()), 4);
  EXPECT_EQ(lineTold("C30\nG43 Z50 H1\nG1 X5 F100", test::machineCB()), 0);
  EXPECT_EQ(lineTold("B30\nG43.1 Z50 H1\nG1 X5 F100", test::machineCB()), 0);
  EXPECT_EQ(lineTold("B30\nG43 Z50 H1\nX5", test::machineCB()), 0);  // in the air
  EXPECT_EQ(lineTold("G43 Z50 H1\nG68.2 I90 J30\nG53.1\nG1 X5 F100", test::machineCB()), 0);
  EXPECT_EQ(lineTold("A30\nG43 Z50 H1\nG1 X5 F100", test::trunnion('A')), 0);
}

/// A head that stands leaning does not bend an arc: it is one motion, wherever its plane lies.
TEST(LengthAlongTool, ArcsAreArcsWhileAHeadLeans) {
  const std::string lean = "G54 G0 X50 Y0 Z300 B40\nG43.1 X50 Y0 Z0 H1\nG3 X0 Y50 R50 F500";
  const std::string plane =
      "G54 G0 X0 Y0 Z300\nG43 H1\nG68.2 I0 J40 K0\nG53.1\nX50 Y0 Z0\nG3 X0 Y50 R50 F500";
  for (const MachineModel& machine : {test::machineCB(), test::headTable(), test::trunnion('A')}) {
    for (const auto& [text, line] : {std::pair(lean, 3u), std::pair(plane, 6u)}) {
      if (line == 3 && machine.axes[3].side == AxisSide::kPart) continue;  // no head
      const Outcome out = runOf(text, settingsOf(machine, kTableZero));
      EXPECT_EQ(out.error, "");
      const Motion* arc = motionOf(out, line);
      ASSERT_NE(arc, nullptr);
      ASSERT_EQ(arc->shape(), MotionShape::kArc) << line;
      const ArcGeometry& g = out.path.arcs[static_cast<std::size_t>(arc->arc)];
      EXPECT_NEAR((out.path.pointAt(*arc, 0.5) - g.center).norm(), 50.0, 1e-9);
      EXPECT_NEAR(g.normal.z(), line == 3 ? 1.0 : std::cos(degToRad(40.0)), 1e-9);
      EXPECT_NEAR(arc->time_s, 60.0 * 25.0 * kPi / 500.0, 1e-6);
    }
  }
}

/// The tip that a block behind `frame` at X Y Z gives.
Vec3 throughFrame(const std::string& frame, const Vec3& p) {
  const Outcome out = runOf(frame + fmt::format("\nG0 X{} Y{} Z{}", p.x(), p.y(), p.z()),
                            settingsOf(test::plainMachine(), Vec3::Zero()));
  EXPECT_EQ(out.error, "") << frame;
  return out.path.motions.empty() ? Vec3(Vec3::Constant(1e9)) : out.path.motions.back().to + Vec3(0, 0, 100);
}

void expectFrame(const std::string& frame, const Vec3& p, const Vec3& tip) {
  const Vec3 found = throughFrame(frame, p);
  EXPECT_LT((found - tip).norm(), kPrinted)
      << frame << ": " << found.transpose() << " for " << tip.transpose();
}

TEST(TiltedPlane, TurnsOfSpace) {
  expectFrame("G68.1 X10 Y20 Z30 I0 J0 K1 R30\nG68.1 X5 Y0 Z0 I0 J1 K0 R45", {1, 2, 3},
              {15.7796, 25.6463, 31.4142});
  expectFrame("G68.1 X10 Y20 Z30 I0 J1 K0 R45\nG68.1 X5 Y0 Z0 I0 J0 K1 R30", {1, 2, 3},
              {15.5621, 22.2321, 28.6805});
  expectFrame("G68.1 X10 Y20 Z30 I0 J0 K1 R30\nG69.1", {1, 2, 3}, {1, 2, 3});
}

TEST(TiltedPlane, OneFrameInFiveForms) {
  for (const char* frame :
       {"G68.2 X200 Y0 Z50 I90 J30 K0", "G68.2 P1 Q123 X200 Y0 Z50 I30 J0 K90",
        "G68.2 P2 Q1 X200 Y0 Z50\nG68.2 P2 Q2 X200 Y100 Z50\nG68.2 P2 Q3 X113.3974596 Y0 Z100",
        "G68.2 P3 Q1 X200 Y0 Z50 I0 J100 K0\nG68.2 P3 Q2 I50 J0 K86.6025404",
        "G68.2 P4 X200 Y0 Z50 I30 J0 K90"}) {
    expectFrame(frame, {10, 20, 30}, {197.6795, 10, 85.9808});
  }
}

TEST(TiltedPlane, OrdersOfRollPitchYaw) {
  const struct {
    const char* order;
    Vec3 p;
  } rows[] = {{"123", {20.9704, 6.0540, 30.3907}}, {"132", {21.1817, 4.0217, 30.5804}},
              {"213", {18.5019, 8.2737, 31.4519}}, {"231", {15.8859, 7.6283, 33.0068}},
              {"312", {18.5418, 3.5612, 32.3036}}, {"321", {16.2513, 5.5560, 33.2420}}};
  for (const auto& row : rows)
    expectFrame(fmt::format("G68.2 P1 Q{} I30 J20 K10", row.order), {10, 20, 30}, row.p);
}

TEST(TiltedPlane, PointsWithCorrection) {
  expectFrame(
      "G68.2 P2 Q1 X10 Y0 Z0\nG68.2 P2 Q2 X10 Y50 Z0\nG68.2 P2 Q3 X0 Y0 Z20\nG68.2 P2 Q0 X5 Y6 Z7 R30",
      {1, 2, 3}, {15.2628, 4.8660, 11.8351});
  expectFrame("G68.2 P3 Q1 I1 J0 K0\nG68.2 P3 Q2 I1 J0 K1", {1, 2, 3}, {1, 2, 3});
}

TEST(TiltedPlane, ANewOneReplacesTheOld) {
  expectFrame("G68.2 X1 Y2 Z3 I10 J20 K30\nG68.2 X200 Y0 Z50 I90 J30 K0", {10, 20, 30},
              {197.6795, 10, 85.9808});
}

TEST(TiltedPlane, ShiftsAndTurnsOfTheProgramComeFirst) {
  expectFrame("G68.2 X200 Y0 Z50 I90 J30 K0\nG52 X10 Y20 Z30", {0, 0, 0}, {197.6795, 10, 85.9808});
  expectFrame("G68.2 X200 Y0 Z50 I90 J30 K0\nG17 G68 X0 Y0 R90", {20, -10, 30}, {197.6795, 10, 85.9808});
}

/// By hand: each program point is turned into (10, 20, 30) of the plane. G92 makes the place where the tool
/// stands the one that it names; scaling is about its centre, 1 + 3 * (4 - 1) = 10; a mirror turns -4 about 3
/// into 10.
TEST(TiltedPlane, NewZeroScalingAndMirrorsComeFirst) {
  const std::string plane = "G68.2 X200 Y0 Z50 I90 J30 K0\n";
  const Vec3 tip(197.6795, 10, 85.9808);
  expectFrame(plane + "G0 X1 Y2 Z3\nG92 X0 Y0 Z0", {9, 18, 27}, tip);
  expectFrame(plane + "G0 X1 Y2 Z3\nG92 X5", {14, 20, 30}, tip);
  expectFrame(plane + "G51 X0 Y0 Z0 P2", {5, 10, 15}, tip);
  expectFrame(plane + "G51 X1 Y2 Z3 P3", {4, 8, 12}, tip);
  expectFrame(plane + "G51.1 X0", {-10, 20, 30}, tip);
  expectFrame(plane + "G51.1 X3 Z1", {-4, 20, -28}, tip);
  // The mirror is outermost (manual 16.4): (20, 10) turned by 90 degrees is (-10, 20).
  expectFrame(plane + "G51.1 X0\nG17 G68 X0 Y0 R90", {20, 10, 30}, tip);
}

TEST(TiltedPlane, ErrorsOfTheDefinition) {
  const struct {
    const char* program;
    const char* code;
  } rows[] = {{"G68.2 P1 I10 J20 K30", "nct-2039"},
              {"G68.2 P1 Q111 I10 J20 K30", "nct-2039"},
              {"G68.2 P2 Q4 X0 Y0 Z0", "nct-2039"},
              {"G68.2 P3 Q3 I0 J0 K1", "nct-2039"},
              {"G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q3 X0 Y0 Z1\nG0 X1", "nct-2064"},
              {"G68.2 P3 Q1 I0 J0 K1\nG0 X1", "nct-2064"},
              {"G68.2 P2 Q0 X1", "nct-2064"},
              {"G68.2 P2 Q1\nG68.2 P2 Q2 X1\nG68.2 P2 Q3 Y1\nG0 X5\nG68.2 P2 Q0 X1", "nct-2064"},
              {"G68.2 P2 Q1\nG68.2 P2 Q2 X1\nG68.2 P2 Q3 Y1\nG68.2 I10\nG68.2 P2 Q0 X1", "nct-2064"},
              {"G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X1 Y0 Z0\nG68.2 P2 Q3 X2 Y0 Z0", "nct-2088"},
              {"G68.2 P2 Q1 X0 Y0 Z0\nG68.2 P2 Q2 X0 Y0 Z0\nG68.2 P2 Q3 X2 Y0 Z0", "nct-2088"},
              {"G68.2 P3 Q1 I1 J0 K0\nG68.2 P3 Q2 I2 J0 K0", "nct-2088"},
              {"G68.2 P4 I90 J90", "nct-2088"},
              {"G68.2 P4 I90 J-90", "nct-2088"},
              {"G68.1 I1 J1 R30", "nct-tilt-axis"},
              {"G68.1 R30", "nct-2004"},
              {"G68.1 K1", "nct-2004"},
              {"G68.1 K1 R1\nG68.1 K1 R1\nG68.1 K1 R1", "nct-tilt"},
              {"G53.1", "nct-2019"},
              {"G68.2 I0 J30 K0\nG53.1 X5", "nct-2017"}};
  for (const auto& row : rows) {
    const Outcome out = runOf(row.program, settingsOf(test::machineCB(), Vec3::Zero()));
    const bool any_range = std::string_view(row.code) == "nct-tilt-axis";
    EXPECT_TRUE(out.error.starts_with(any_range ? "nct-2002" : row.code)) << row.program << ": " << out.error;
  }
}

TEST(DynamicZero, GoesWithTheTable) {
  const MachineModel ac = test::trunnion('A');
  const struct {
    double a, c;
    Vec3 zero;
    const char* table;
  } rows[] = {{0, 0, {450, 300, -420}, "X50 Y0 Z40"},
              {0, 90, {400, 250, -420}, "X50 Y0 Z40"},
              {30, 0, {450, 340, -430.7180}, "X50 Y0 Z40"},
              {30, 90, {400, 296.6987, -405.7180}, "X50 Y0 Z40"},
              {30, 70, {417.1010, 299.3101, -407.2257}, "X50 Y0 Z40 A0 C20"},
              {30, 70, {410.5740, 313.2202, -407.4538}, "X50 Y0 Z40 A10 C20"}};
  for (const auto& row : rows) {
    // The machine coordinates: the tip of a tool without length, seen from machine zero with all tables at 0.
    const nc::FiveAxisModel model = nc::fiveAxisModelOf(ac);
    const bool turned = std::string_view(row.table).find('A') != std::string_view::npos;
    const bool both = std::string_view(row.table).find("A10") != std::string_view::npos;
    const nc::RotaryAngles measured{both ? 10.0 : 0.0, turned ? 20.0 : 0.0};
    const Vec3 zero =
        model.dynamicZero({row.a + measured.first, row.c + measured.second}, {50, 0, 40}, measured);
    EXPECT_LT((zero - row.zero).norm(), kPrinted) << row.table << ": " << zero.transpose();
  }
  const Outcome out =
      runOf("G10 L21 P1 X50 Y0 Z40\nG0 G54 X0 Y0 Z100\nG43 H1 Z50\nG54.2 P1 G0 X0 Y0 Z0 A30 C90",
            settingsOf(ac, Vec3(450, 300, -420)));
  // The tip is on the point of the table that the zero goes with, from the side that the table has turned
  // there.
  expectTip(out, 4, {0, 0, 0});
}

TEST(DynamicZero, ATableThatTurnsInALineBendsIt) {
  const Outcome out = runOf("G10 L21 P1 X0 Y0 Z40\nG43 H1 G0 Z50\nG54.2 P1 G1 X-50 Y0 Z0 B0 F1000\nX50 B30",
                            settingsOf(test::trunnion('B'), kTableZero));
  expectTip(out, 3, {-50, 0, 0});
  expectTip(out, 4, {43.3013, 0, -25});
  bool seen = false;
  for (const Motion& m : out.path.motions)
    seen = seen || (m.source.line == 4 && (out.path.pointAt(m, 0.5) - Vec3(0, 0, -2.7259)).norm() < kPrinted);
  EXPECT_TRUE(seen);
}

/// Variables tell what is in force (25.4); G53 goes to machine positions whatever it is.
TEST(DynamicZero, IsReadAndSuspended) {
  const Outcome out = runOf(
      "G10 L21 P3 X50 Y0 Z40\nG43 H1 G0 Z50\nG54.2 P3 G0 X0 Y0 Z0 A30 "
      "C90\n#1=#5500\n#2=#5501\n#3=#5502\n#4=#5503\n"
      "G53 X#2 Y#3 Z[#4+100+#1]\nX0 Y0 Z0\nG54 G0 X0",
      settingsOf(test::trunnion('A'), Vec3(450, 300, -420)));
  EXPECT_EQ(out.error, "");
  // The machine is 3 mm above the zero, by the length of the tool: so is the tip, along the tool's direction.
  const ToolPose pose = endOf(out, 8);
  EXPECT_LT((pose.tip - 3.0 * pose.axis).norm(), kPrinted);
  expectTip(out, 9, {0, 0, 0});
}

/// G28 goes to machine positions: the linear axes do not follow the table on its way.
TEST(DynamicZero, TheReferencePointIsOfTheMachine) {
  const MachineModel machine = test::trunnion('A');
  const Vec3 zero(450, 300, -420);
  const Outcome out = runOf("G10 L21 P1 X50 Y0 Z40\nG43 H1 G0 Z50\nG54.2 P1 G0 X0 Y0 Z0 A30\nG28 A0",
                            settingsOf(machine, zero));
  EXPECT_EQ(out.error, "");
  AxisPoint turned(Vec3(450, 340, -330.7180)), back = turned;  // the printed zero, and the tool's 100 mm
  turned.more[0] = 30.0;
  const MachineChain chain(machine, zero);
  expectTip(out, 3, chain.pose(turned, 100).tip);
  expectTip(out, 4, chain.pose(back, 100).tip);
}

TEST(DynamicZero, TablesStandWhileCutterCompensationIsOn) {
  const Outcome out = runOf("G10 L21 P1 X50 Y0 Z40\nG54.2 P1 G0 X0 Y0 Z0\nG41 G1 X10 Y10 D1 F100\nX20 A30",
                            settingsOf(test::trunnion('A'), Vec3(450, 300, -420)));
  EXPECT_TRUE(out.error.starts_with("nct-rotary-in-comp")) << out.error;
}

TEST(DynamicZero, NeedsATable) {
  EXPECT_TRUE(
      runOf("G54.2 P1", settingsOf(test::machineCB(), Vec3::Zero())).error.starts_with("nct-machine-data"));
  EXPECT_TRUE(runOf("G54.2", settingsOf(test::trunnion('A'), Vec3::Zero())).error.starts_with("nct-2004"));
  EXPECT_TRUE(runOf("G54.2 P9", settingsOf(test::trunnion('A'), Vec3::Zero())).error.starts_with("nct-2002"));
}

std::string toolDirectionProgram(const char* angles) {
  return fmt::format(
      "N10 G17 G54 G0 X0 Y0\nN20 G43 Z0 H1\nN30 G68.2 X100 Y100 Z50 {}\nN40 G53.1\nN50 X0 Y0 Z0", angles);
}

TEST(ToolDirection, HeadsTurnAndTheTipHolds) {
  const Outcome out = runOf(toolDirectionProgram("I90 J45 K0"), settingsOf(test::machineCB(), Vec3::Zero()));
  EXPECT_NEAR(rotaryAt(out, 4, "B"), 45.0, 1e-9);
  EXPECT_NEAR(rotaryAt(out, 4, "C"), 0.0, 1e-9);
  expectTip(out, 4, {0, 0, 0});
  expectTip(out, 5, {100, 100, 50});
  EXPECT_LT((endOf(out, 5).axis - Vec3(std::sqrt(0.5), 0, std::sqrt(0.5))).norm(), 1e-9);
}

TEST(ToolDirection, TablesTurnTheWorkpiece) {
  const Outcome out = runOf(toolDirectionProgram("I90 J45 K0"), settingsOf(test::trunnion('A'), kTableZero));
  EXPECT_NEAR(rotaryAt(out, 4, "A"), 45.0, 1e-9);
  EXPECT_NEAR(rotaryAt(out, 4, "C"), 90.0, 1e-9);
  expectTip(out, 4, {0, 0, 0});
  expectTip(out, 5, {100, 100, 50});
  EXPECT_LT((endOf(out, 5).axis - Vec3(std::sqrt(0.5), 0, std::sqrt(0.5))).norm(), 1e-9);
}

TEST(ToolDirection, HeadAndTable) {
  const Outcome out = runOf(toolDirectionProgram("I0 J45 K0"), settingsOf(test::headTable(), kTableZero));
  EXPECT_NEAR(rotaryAt(out, 4, "B"), -45.0, 1e-9);
  EXPECT_NEAR(rotaryAt(out, 4, "C"), 90.0, 1e-9);
  expectTip(out, 4, {0, 0, 0});
  expectTip(out, 5, {100, 100, 50});
}

TEST(ToolDirection, ByTransformationOnlyTheRotaryAxesMove) {
  const struct {
    MachineModel machine;
    Vec3 zero, tip;
    const char* angles;
  } rows[] = {{test::machineCB(), Vec3::Zero(), {-176.7767, 0, 73.2233}, "I90 J45 K0"},
              {test::trunnion('A'), kTableZero, {56.5685, 0, -23.4315}, "I90 J45 K0"},
              {test::headTable(), kTableZero, {0, 176.7767, 73.2233}, "I0 J45 K0"}};
  for (const auto& row : rows) {
    ControlSettings settings = settingsOf(row.machine, row.zero);
    settings.parameters["N3212.FOS"] = 1.0;
    const Outcome out = runOf(toolDirectionProgram(row.angles), settings);
    expectTip(out, 4, row.tip);
    expectTip(out, 5, {100, 100, 50});
  }
}

TEST(ToolDirection, BeyondTravelTheOtherPairIsTaken) {
  MachineModel machine = test::trunnion('A');
  machine.axes[3].travel = AxisLimit{-120, 30};
  const Outcome out = runOf(toolDirectionProgram("I90 J45 K0"), settingsOf(machine, kTableZero));
  EXPECT_NEAR(rotaryAt(out, 4, "A"), -45.0, 1e-9);
  EXPECT_NEAR(rotaryAt(out, 4, "C"), -90.0, 1e-9);
  expectTip(out, 5, {100, 100, 50});
  machine.axes[3].travel = AxisLimit{-40, 30};
  const Outcome none = runOf(toolDirectionProgram("I90 J45 K0"), settingsOf(machine, kTableZero));
  EXPECT_TRUE(none.error.starts_with("nct-unreachable")) << none.error;
  EXPECT_NE(none.error.find("A -40 to 30"), std::string::npos) << none.error;
}

/// The faces of the manual's tetrahedron (25.12): one program on every machine.
TEST(ToolDirection, OneProgramOnEveryMachine) {
  const std::string program =
      "N10 G0 G54 G17 G90 G49 Z50\nN20 X0 Y0\nN40 G43 Z50 H1\nN50 G68.2 X0 Y0 Z0 I-90 J70.529 K90\nN60 "
      "G53.1\n"
      "N80 X-57.736 Y0 Z0\nN90 Z50\nN110 G68.2 X0 Y0 Z0 I30 J70.529 K90\nN120 G53.1\nN140 X-57.736 Y0 "
      "Z0\nN150 Z50\n"
      "N170 G68.2 X0 Y0 Z0 I150 J70.529 K90\nN180 G53.1\nN200 X-57.736 Y0 Z0";
  const struct {
    MachineModel machine;
    Vec3 zero;
    const char *first, *second;
    double angles[3][2];
  } rows[] = {
      {test::machineCB(), Vec3::Zero(), "C", "B", {{0, -70.529}, {-60, 70.529}, {-120, -70.529}}},
      {test::trunnion('A'), kTableZero, "A", "C", {{70.529, -90}, {70.529, 30}, {70.529, 150}}},
      {test::trunnion('B'), kTableZero, "B", "C", {{-70.529, 0}, {-70.529, 120}, {-70.529, 240}}},
      {test::headTable(), kTableZero, "B", "C", {{-70.529, 0}, {70.529, -60}, {-70.529, -120}}},
  };
  for (const auto& row : rows) {
    const Outcome out = runOf(program, settingsOf(row.machine, row.zero));
    const std::uint32_t turns[] = {5, 9, 13}, drills[] = {6, 10, 14};
    const Vec3 points[] = {{-19.245, 0, -54.434}, {9.623, -16.667, -54.434}, {9.623, 16.667, -54.434}};
    const Vec3 normals[] = {{-0.9428, 0, 0.3333}, {0.4714, -0.8165, 0.3333}, {0.4714, 0.8165, 0.3333}};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(std::remainder(rotaryAt(out, turns[k], row.first) - row.angles[k][0], 360.0), 0, 1e-6)
          << row.first << k;
      EXPECT_NEAR(std::remainder(rotaryAt(out, turns[k], row.second) - row.angles[k][1], 360.0), 0, 1e-6)
          << row.second << k;
      const ToolPose pose = endOf(out, drills[k]);
      EXPECT_LT((pose.tip - points[k]).norm(), 1e-3) << out.error;
      EXPECT_LT((pose.axis - normals[k]).norm(), 1e-4);
    }
  }
}

/// Without a rotary axis too the machine's own directions count: a lying spindle, a slide that leans.
TEST(Machines, OfThreeAxesMoveAsTheyAreBuilt) {
  MachineModel lying = test::plainMachine();
  lying.spindle.direction = -Vec3::UnitY();
  const Outcome tool = runOf("G0 X1 Y2 Z3\nG1 X5 F100", settingsOf(lying, Vec3::Zero()));
  expectTip(tool, 2, {5, 102, 3});
  EXPECT_EQ(endOf(tool, 2).axis, -Vec3::UnitY());
  // Beside X, Y and Z at right angles.
  MachineModel leaning = test::plainMachine();
  leaning.axes.push_back(test::linearAxis("U", 1, 2));
  leaning.axes[3].direction = Vec3(0, 0.6, 0.8);
  leaning.spindle.on = 3;
  const Outcome slide = runOf("G0 X1 U10 Z3\nG1 X5 U20 F100", settingsOf(leaning, Vec3::Zero()));
  expectTip(slide, 1, {1, 6, 3 + 8 - 100});
  expectTip(slide, 2, {5, 12, 3 + 16 - 100});
}

/// What a warning of this code says; empty: there is none.
std::string warningOf(const Outcome& out, std::string_view code) {
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.code == code) return d.message;
  }
  return {};
}

/// The same machine by the control's parameters: nothing is told, and the path is the same.
TEST(MachineData, ParametersThatSayWhatTheMachineIsChangeNothing) {
  ControlSettings settings = settingsOf(test::trunnion('A'), kTableZero);
  const Outcome own = runOf(toolDirectionProgram("I90 J45 K0"), settings);
  settings.parameters = {{"N3200", 2},    {"N3201", 3},     {"N3204", 4},   {"N3205", 1},
                         {"N3208", 5},    {"N3209", 3},     {"N3213", 400}, {"N3214", 300},
                         {"N3215", -500}, {"N3212.RD1", 1}, {"N3218", 40},  {"N3212.RD2", 1}};
  const Outcome given = runOf(toolDirectionProgram("I90 J45 K0"), settings);
  EXPECT_EQ(warningOf(given, "nct-machine-data"), "");
  ASSERT_EQ(own.path.motions.size(), given.path.motions.size());
  for (std::size_t k = 0; k < own.path.motions.size(); ++k)
    EXPECT_EQ(own.path.motions[k].to, given.path.motions[k].to);
}

TEST(MachineData, AWrongParameterShowsInThePath) {
  ControlSettings settings = settingsOf(test::trunnion('A'), kTableZero);
  settings.parameters["N3213"] = 401;  // a point of the table's axis, 1 mm beside where it is
  settings.parameters["N3215"] = -501;
  const Outcome out = runOf(toolDirectionProgram("I90 J45 K0"), settings);
  EXPECT_NE(warningOf(out, "nct-machine-data").find("N3213 = 401, but the machine has 400"),
            std::string::npos);
  EXPECT_EQ(out.error, "");
  // A turns by 45 degrees about an axis 1 mm too low for the control, C by 90 about one 1 mm aside.
  const Vec3 off = endOf(out, 5).tip - Vec3(100, 100, 50);
  EXPECT_GT(off.norm(), 0.5);
  EXPECT_LT(off.norm(), 3.0);
}

/// What all warnings of this code say, one a line.
std::string warningsOf(const Outcome& out, std::string_view code) {
  std::string all;
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.code == code) all += d.message + "\n";
  }
  return all;
}

/// Rotary angles, and where the tool really points, with a table inclined by -45 degrees that the control
/// takes for one of -44: it gets to (0.5, 0, 0.8660) by its own equations and misses.
TEST(MachineData, AWrongInclinationOfTheFirstAxisTurnsTheTool) {
  const double r = std::sqrt(0.5);
  MachineModel machine = test::plainMachine();
  test::addTable(machine, "B", {0, r, -r}, {400, 300, -500});
  test::addTable(machine, "C", Vec3::UnitZ(), {400, 300, -460});
  ControlSettings settings = settingsOf(machine, kTableZero);
  settings.parameters = {{"N3205", 5}, {"N3206", -45}};
  const Outcome right = runOf(toolDirectionProgram("I90 J30 K0"), settings);
  EXPECT_EQ(warningsOf(right, "nct-machine-data"), "");
  EXPECT_NEAR(rotaryAt(right, 4, "B"), 42.9414, 1e-4);
  EXPECT_NEAR(rotaryAt(right, 4, "C"), 15.5423, 1e-4);
  for (const bool with_direction : {true, false}) {  // alone it leans in the machine's own plane
    settings.parameters = {{"N3206", -44}};
    if (with_direction) settings.parameters["N3205"] = 5;
    const Outcome wrong = runOf(toolDirectionProgram("I90 J30 K0"), settings);
    EXPECT_NE(warningsOf(wrong, "nct-machine-data").find("N3206 = -44 (turns about"), std::string::npos)
        << warningsOf(wrong, "nct-machine-data");
    EXPECT_NEAR(rotaryAt(wrong, 4, "B"), 42.1759, 1e-4);
    EXPECT_NEAR(rotaryAt(wrong, 4, "C"), 14.9962, 1e-4);
    EXPECT_LT((endOf(wrong, 4).axis - Vec3(0.492087, -0.002201, 0.870543)).norm(), 1e-5);
  }
}

/// The same of the head that leans by 45 degrees, wanted (0.5, 0.5, 0.7071).
TEST(MachineData, AWrongInclinationOfTheSecondAxisTurnsTheTool) {
  const double r = std::sqrt(0.5);
  MachineModel machine = test::plainMachine();
  test::addHead(machine, "B", Vec3::UnitY(), {0, 0, 200});
  test::addHead(machine, "C", {0, r, r}, {0, 0, 200});
  const std::string program =
      "G54 G0 X0 Y0 Z0\nG43 Z0 H1\nG68.2 P3 Q1 I1 J-1 K0\nG68.2 P3 Q2 I0.5 J0.5 K0.7071067811865476\nG53.1";
  ControlSettings settings = settingsOf(machine, Vec3::Zero());
  settings.parameters = {{"N3209", 5}, {"N3210", 45}};
  const Outcome right = runOf(program, settings);
  EXPECT_EQ(warningsOf(right, "nct-machine-data"), "");
  EXPECT_NEAR(rotaryAt(right, 5, "B"), -19.4712, 1e-4);
  EXPECT_NEAR(rotaryAt(right, 5, "C"), 90.0, 1e-4);
  settings.parameters["N3210"] = 44;
  const Outcome wrong = runOf(program, settings);
  EXPECT_NE(warningsOf(wrong, "nct-machine-data").find("N3210 = 44 (turns about"), std::string::npos);
  EXPECT_NEAR(rotaryAt(wrong, 5, "B"), -20.8983, 1e-4);
  EXPECT_NEAR(rotaryAt(wrong, 5, "C"), 90.0349, 1e-4);
  EXPECT_LT((endOf(wrong, 5).axis - Vec3(0.482343, 0.500305, 0.719055)).norm(), 1e-5);
}

/// A head that leans by 45 degrees does not get behind (0, -0.9, -0.43), whatever its travel.
TEST(ToolDirection, WhatNoPositionHasIsTold) {
  const double r = std::sqrt(0.5);
  MachineModel machine = test::plainMachine();
  test::addHead(machine, "B", Vec3::UnitY(), {0, 0, 200});
  test::addHead(machine, "C", {0, r, r}, {0, 0, 200});
  const Outcome out =
      runOf("G68.2 P3 Q1 I1 J0 K0\nG68.2 P3 Q2 I0 J-0.9 K-0.43\nG53.1", settingsOf(machine, Vec3::Zero()));
  EXPECT_TRUE(out.error.starts_with("nct-unreachable")) << out.error;
  EXPECT_NE(out.error.find("no position has it (B endless, C endless)"), std::string::npos) << out.error;
}

/// A vector d too much from the holder to the second head axis moves the tip by M1 M2 d - d, one from there
/// to the first axis by M1 d - d: the control goes by V of its parameters, and the tip is by that of the
/// machine.
TEST(MachineData, WrongOffsetsOfHeadsMoveTheTip) {
  const struct {
    const char *parameter, *is, *angles;
    double value;
    Vec3 off;
  } rows[] = {{"N3219", "0", "C0 B90", 1, {-1, 0, -1}},    {"N3220", "0", "C90 B90", 2, {-2, -2, 0}},
              {"N3221", "150", "C0 B90", 151, {1, 0, -1}}, {"N3221", "150", "C90 B90", 153, {0, 3, -3}},
              {"N3222", "0", "C90 B90", 3, {-3, 3, 0}},    {"N3223", "0", "C90 B0", -2, {2, 2, 0}},
              {"N3224", "0", "C90 B90", 5, {0, 0, 0}}};
  for (const auto& row : rows) {
    ControlSettings settings = settingsOf(test::machineCB(), Vec3::Zero());
    settings.parameters[row.parameter] = row.value;
    const Outcome out =
        runOf(fmt::format("G54 G0 X0 Y0 Z300\nG43.1 H1 X10 Y20 Z30 {}", row.angles), settings);
    expectTip(out, 2, Vec3(10, 20, 30) + row.off);
    const std::string told =
        fmt::format("{} = {:g}, but the machine has {}:", row.parameter, row.value, row.is);
    const std::string all = warningsOf(out, "nct-machine-data");
    EXPECT_TRUE(all.starts_with(told)) << all;
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 1) << all;
  }
}

/// Of a head-table machine the vector leads to the head: V = M1 (H + I) - I.
TEST(MachineData, AWrongOffsetOfTheHeadBesideATable) {
  ControlSettings settings = settingsOf(test::headTable(), kTableZero);
  settings.parameters = {{"N3219", 5}, {"N3221", 148}};
  const Outcome out = runOf("G54 G0 X0 Y0 Z300\nG43.1 H1 X10 Y20 Z30 B90", settings);
  // d = (5, 0, -2) turns into (-2, 0, -5).
  expectTip(out, 2, Vec3(10, 20, 30) + Vec3(-7, 0, -3));
  const std::string all = warningsOf(out, "nct-machine-data");
  EXPECT_NE(all.find("N3219 = 5, but the machine has 0:"), std::string::npos) << all;
  EXPECT_NE(all.find("N3221 = 148, but the machine has 150:"), std::string::npos) << all;
}

TEST(MachineData, WhatNoMachineHasIsRefused) {
  ControlSettings settings = settingsOf(test::trunnion('A'), kTableZero);
  settings.parameters["N3204"] = 9;
  EXPECT_TRUE(runOf("G0 X0", settings).error.starts_with("nct-machine-data"))
      << runOf("G0 X0", settings).error;
  settings.parameters = {{"N3205", 3}, {"N3209", 3}};
  EXPECT_TRUE(runOf("G0 X0", settings).error.starts_with("nct-machine-data"));
}

/// #5041 and its like under a tilted plane and a length along the tool (25.19).
TEST(PositionVariables, OfTiltedPlanesAndLengths) {
  const std::string program =
      "G54 G0 X0 Y0 Z0\nG43 Z0 H1\nG68.2 X100 Y100 Z50 I90 J45 K0\nG53.1\nX10 Y20 Z30\n#1=#5041\n#2=#5042\n"
      "#3=#5043\nG69.1 G49\nG1 F100 X#1 Y#2 Z[#3+5]";
  const auto read = [&](bool tilted, bool tip) {
    ControlSettings settings = settingsOf(test::machineCB(), Vec3::Zero());
    settings.gauge_lengths.clear();
    if (tilted) settings.parameters["N1755.PCS"] = 1;
    if (tip) settings.parameters["N1755.TLC"] = 1;
    const Outcome out = runOf(program, settings);
    EXPECT_EQ(out.error, "");
    // With G49 and the head at B45 the control point is where the variables say.
    const MachineChain chain(*settings.machine, Vec3::Zero());
    AxisPoint head;
    head[4] = 45.0;
    return Vec3(endOf(out, 10).tip - chain.pose(head, 0.0).tip - Vec3(0, 0, 5));
  };
  const double r = std::sqrt(0.5);
  // The tip in workpiece coordinates: origin + 10 x' + 20 y' + 30 z'.
  const Vec3 tip = Vec3(100, 100, 50) + 10.0 * Vec3(0, 1, 0) + 20.0 * Vec3(-r, 0, r) + 30.0 * Vec3(r, 0, r);
  const Vec3 length(176.7767, 0, 26.7767 + 0.0);
  EXPECT_LT((read(false, true) - tip).norm(), kPrinted);
  EXPECT_LT((read(false, false) - (tip + length)).norm(), 1e-3);
  EXPECT_LT((read(true, true) - Vec3(10, 20, 30)).norm(), kPrinted);
}

}  // namespace
}  // namespace proveout
