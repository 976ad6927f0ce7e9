// Tool centre point control on the manual's machines: the prism and circle of 25.14, the turns of 25.15, the
// pyramid and the cone of 25.16. Positions of the axes are those of the manual's equations.
//
// Rows: nct-3-G43.4 nct-3-G43.5 nct-3-G53.6 nct-25.14-G43.4 nct-25.14-G43.5 nct-25.14-G02G03 nct-25.14-F
// nct-25.14-G49 nct-25.14-EX nct-25.15-G53.6 nct-25.15-BUF nct-25.16-G43.4P1 nct-25.16-G43.5P1 nct-25.16-P0
// nct-25.16-ARC
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/nc/kinematics/five_axis_model.h"
#include "core/path/posed_way.h"
#include "tests/support/five_axis_runs.h"

namespace proveout {
namespace tip_control_test {
namespace {

using namespace test;  // NOLINT

const char* const kByAngles =
    "G54 G0 X0 Y0 Z100 B0 C0 S500 M3\nG43.4 X60 Y-60 Z-10 B30 H1\nG1 Y60 B45 F1200\nC90\nX-60 B30\nC180\n"
    "Y-60 B45\nC270\nX60 B30\nG49 G0 Z100\nG43.4 X50 Y0 Z0 C0 H1\nG3 X0 Y50 R50 C90\nX-50 Y0 R50 C180\n"
    "X0 Y-50 R50 C270\nX50 Y0 R50 C360\nG49 G0 Z100\nX0 Y0";
const char* const kByAnglesOfTables =
    "G54 G0 X0 Y0 Z100 A0 C0 S500 M3\nG43.4 X60 Y-60 Z-10 A-30 C-90 H1\nG1 Y60 A-45 F1200\nC0\nX-60 A-30\n"
    "C90\nY-60 A-45\nC180\nX60 A-30\nG49 G0 Z100\nG43.4 X50 Y0 Z0 A-30 C-90 H1\nG3 X0 Y50 R50 C0\n"
    "X-50 Y0 R50 C90\nX0 Y-50 R50 C180\nX50 Y0 R50 C270\nG49 G0 Z100\nX0 Y0";
const char* const kByVectors =
    "G54 G0 X0 Y0 Z100 S500 M3\nG43.5 X60 Y-60 Z-10 I500 J0 K866.025 H1\n"
    "G1 Y60 I707.107 J0 K707.107 F1200\nI0 J707.107 K707.107\nX-60 I0 J500 K866.025\nI-500 J0 K866.025\n"
    "Y-60 I-707.107 J0 K707.107\nI0 J-707.107 K707.107\nX60 I0 J-500 K866.025\nG49 G0 Z100\n"
    "G43.5 X50 Y0 Z0 I500 J0 K866.025 H1\nG3 X0 Y50 R50 I0 J500 K866.025\nX-50 Y0 R50 I-500 J0 K866.025\n"
    "X0 Y-50 R50 I-0 J-500 K866.025\nX50 Y0 R50 I500 J0 K866.025\nG49 G0 Z100\nX0 Y0";

/// The tips and directions of the program, which are the same on all machines.
void expectPrism(const Outcome& out, const char* what) {
  ASSERT_EQ(out.error, "") << what;
  const double s30 = 0.5, c30 = std::sqrt(0.75), r = std::sqrt(0.5);
  expectPose(poseAt(out, 2, 1), {60, -60, -10}, {s30, 0, c30}, what);
  expectPose(poseAt(out, 3, 0.5), {60, 0, -10}, {std::sin(degToRad(37.5)), 0, std::cos(degToRad(37.5))},
             what);
  expectPose(poseAt(out, 3, 1), {60, 60, -10}, {r, 0, r}, what);
  expectPose(poseAt(out, 4, 0.5), {60, 60, -10}, {0.5, 0.5, r}, what);
  expectPose(poseAt(out, 5, 1), {-60, 60, -10}, {0, s30, c30}, what);
  expectPose(poseAt(out, 9, 1), {60, -60, -10}, {0, -s30, c30}, what);
  expectPose(poseAt(out, 12, 0.5), {50 * r, 50 * r, 0}, {s30 * r, s30 * r, c30}, what);
  expectPose(poseAt(out, 15, 1), {50, 0, 0}, {s30, 0, c30}, what);
  EXPECT_NEAR(motionOf(out, 3)->time_s, 6.0, 1e-9) << what;
  EXPECT_NEAR(motionOf(out, 12)->time_s, 3.92699, 1e-5) << what;
}

TEST(TipControl, ThePrismAndTheCircleAreTheSameOnEveryMachine) {
  expectPrism(runOf(kByAngles, machineOf('H')), "HH by angles");
  expectPrism(runOf(kByAngles, machineOf('M')), "HT by angles");
  expectPrism(runOf(kByAnglesOfTables, machineOf('T')), "TT by angles");
  for (const char which : {'H', 'M', 'T'}) {
    // The pair at the first block is a full tie on TT: it is steered by where the axes are.
    std::string text = kByVectors;
    if (which == 'T') text.replace(0, 7, "G54 G0 A-1 C-80");
    const Outcome out = runOf(text, machineOf(which));
    expectPrism(out, "by vectors");
  }
}

TEST(TipControl, AxesAreWhereTheEquationsSay) {
  const Outcome hh = runOf(kByAngles, machineOf('H')), ht = runOf(kByAngles, machineOf('M')),
                tt = runOf(kByAnglesOfTables, machineOf('T'));
  expectAxes(hh, 2, {185, -60, 56.5064}, 0, 30);
  expectAxes(hh, 3, {236.7767, 60, 16.7767}, 0, 45);
  expectAxes(hh, 4, {60, 236.7767, 16.7767}, 90, 45);
  expectAxes(hh, 5, {-60, 185, 56.5064}, 90, 30);
  expectAxes(hh, 12, {0, 175, 66.5064}, 90, 30);
  expectAxes(tt, 2, {460, 316.9615, -309.3782}, -30, -90);
  expectAxes(tt, 3, {340, 292.9289, -308.0761}, -45, -90);
  expectAxes(tt, 4, {460, 292.9289, -308.0761}, -45, 0);
  expectAxes(tt, 5, {340, 316.9615, -309.3782}, -30, 0);
  expectAxes(tt, 12, {400, 303.3013, -305.7180}, -30, 0);
  expectAxes(ht, 2, {585, 240, -363.4936}, 30, 0);
  expectAxes(ht, 3, {636.7767, 360, -403.2233}, 45, 0);
  expectAxes(ht, 4, {636.7767, 240, -403.2233}, 45, 90);
  expectAxes(ht, 5, {585, 360, -363.4936}, 30, 90);
  // G49: only Z moves; the tip goes with it.
  const Motion* off = motionOf(hh, 10);
  ASSERT_NE(off, nullptr);
  EXPECT_LT((off->to - Vec3(60, -60, 33.4936)).norm(), kPrinted) << off->to.transpose();
}

const char* const kPyramid =
    "G54 G0 X150 Y150 Z100\nG43.5 P1 H1 Z0 I-20 J-20 K40 M3 S1000\nG1 X100 Y100 F1000\nX0 I20 J-20 K40\n"
    "Y0 I20 J20 K40\nX100 I-20 J20 K40\nY100 I-20 J-20 K40\nG0 X150 Y150\nG49 Z100";

TEST(ShankControl, TheToolTurnsInThePyramidsFace) {
  for (const char which : {'H', 'M', 'T'}) {
    const Outcome out = runOf(kPyramid, machineOf(which));
    ASSERT_EQ(out.error, "") << which;
    expectPose(poseAt(out, 4, 0.25), {75, 100, 0}, {-0.2087, -0.4374, 0.8747}, "quarter");
    expectPose(poseAt(out, 4, 0.5), {50, 100, 0}, {0, -0.4472, 0.8944}, "middle");
    expectPose(poseAt(out, 4, 1.0), {0, 100, 0}, {20, -20, 40}, "end");
  }
  const Outcome hh = runOf(kPyramid, machineOf('H'));
  EXPECT_NEAR(std::remainder(rotaryAt(hh, 4, "C") - -45.0, 180.0), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(rotaryAt(hh, 4, "B")), 35.2644, kPrinted);
  // Without shank control the tool leaves the face by 8.699 degrees in the middle.
  std::string plain = kPyramid;
  plain.replace(plain.find(" P1"), 3, " P0");
  const Outcome p0 = runOf(plain, machineOf('H'));
  expectPose(poseAt(p0, 4, 0.5), {50, 100, 0}, {0, -0.5774, 0.8165}, "P0");
}

TEST(ShankControl, AConeIsFollowedByItsAzimuth) {
  for (const char which : {'H', 'M', 'T'}) {
    const Outcome out = runOf(
        "G17 G54 G49 X-50 Y-50 Z100\nG43.5 P1 H1 X0 Y0 I0 J0 K40 S1000 M3\nG1 Z0 F500\nX100 I-20 J0 K40\n"
        "G3 X0 Y100 R100 I0 J-20 K40\nG1 Y0 I0 J0 K40\nG0 X-50 Y-50\nG49 Z100",
        machineOf(which));
    ASSERT_EQ(out.error, "") << which;
    expectPose(poseAt(out, 5, 0.25), {92.3880, 38.2683, 0}, {-0.4132, -0.1711, 0.8944}, "quarter");
    expectPose(poseAt(out, 5, 0.5), {70.7107, 70.7107, 0}, {-0.3162, -0.3162, 0.8944}, "middle");
    expectPose(poseAt(out, 5, 1.0), {0, 100, 0}, {0, -20, 40}, "end");
  }
}

TEST(ShankControl, AnglesAreRefusedThatLeaveThePlane) {
  const std::string head = "G54 G0 X0 Y0 Z0 B0 C0\nG43.4 P1 H1 X100 Y0 Z0\nG1 F500 B90 C0\n";
  const Outcome right = runOf(head + "X100 Y100 B90 C90", machineOf('H'));
  EXPECT_EQ(right.error, "");
  const Outcome wrong = runOf(head + "X100 Y100 B-90 C-90", machineOf('H'));
  EXPECT_NE(wrong.error.find("2192"), std::string::npos) << wrong.error;
  EXPECT_NE(wrong.error.find("-90"), std::string::npos) << wrong.error;
  const Outcome opposite = runOf(
      "G54 G0 X0 Y0 Z0\nG43.5 P1 H1\nG1 F500 X100 Y100 I-20 J-20 K40\n"
      "Y-100 I20 J20 K-40",
      machineOf('H'));
  EXPECT_NE(opposite.error.find("2192"), std::string::npos) << opposite.error;
}

TEST(ToolDirectionAboutTip, TheTipStaysOrAPointBeyondIt) {
  const std::string head = "G54 G0 B0 C0 X0 Y0 Z0\nG43 H1 Z0\nG68.2 X0 Y0 Z0 I90 J45 K0\n";
  for (const char which : {'H'}) {
    const Outcome plain = runOf(head + "G53.6 H1", machineOf(which));
    ASSERT_EQ(plain.error, "");
    for (const double share : {0.0, 0.3, 0.7, 1.0}) EXPECT_LT(poseAt(plain, 4, share).tip.norm(), 1e-9);
    expectAxes(plain, 4, {176.7767, 0, 26.7767}, 0, 45);
    const Outcome about = runOf(head + "G53.6 H1 R100", machineOf(which));
    ASSERT_EQ(about.error, "");
    EXPECT_LT((poseAt(about, 4, 0.5).tip - Vec3(38.2683, 0, -7.6120)).norm(), kPrinted);
    EXPECT_LT((poseAt(about, 4, 1.0).tip - Vec3(70.7107, 0, -29.2893)).norm(), kPrinted);
    expectAxes(about, 4, {247.4874, 0, -2.5126}, 0, 45);
    const Outcome to = runOf(head + "G53.6 H1 X0 Y-100 Z30", machineOf(which));
    ASSERT_EQ(to.error, "");
    expectAxes(to, 4, {268.7006, 0, -22.7208}, 0, 45);
    EXPECT_LT((poseAt(to, 4, 1.0).tip - Vec3(91.9239, 0, -49.4975)).norm(), kPrinted);
    EXPECT_LT((poseAt(to, 4, 0.5).tip - 0.5 * Vec3(91.9239, 0, -49.4975)).norm(), kPrinted);
  }
}

TEST(ToolDirectionAboutTip, RefusesWhatItCannotDo) {
  const auto error = [](const std::string& text) { return runOf(text, machineOf('H')).error; };
  EXPECT_NE(error("G0 X0\nG53.6 H1").find("2019"), std::string::npos);
  EXPECT_NE(error("G68.2 I90 J45 K0\nG53.6").find("2003"), std::string::npos);
  EXPECT_NE(error("G68.2 I90 J45 K0\nG53.6 H1 R10 X5").find("2042"), std::string::npos);
}

TEST(TipControl, RefusesWhatItCannotDo) {
  const auto error = [](const std::string& text) { return runOf(text, machineOf('H')).error; };
  EXPECT_NE(error("G2 X10 R10 F100\nG43.4 H1").find("G0 or G1"), std::string::npos);
  EXPECT_NE(error("G43.5 H1 I1 J0 K1\nG1 F100 B20").find("definition error"), std::string::npos);
  EXPECT_NE(error("G43.5 H1 I0 J0 K0").find("definition error"), std::string::npos);
  EXPECT_NE(error("G43.4 H1\nG41 D1 X10").find("G41"), std::string::npos);
  EXPECT_NE(error("G43.4 H1\nG81 X0 Y0 Z-5 R2 F100").find("cycles"), std::string::npos);
  EXPECT_NE(error("G43.4 H1\nG43 H1 Z0").find("G49"), std::string::npos);
  EXPECT_NE(error("G43.4 H1\nG1 F100 X10\nG2 X20 R10 G49").find("G49"), std::string::npos);
  EXPECT_NE(runOf("G43.4 H1", settingsOf(plainMachine(), Vec3::Zero())).error.find("machine-data"),
            std::string::npos);
}

TEST(TipControl, AWrongLengthShiftsTheToolAlongItself) {
  ControlSettings settings = machineOf('H');
  settings.length_offsets[1] = {103.0, 0.0};
  const Outcome out = runOf(kByAngles, settings);
  ASSERT_EQ(out.error, "");
  const ToolPose middle = poseAt(out, 3, 0.5);
  EXPECT_LT((middle.tip - (Vec3(60, 0, -10) + 3.0 * middle.axis)).norm(), 1e-9) << middle.tip.transpose();
}

TEST(TipControl, AWrongParameterShowsAlongTheWay) {
  ControlSettings settings = machineOf('T');
  settings.parameters["N3214"] = 305.0;  // the machine's table axis is at Y300
  const Outcome out = runOf(kByAnglesOfTables, settings);
  ASSERT_EQ(out.error, "");
  int pieces = 0;
  Vec3 last = Vec3::Zero();
  double worst = 0.0;
  for (const Motion& m : out.path.motions) {
    if (m.source.line != 3) continue;
    EXPECT_LT(pieces == 0 ? 0.0 : (m.from - last).norm(), 1e-9);
    ++pieces;
    last = m.to;
    worst = std::max(worst, std::abs(m.to.x() - 60.0));
  }
  EXPECT_GT(pieces, 1);
  EXPECT_GT((last - Vec3(60, 60, -10)).norm(), 1.0);
}

/// Poses of a line's motions at these shares of its time.
std::vector<ToolPose> posesOf(const Outcome& out, std::uint32_t line, int steps) {
  std::vector<const Motion*> pieces;
  double whole = 0.0, done = 0.0;
  for (const Motion& m : out.path.motions) {
    if (m.source.line != line) continue;
    pieces.push_back(&m);
    whole += m.time_s;
  }
  std::vector<ToolPose> poses;
  std::size_t at = 0;
  for (int k = 1; k <= steps && !pieces.empty(); ++k) {
    const double time = whole * k / steps;
    while (at + 1 < pieces.size() && done + pieces[at]->time_s < time) done += pieces[at++]->time_s;
    poses.push_back(posedWayOf(out.path, *pieces[at]).at(std::min(1.0, (time - done) / pieces[at]->time_s)));
  }
  return poses;
}

TEST(TipControl, FewPiecesFollowAWrongParameter) {
  // The table's axis is at Y300; the linear axes swing by some 400 mm, the error by 0.2.
  constexpr int kSteps = 48;
  ControlSettings settings = machineOf('T');
  settings.parameters["N3214"] = 300.2;
  const std::string start = "G54 G0 X0 Y0 Z100 A0 C0 S500 M3\nG43.4 ";
  const auto check = [&](const std::string& head, const std::string& block, int most,
                         const std::function<std::string(double)>& at) {
    const Outcome whole = runOf(start + head + "\n" + block + " F1200", settings);
    ASSERT_EQ(whole.error, "");
    const auto pieces = std::count_if(whole.path.motions.begin(), whole.path.motions.end(),
                                      [](const Motion& m) { return m.source.line == 3; });
    EXPECT_LE(pieces, most) << block;
    const std::vector<ToolPose> poses = posesOf(whole, 3, kSteps);
    ASSERT_EQ(poses.size(), static_cast<std::size_t>(kSteps));
    // At the ends of blocks the machine is where the control's equations put it.
    std::string text = start + head;
    for (int k = 1; k <= kSteps; ++k) text += "\n" + at(static_cast<double>(k) / kSteps) + " F1200";
    const Outcome steps = runOf(text, settings);
    ASSERT_EQ(steps.error, "");
    for (int k = 0; k < kSteps; ++k) {
      const ToolPose there = posesOf(steps, static_cast<std::uint32_t>(3 + k), 1).front();
      const ToolPose& here = poses[static_cast<std::size_t>(k)];
      EXPECT_LT((here.tip - there.tip).norm(), 7e-5) << block << " " << k;
      EXPECT_LT((here.axis - there.axis).norm(), 7e-7) << block << " " << k;
    }
  };
  check("X60 Y-60 Z-10 A-30 C-90 H1", "G1 Y60 A-45", 20,
        [](double t) { return fmt::format("G1 Y{:.9f} A{:.9f}", -60 + 120 * t, -30 - 15 * t); });
  check("X50 Y0 Z0 A-30 C-90 H1", "G3 X0 Y50 R50 C0 A-40", 80, [](double t) {
    const double angle = 0.5 * kPi * t;
    return fmt::format("G3 X{:.9f} Y{:.9f} R50 C{:.9f} A{:.9f}", 50 * std::cos(angle), 50 * std::sin(angle),
                       -90 + 90 * t, -30 - 10 * t);
  });
}

TEST(FiveAxisLines, WithoutTipControlTheTipLeavesItsLine) {
  // 25.14: N30 by the axes alone.
  const std::string hh = "G54 G0 X0 Y0 Z100 B0 C0\nG43.1 X60 Y-60 Z-10 B30 H1\nG1 Y60 B45 F1200";
  const Outcome cb = runOf(hh, machineOf('H'));
  ASSERT_EQ(cb.error, "");
  EXPECT_LT((poseAt(cb, 3, 0.5).tip - Vec3(58.6980, 0, -11.6968)).norm(), kPrinted);
}

}  // namespace
}  // namespace tip_control_test
}  // namespace proveout
