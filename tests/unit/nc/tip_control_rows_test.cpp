// What the manual says of tool centre point control (25.14), turns about the tip (25.15) and shank control
// (25.16) beside their codes: statement by statement, on machines with heads, with tables and with both.
//
// Rows: nct-25.14-LAW nct-25.14-G0G1 nct-25.14-FRAME nct-25.14-IJK nct-25.14-ROT nct-25.15-R nct-25.15-XYZ
// nct-25.15-H nct-25.15-2003 nct-25.15-2019 nct-25.15-2042 nct-25.16-LOAD nct-25.16-PLANE nct-25.16-PAIR
// nct-25.16-2192
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/nc/kinematics/five_axis_model.h"
#include "tests/support/five_axis_runs.h"

namespace proveout {
namespace tip_control_rows_test {
namespace {

using namespace test;  // NOLINT

std::string errorOf(const std::string& text, char machine) { return runOf(text, machineOf(machine)).error; }
void expectRefused(const std::string& text, char machine, std::string_view code) {
  const std::string error = errorOf(text, machine);
  EXPECT_TRUE(error.starts_with(code)) << text << ": " << error;
}

/// The direction of the tool on the test machines, from the names of their axes: B or A leans it, C turns it.
Vec3 directionOf(char machine, double lean, double turn) {
  const nc::FiveAxisModel model = nc::fiveAxisModelOf(*machineOf(machine).machine);
  return model.toolVector(machine == 'H' ? nc::RotaryAngles{turn, lean} : nc::RotaryAngles{lean, turn});
}
const char* leanOf(char machine) { return machine == 'T' ? "A" : "B"; }

// 25.14

/// Way and both angles go in one proportion, on lines, in rapid and on arcs.
TEST(TipControlRows, WayAndAnglesGoInOneProportion) {
  for (const char machine : {'H', 'T', 'M'}) {
    for (const char* mode : {"G1 X40 Y30 Z-20 F500", "G0 X40 Y30 Z-20", "G3 X-50 Y0 Z-20 R50 F500"}) {
      const bool arc = mode[1] == '3';
      const Outcome out = runOf(fmt::format("G54 G0 X0 Y0 Z100 {0}0 C0\nG43.4 H1 X{1} Y0 Z0\n{2} {0}40 C60",
                                            leanOf(machine), arc ? 50 : 0, mode),
                                machineOf(machine));
      ASSERT_EQ(out.error, "") << machine << mode;
      for (const double k : {0.0, 0.25, 0.5, 0.8, 1.0}) {
        const Vec3 tip = arc ? Vec3(50 * std::cos(kPi * k), 50 * std::sin(kPi * k), -20 * k)
                             : Vec3(40 * k, 30 * k, -20 * k);
        expectPose(poseAt(out, 3, k), tip, directionOf(machine, 40 * k, 60 * k), mode);
      }
    }
  }
}

/// Axes half way, as the manual's equations have them; where the axes of a head-table machine stand still.
TEST(TipControlRows, AxesHalfWay) {
  const auto expectHalf = [&](char machine, const Vec3& tip, const Vec3& xyz, double first, double second) {
    const ToolPose pose = poseOf(machineOf(machine), xyz, first, second);
    EXPECT_LT((pose.tip - tip).norm(), kPrinted) << machine << ": " << pose.tip.transpose();
  };
  const double r = 50 * std::sqrt(0.5);
  expectHalf('H', {60, 0, -10}, {212.1904, 0, 38.3383}, 0, 37.5);
  expectHalf('T', {60, 0, -10}, {400, 304.9879, -307.9396}, -37.5, -90);
  expectHalf('M', {60, 0, -10}, {612.1904, 300, -381.6617}, 37.5, 0);
  expectHalf('H', {60, 60, -10}, {185, 185, 16.7767}, 45, 45);
  expectHalf('T', {60, 60, -10}, {400, 310.5025, -290.5025}, -45, -45);
  expectHalf('M', {60, 60, -10}, {661.6295, 300, -403.2233}, 45, 45);
  expectHalf('H', {r, r, 0}, {123.7437, 123.7437, 66.5064}, 45, 30);
  expectHalf('T', {r, r, 0}, {400, 303.3013, -305.7180}, -30, -45);
  expectHalf('M', {r, r, 0}, {575, 300, -353.4936}, 30, 45);
  // The path goes through these: with its angles its tip is the same one.
  const Outcome hh =
      runOf("G54 G0 X0 Y0 Z100 B0 C0\nG43.4 X60 Y-60 Z-10 B30 H1\nG1 Y60 B45 F1200\nC90", machineOf('H'));
  expectPose(poseAt(hh, 3, 0.5), {60, 0, -10}, poseOf(machineOf('H'), {212.1904, 0, 38.3383}, 0, 37.5).axis,
             "half");
  expectPose(poseAt(hh, 4, 0.5), {60, 60, -10}, poseOf(machineOf('H'), {185, 185, 16.7767}, 45, 45).axis,
             "half");
}

TEST(TipControlRows, SwitchedInG0AndG1Alone) {
  for (const char* code : {"G43.4 H1", "G43.5 H1"}) {
    for (const char* mode :
         {"G2 X10 R10 F100", "G3 X10 R10 F100", "G33 Z-5 F1 S100 M3", "G81 X1 Z-5 R2 F100"})
      expectRefused(fmt::format("G54 G0 X0 Y0 Z0\n{}\n{}", mode, code), 'H', "nct-tcp-definition");
    for (const char* mode : {"G0", "G1 F100"})
      EXPECT_EQ(errorOf(fmt::format("G54 G0 X0 Y0 Z0\n{} {} X1\nG49 Z5", mode, code), 'H'), "");
    // G49 is of the same kind; G2 and G3 may run between.
    const std::string on = fmt::format("G54 G0 X0 Y0 Z0\n{}\n", code);
    expectRefused(on + "G2 X10 R10 F100\nG49", 'H', "nct-tcp-definition");
    expectRefused(on + "G3 X10 R10 F100\nG49 G3 X20 R10", 'H', "nct-tcp-definition");
    EXPECT_EQ(errorOf(on + "G2 X10 R10 F100\nG49 G1 X20", 'H'), "");
    expectRefused(on + "G33 Z-5 F1 S100 M3", 'H', "nct-tcp-definition");
  }
  // A rounding or chamfer in a block that turns the tool has no corner to stand in.
  const std::string on = "G54 G0 X0 Y0 Z0\nG43.4 H1\nG1 F100 X10";
  expectRefused(on + " B20 ,R2\nY20", 'H', "nct-tcp-definition");
  expectRefused(on + " ,C2\nY20 B20", 'H', "nct-2085");
  EXPECT_EQ(errorOf(on + " ,R2\nY20", 'H'), "");
}

/// Zero and axes turn with the part: after a quarter turn of the table the workpiece's X is a Y of the
/// machine.
TEST(TipControlRows, TheProgramTurnsWithThePart) {
  const Outcome out =
      runOf("G54 G0 X0 Y0 Z50 A0 C0\nG43.4 H1 X10 Y0 Z0\nC90\nG1 X30 F100\nA90\nY20", machineOf('T'));
  ASSERT_EQ(out.error, "");
  // Right-handed turns of the part are negative here: X points to -Y of the machine.
  const ToolPose turned = poseOf(machineOf('T'), {400, 290, -320}, 0, 90),
                 along = poseOf(machineOf('T'), {400, 270, -320}, 0, 90);
  expectPose(endOf(out, 3), turned.tip, turned.axis, "turned");
  EXPECT_LT((turned.tip - Vec3(10, 0, 0)).norm(), kPrinted);
  expectPose(poseAt(out, 4, 1.0), along.tip, along.axis, "X");
  EXPECT_LT((along.tip - Vec3(30, 0, 0)).norm(), kPrinted);
  EXPECT_LT((endOf(out, 5).tip - Vec3(30, 0, 0)).norm(), kPrinted);
  EXPECT_LT((endOf(out, 6).tip - Vec3(30, 20, 0)).norm(), kPrinted);
}

/// A call of G54.2 that turns the table: the tip goes straight from where it stands to its place in the new
/// zero, in the workpiece.
TEST(TipControlRows, ANewZeroStartsWhereTheTipStands) {
  ControlSettings settings = settingsOf(trunnion('A'), Vec3(450, 300, -420));
  const Outcome out = runOf(
      "G10 L21 P1 X50 Y10 Z40\nG54 G0 X0 Y0 Z50 A0 C0\nG43.4 H1 X5 Y5 Z20\nG54.2 P1 G1 X0 Y0 Z0 C30 F500",
      settings);
  ASSERT_EQ(out.error, "");
  const Vec3 from(5, 5, 20), to(0, 10, 0);  // the row's zero, seen from G54
  EXPECT_LT((endOf(out, 4).tip - to).norm(), kPrinted);
  EXPECT_LT((poseAt(out, 4, 0.5).tip - 0.5 * (from + to)).norm(), kPrinted);
}

/// A vector of any length; without one it stays, a part of one has zeros. Pairs are those of 25.11.
TEST(TipControlRows, TheVectorIsADirection) {
  const auto at = [](const char* words) {
    const Outcome out =
        runOf(fmt::format("G54 G0 X0 Y0 Z100\nG43.5 H1 X0 Y0 Z10 {}\nG1 Z-5 F100", words), machineOf('H'));
    EXPECT_EQ(out.error, "") << words;
    EXPECT_LT((endOf(out, 3).axis - endOf(out, 2).axis).norm(), 1e-12) << words;
    return endOf(out, 3).axis;
  };
  const Vec3 want = Vec3(1, 2, 2) / 3.0;
  for (const char* words : {"I1 J2 K2", "I1000 J2000 K2000", "I.001 J.002 K.002"})
    EXPECT_LT((at(words) - want).norm(), 1e-9) << words;
  EXPECT_LT((at("I5") - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((at("J1 K1") - Vec3(0, 1, 1).normalized()).norm(), 1e-9);
  EXPECT_LT((at("") - Vec3::UnitZ()).norm(), 1e-9);
  // The shorter way of the first axis goes on through whole turns: C360, 450, 540, 630, 720 of the circle.
  const Outcome circle = runOf(
      "G54 G0 X0 Y0 Z100 B30 C270\nG43.5 X50 Y0 Z0 I500 J0 K866.025 H1\nG3 F500 X0 Y50 R50 I0 J500 K866.025\n"
      "X-50 Y0 R50 I-500 J0 K866.025\nX0 Y-50 R50 I-0 J-500 K866.025\nX50 Y0 R50 I500 J0 K866.025",
      machineOf('H'));
  ASSERT_EQ(circle.error, "");
  for (const std::uint32_t line : {2u, 3u, 4u, 5u, 6u}) {
    EXPECT_NEAR(rotaryAt(circle, line, "C"), 360.0 + 90.0 * (line - 2), 1e-6) << line;
    EXPECT_NEAR(rotaryAt(circle, line, "B"), 30.0, 1e-4) << line;
  }
}

TEST(TipControlRows, RotaryWordsUnderG435AreAnAlarm) {
  const std::string on = "G54 G0 X0 Y0 Z0\nG43.5 H1 I1 J0 K1\n";
  for (const char* words : {"G1 F100 B20", "G1 F100 X10 C20", "G0 X1 B0 I0 J0 K1", "G91 G1 F100 C1"})
    expectRefused(on + words, 'H', "nct-tcp-definition: G43.5 definition error");
  expectRefused("G54 G0 X0\nG43.5 P1 H1 C20", 'H', "nct-tcp-definition: G43.5 definition error");
  expectRefused(on + "G1 F100 A20", 'T', "nct-tcp-definition: G43.5 definition error");
}

// 25.15

/// Plain, about a point beyond the tip, and straight to a target: tips, and the axes at the ends.
TEST(TurnAboutTipRows, TheManualsThreeForms) {
  const struct {
    const char *row, *words;
    Vec3 middle, end, heads, tables;
  } rows[] = {
      {"25.15-H", "", {0, 0, 0}, {0, 0, 0}, {176.7767, 0, 26.7767}, {343.4315, 300, -343.4315}},
      {"25.15-R",
       " R100",
       {38.2683, 0, -7.6120},
       {70.7107, 0, -29.2893},
       {247.4874, 0, -2.5126},
       {414.1421, 300, -314.1421}},
      {"25.15-XYZ",
       " X0 Y-100 Z30",
       {45.96195, 0, -24.74875},
       {91.9239, 0, -49.4975},
       {268.7006, 0, -22.7208},
       {443.4315, 300, -313.4315}},
  };
  const ControlSettings heads = machineOf('H'), tables = settingsOf(trunnion('B'), kTableZero);
  for (const auto& row : rows) {
    for (const char* length : {"", " H1"}) {
      const std::string text = fmt::format(
          "G54 G0 B0 C0 X0 Y0 Z0\nG43 H1 Z0\nG68.2 X0 Y0 Z0 I90 J45 K0\nG53.6{}{}", length, row.words);
      for (const bool table : {false, true}) {
        const Outcome out = runOf(text, table ? tables : heads);
        ASSERT_EQ(out.error, "") << row.row;
        EXPECT_LT((poseAt(out, 4, 0.5).tip - row.middle).norm(), kPrinted) << row.row;
        EXPECT_LT((poseAt(out, 4, 1.0).tip - row.end).norm(), kPrinted) << row.row;
        expectAxes(out, 4, table ? row.tables : row.heads, table ? 45 : 0, table ? 0 : 45);
      }
    }
  }
  const Outcome ac =
      runOf("G54 G0 A0 C0 X0 Y0 Z0\nG43 H1 Z0\nG68.2 X0 Y0 Z0 I90 J45 K0\nG53.6", machineOf('T'));
  ASSERT_EQ(ac.error, "");
  for (const double share : {0.0, 0.5, 1.0}) EXPECT_LT((poseAt(ac, 4, share).tip).norm(), 1e-6);
  expectAxes(ac, 4, {400, 356.5685, -343.4315}, 45, 90);
}

/// A negative R holds a point of the tool itself.
TEST(TurnAboutTipRows, APointOfTheToolMayBeHeld) {
  const Outcome out =
      runOf("G54 G0 B0 C0 X0 Y0 Z0\nG43 H1 Z0\nG68.2 X0 Y0 Z0 I90 J45 K0\nG53.6 R-100", machineOf('H'));
  ASSERT_EQ(out.error, "");
  for (const double share : {0.0, 0.4, 1.0}) {
    const ToolPose pose = poseAt(out, 4, share);
    EXPECT_LT((pose.tip + 100.0 * pose.axis - Vec3(0, 0, 100)).norm(), 1e-6);
  }
}

TEST(TurnAboutTipRows, Alarms) {
  const std::string plane = "G54 G0 X0 Y0 Z0\nG68.2 I90 J45 K0\n";
  expectRefused(plane + "G53.6", 'H', "nct-2003");
  expectRefused(plane + "G53.6 H0", 'H', "nct-2003");
  expectRefused(plane + "G43 H0 Z0\nG53.6 R10", 'H', "nct-2003");
  expectRefused("G54 G0 X0\nG53.6 H1", 'H', "nct-2019");
  expectRefused("G68.1 K1 R10\nG53.6 H1", 'H', "nct-2019");
  expectRefused(plane + "G69.1\nG53.6 H1", 'H', "nct-2019");
  for (const char* words : {"R10 X5", "R10 Y5", "X1 Z5 R-3", "R0 X5"})
    expectRefused(plane + "G53.6 H1 " + words, 'H', "nct-2042");
  EXPECT_EQ(errorOf(plane + "G53.6 H1 R10", 'H'), "");
}

/// The length that is in force before it is in force behind it, however it lies.
TEST(TurnAboutTipRows, TheLengthStays) {
  for (const char machine : {'H', 'T', 'M'}) {
    for (const char* code : {"G43", "G43.1", "G43.4", "G43.5"}) {
      const Outcome out =
          runOf(fmt::format("G54 G0 X0 Y0 Z0\n{} H1 Z50\nG68.2 I90 J30 K0\nG53.6\nX1 Y2 Z3", code),
                machineOf(machine));
      expectTip(out, 5, Vec3(-2 * std::sqrt(0.75) + 1.5, 1, 1 + 3 * std::sqrt(0.75)));
    }
  }
}

/// It stands alone in its block, with its own words.
TEST(TurnAboutTipRows, StandsAlone) {
  const std::string plane = "G54 G0 X0 Y0 Z0\nG68.2 I90 J45 K0\n";
  for (const char* block : {"G53.6 H1 M3", "G53.6 H1 F100", "G0 G53.6 H1", "G53.6 H1 G90", "G53.6 H1 S100"})
    expectRefused(plane + block, 'H', "nct-own-block");
  expectRefused(plane + "G53.6 H1 C5", 'H', "nct-2017");
  EXPECT_EQ(errorOf(plane + "N10 G53.6 X1 Y2 Z3 H1", 'H'), "");
}

// 25.16

/// The block of the call loads the length, and with axis words moves by it as that without P1 does.
TEST(ShankControlRows, TheCallLoadsTheLength) {
  for (const char* p : {"P0", "P1"}) {
    const Outcome alone =
        runOf(fmt::format("G54 G0 X5 Y0 Z100 B20 C0\nG43.4 {} H1\n#1=#5003\nG0 Z[#1+5]", p), machineOf('H'));
    ASSERT_EQ(alone.error, "");
    for (const Motion& m : alone.path.motions) EXPECT_NE(m.source.line, 2u);
    EXPECT_LT((endOf(alone, 4).tip - endOf(alone, 1).tip - Vec3(0, 0, 5)).norm(), 1e-9);
    for (const char* call :
         {"G43.4 {} H1 X60 Y-60 Z-10 B30", "G43.5 {} H1 X60 Y-60 Z-10 I500 J0 K866.0254038"}) {
      const Outcome moves =
          runOf("G54 G0 X0 Y0 Z100 B0 C0\n" + fmt::format(fmt::runtime(call), p), machineOf('H'));
      ASSERT_EQ(moves.error, "") << call;
      expectPose(poseAt(moves, 2, 1.0), {60, -60, -10}, {0.5, 0, std::sqrt(0.75)}, call);
      EXPECT_LT((poseAt(moves, 2, 0.5).tip - Vec3(30, -30, -5)).norm(), kPrinted) << call;
    }
  }
}

/// A line across the plane of its vectors: they turn all the same.
TEST(ShankControlRows, VectorsTurnWhereverTheLineGoes) {
  for (const char machine : {'H', 'T', 'M'}) {
    const Outcome out =
        runOf("G54 G0 X0 Y0 Z100\nG43.5 P1 H1 X0 Y0 Z0 I0 J-20 K40\nG1 X100 F500 I0 J20 K40\nY50 I20 J0 K40",
              machineOf(machine));
    ASSERT_EQ(out.error, "") << machine;
    expectPose(poseAt(out, 3, 0.5), {50, 0, 0}, {0, 0, 1}, "across");
    const double quarter = 0.5 * std::atan2(20.0, 40.0);
    expectPose(poseAt(out, 3, 0.25), {25, 0, 0}, {0, -std::sin(quarter), std::cos(quarter)}, "across");
    expectPose(poseAt(out, 4, 0.5), {100, 25, 0}, Vec3(20, 20, 80), "beside");
  }
}

/// The pair is the one that the way leads to: near the pole it is another than 25.11 would take.
TEST(ShankControlRows, ThePairGoesOnWithoutAJump) {
  const std::string text =
      "G54 G0 X0 Y0 Z100 B26 C5\nG43.5 {} H1 X0 Y0 Z0 I20 J2 K40\nG1 Y50 F500 I-20 J2 K40";
  const auto run = [&](const char* p) { return runOf(fmt::format(fmt::runtime(text), p), machineOf('H')); };
  const double c = radToDeg(std::atan2(2.0, 20.0)), b = radToDeg(std::atan2(std::hypot(20.0, 2.0), 40.0));
  const Outcome plain = run("P0"), shank = run("P1");
  ASSERT_EQ(plain.error + shank.error, "");
  EXPECT_NEAR(rotaryAt(plain, 3, "C"), -c, 1e-6);
  EXPECT_NEAR(rotaryAt(plain, 3, "B"), -b, 1e-6);
  EXPECT_NEAR(rotaryAt(shank, 3, "C"), 180.0 - c, 1e-6);
  EXPECT_NEAR(rotaryAt(shank, 3, "B"), b, 1e-6);
  expectPose(poseAt(shank, 3, 0.5), {0, 25, 0}, {0, 2, 40}, "over the pole");
  // The angles of the pyramid's sides (25.16), from one corner to the next.
  const Outcome pyramid = runOf(
      "G54 G0 X150 Y150 Z100 B35 C-135\nG43.5 P1 H1 X100 Y100 Z0 I-20 J-20 K40\n"
      "G1 X0 I20 J-20 K40 F500",
      machineOf('H'));
  ASSERT_EQ(pyramid.error, "");
  EXPECT_NEAR(rotaryAt(pyramid, 2, "C"), -135.0, 1e-6);
  EXPECT_NEAR(rotaryAt(pyramid, 3, "C"), -45.0, 1e-6);
  EXPECT_NEAR(rotaryAt(pyramid, 3, "B"), 35.2644, kPrinted);
  for (const double share : {0.25, 0.75}) {
    const double turn = share < 0.5 ? -115.5117 : -64.4883;
    expectPose(poseAt(pyramid, 3, share), {100 - 100 * share, 100, 0}, directionOf('H', 28.9872, turn),
               "side");
  }
  const Outcome tables = runOf(
      "G54 G0 X150 Y150 Z100 A35 C-45\nG43.5 P1 H1 X100 Y100 Z0 I-20 J-20 K40\n"
      "G1 X0 I20 J-20 K40 F500",
      machineOf('T'));
  ASSERT_EQ(tables.error, "");
  EXPECT_NEAR(rotaryAt(tables, 2, "C"), -45.0, 1e-6);
  EXPECT_NEAR(rotaryAt(tables, 3, "C"), 45.0, 1e-6);
  EXPECT_NEAR(rotaryAt(tables, 3, "A"), 35.2644, kPrinted);
}

TEST(ShankControlRows, InclinationsThatTheWayDoesNotLeadTo) {
  const std::string head = "G54 G0 X0 Y0 Z0 B0 C0\nG43.4 P1 H1 X100 Y0 Z0\nG1 F500 B90 C0\n";
  EXPECT_EQ(errorOf(head + "Y100 B90 C90", 'H'), "");
  const std::string wrong = errorOf(head + "Y100 B-90 C-90", 'H');
  EXPECT_TRUE(wrong.starts_with("nct-2192: inadmissible inclination angle in TPC: -90")) << wrong;
  // The same angles without shank control are a way like any other.
  std::string plain = head + "Y100 B-90 C-90";
  plain.replace(plain.find("P1"), 2, "P0");
  EXPECT_EQ(errorOf(plain, 'H'), "");
  const std::string vectors = "G54 G0 X0 Y0 Z0\nG43.5 P1 H1\nG1 F500 X100 Y100 I-20 J-20 K40\nY-100 ";
  expectRefused(vectors + "I20 J20 K-40", 'H', "nct-2192");
  expectRefused(vectors + "I20 J20 K-40.0001", 'H', "nct-2192");
  EXPECT_EQ(errorOf(vectors + "I20 J20 K-20", 'H'), "");
}

}  // namespace
}  // namespace tip_control_rows_test
}  // namespace proveout
