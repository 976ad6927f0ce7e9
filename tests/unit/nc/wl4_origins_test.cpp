// Where the words behind a motion of the WL4 control were written.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "origin_run.h"

namespace proveout {
namespace {

using test::OriginRun;
using enum OriginKind;

OriginRun mill(const std::string& text, const ControlSettings& settings = {}) {
  return OriginRun(text, settings, {}, ControlId::kWl4Mill);
}
OriginRun lathe(const std::string& text, const ControlSettings& settings = {}) {
  return OriginRun(text, settings, {}, ControlId::kWl4Lathe);
}

ControlSettings withOffsets() {
  ControlSettings settings;
  settings.length_offsets[3] = {10.0, 0.5};
  settings.radius_offsets[4] = {2.0, 0.0};
  settings.work_offsets[1] = Vec3(10, 20, 30);
  settings.common_offset = Vec3(0, 0, 1);
  return settings;
}

TEST(Wl4Origins, NoWordSaysWhereAToolIsChanged) {
  ControlSettings settings;
  settings.tool_change.z = 200;
  const OriginRun run = mill("%M\nG90 G17 T5\nG0 X1 Y1 Z5\nM6 X2\nX3\nM30\n%\n", settings);
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(4, 0), kZ), "");
  EXPECT_EQ(run.said(run.motionOf(4, 0), kX), "3 X1");
  EXPECT_EQ(run.said(run.motionOf(4, 1), kX), "4 X2");
  EXPECT_EQ(run.said(run.motionOf(4, 1), kZ), "");
  EXPECT_EQ(run.said(run.motionOf(5), kZ), "");
}

TEST(Wl4Origins, ModalWordsAreFoundManyLinesLater) {
  const OriginRun run = mill(
      "%M\n"
      "G90 G17 G55 T5 M6\n"
      "S1000 M3 G43 H3\n"
      "G0 X1 Y1 Z50\n"
      "G1 Z-3.5 F200 $ Z9\n"
      "X10\nX20\nX30\nX40\nX50\nX60\nX70\nX80\nX90\nX100\nX110\nX120\n"
      "N99 G91 X5\n"
      "M30\n%\n",
      withOffsets());
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId m = run.motionOf(18);
  EXPECT_EQ(run.said(m, kX), "18 X5 step");
  EXPECT_EQ(run.said(m, kY), "4 Y1");
  EXPECT_EQ(run.said(m, kZ), "5 Z-3.5");
  EXPECT_EQ(run.said(m, kMotionCode), "5 G1");
  EXPECT_EQ(run.said(m, kFeed), "5 F200");
  EXPECT_EQ(run.said(m, kTool), "2 T5");
  EXPECT_EQ(run.said(m, kWorkOffset), "2 G55");
  EXPECT_EQ(run.said(m, kLengthOffset), "3 H3");
  EXPECT_EQ(run.said(m, kLengthCode), "3 G43");
  EXPECT_EQ(run.said(m, kSpindle), "3 S1000");
  EXPECT_EQ(run.said(m, kSpindleDirection), "3 M3");
  EXPECT_EQ(run.said(m, kDistance), "18 G91");
  EXPECT_EQ(run.said(m, kPlane), "2 G17");
  EXPECT_EQ(originOf(run.path, m, kX, run.text())->block, 99);
  const DataInForce& data = *dataOf(run.path, m);
  EXPECT_EQ(data.tool, 5);
  EXPECT_EQ(data.length.row, 3);
  EXPECT_DOUBLE_EQ(data.length.value(), 10.5);
  EXPECT_DOUBLE_EQ(data.length_offset.z(), 10.5);
  EXPECT_EQ(data.work_system, 2);
  EXPECT_EQ(data.work_offset.value, Vec3(10, 20, 30));
  EXPECT_EQ(data.common_offset.value, Vec3(0, 0, 1));
}

TEST(Wl4Origins, OfTwoWordsOfAnAxisTheLaterCounts) {
  const OriginRun run = mill("%M\nG0 X1 U5\nU5 X7\nX8 X9\nM30\n%\n");
  EXPECT_EQ(run.said(0, kX), "2 U5 step");
  EXPECT_EQ(run.said(1, kX), "3 X7");
  EXPECT_EQ(run.said(2, kX), "4 X9");
}

TEST(Wl4Origins, BlocksAlikeHaveTheirOwnWords) {
  const OriginRun run = mill(
      "%M\nG1 X1 Y1 F100\nX2 Y2\nX3 Y3\nX4 Y4\nG2 X14 R5\nG2 X24 R5\nG2 X34 R6\n"
      "G1 X35 Y5\nX36 Y- 6\nX(30+7) Y7\nX38 Y8\nG91\nX1 Y1\nX1 Y1\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0) << run.path.diagnostics.all().back().message;
  EXPECT_EQ(run.said(run.motionOf(5), kY), "5 Y4");
  for (const int line : {6, 7, 8}) {
    const MotionId m = run.motionOf(static_cast<std::uint32_t>(line));
    EXPECT_EQ(run.said(m, kArcRadius), fmt::format("{} R{}", line, line == 8 ? 6 : 5));
    EXPECT_EQ(run.said(m, kMotionCode), fmt::format("{} G2", line));
    EXPECT_EQ(run.said(m, kY), "5 Y4");
  }
  EXPECT_EQ(run.said(run.motionOf(9), kArcRadius), "");
  EXPECT_EQ(run.said(run.motionOf(10), kY), "10 Y- 6");
  EXPECT_EQ(run.valueOf(run.motionOf(10), kY), -6.0);
  EXPECT_EQ(run.said(run.motionOf(11), kX), "11 X(30+7)");
  EXPECT_EQ(run.said(run.motionOf(12), kX), "12 X38");
  EXPECT_EQ(run.said(run.motionOf(15), kX), "15 X1 step");
}

TEST(Wl4Origins, VariablesAreFollowedToTheirAssignments) {
  const OriginRun run =
      mill("%M\nG1 F100 #31=1.5\n#30=(-#31*2) X1\nX2\nX3\nZ#30 Y(#32=(#31+1))\nX#32\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(6), kZ), "6 Z#30 <- [3 #30=(-#31*2) <- [2 #31=1.5]]");
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(6), kZ), -3.0);
  EXPECT_EQ(run.said(run.motionOf(6), kY), "6 Y(#32=(#31+1)) <- [6 #32=(#31+1) <- [2 #31=1.5]]");
  EXPECT_EQ(run.said(run.motionOf(7), kX), "7 X#32 <- [6 #32=(#31+1) <- [2 #31=1.5]]");
}

TEST(Wl4Origins, ABadBlockTakesItsAssignmentsBack) {
  ControlSettings settings;
  settings.max_errors = 2;
  const OriginRun run = mill("%M\nG1 F100 #30=5\n#30=6 X99999\nX#30\nM30\n%\n", settings);
  EXPECT_EQ(run.summary.errors, 1);
  EXPECT_EQ(run.said(run.motionOf(4), kX), "4 X#30 <- [2 #30=5]");
}

TEST(Wl4Origins, SubprogramsAndRepeats) {
  const OriginRun run =
      mill("%M\nG1 X1 F100 #1=3\nL1002\nX2\nM30\n%\n%10\nY#1 #1=(#1+1)\nY#1\nZ-1\nZ-2\nM99\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(8), kY), "8 Y#1 <- [2 #1=3]");
  EXPECT_EQ(run.said(run.motionOf(9), kY), "9 Y#1 <- [8 #1=(#1+1) <- [2 #1=3]]");
  EXPECT_EQ(run.said(run.motionOf(8), kX), "2 X1");
  EXPECT_EQ(run.said(run.motionOf(8, 1), kZ), "11 Z-2") << "of the round before";
  EXPECT_EQ(originOf(run.path, run.motionOf(10), kZ, run.text())->depth, 1);
  EXPECT_EQ(run.said(run.motionOf(4), kZ), "11 Z-2");
  EXPECT_EQ(run.said(run.motionOf(4), kX), "4 X2");
}

TEST(Wl4Origins, FixedCyclesLeadToTheirParameters) {
  const OriginRun run = mill("%M\nG54 G0 X0 Y0 Z50\nG81 #2=2 #3=-12 F100\nX10\nX20\nY20\nG80\nX30\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  int bottoms = 0;
  for (MotionId m = 0; m < run.path.motions.size(); ++m) {
    const Motion& motion = run.path.motions[m];
    if (motion.source.depth == 0) continue;
    EXPECT_EQ(run.said(m, kCycle), "3 G81");
    EXPECT_EQ(run.said(m, kCycleDepth), "3 #3=-12");
    EXPECT_EQ(run.said(m, kCyclePlane), "3 #2=2");
    const auto z = originOf(run.path, m, kZ, run.text());
    ASSERT_TRUE(z);
    ASSERT_EQ(z->from.size(), 1u);
    EXPECT_EQ(run.path.files[z->file], "%81");
    const bool bottom = motion.to.z() == -12.0;
    EXPECT_EQ(run.shown(z->from[0]), bottom ? "3 #3=-12" : "3 #2=2");
    bottoms += bottom;
  }
  EXPECT_EQ(bottoms, 3);
  const MotionId behind = run.motionOf(8);
  for (const OriginKind kind : {kCycle, kCycleDepth, kCyclePlane, kCycleStep})
    EXPECT_EQ(run.said(behind, kind), "") << originKindName(kind);
}

TEST(Wl4Origins, PeckingHasItsStep) {
  const OriginRun run = mill("%M\nG54 G0 Z50\nG83 #2=2 #3=-12\n#5=4 F100\nX10\nG80\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.last(), kCycleStep), "4 #5=4");
}

TEST(Wl4Origins, SystemsCompensationMirrors) {
  ControlSettings settings = withOffsets();
  const OriginRun run = mill(
      "%M\nG54 G0 X0 Y0 Z10\nG92 X5 Y0\nX6\nG51 X-1\nX7\nG50\nX8\n"
      "G41 D4 G1 X20 F100\nX30\nY30\nG40 X0\nX-5\nM30\n%\n",
      settings);
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(4), kWorkOffset), "3 G92");
  EXPECT_EQ(run.saidBy(dataOf(run.path, run.motionOf(4))->work_offset.set_by[0]), "3 X5");
  EXPECT_EQ(dataOf(run.path, run.motionOf(4))->work_system, 0);
  EXPECT_EQ(run.said(run.motionOf(6), kMirror), "5 G51");
  EXPECT_EQ(run.said(run.motionOf(8), kMirror), "7 G50");
  EXPECT_EQ(run.said(run.motionOf(4), kX), "4 X6") << "G92 moves nothing";
  EXPECT_EQ(run.said(run.motionOf(11), kCompensation), "9 G41");
  EXPECT_EQ(run.said(run.motionOf(11), kRadiusOffset), "9 D4");
  EXPECT_DOUBLE_EQ(dataOf(run.path, run.motionOf(11))->radius.value(), 2.0);
  EXPECT_EQ(run.said(run.last(), kCompensation), "12 G40");
}

TEST(Wl4Origins, ArcsAndChamfers) {
  const OriginRun run = mill("%M\nG1 X10 F100\nG2 X20 Y0 I5 J0\nG3 X30 R6\nG1 X40 B2\nY40\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3), kI), "3 I5");
  EXPECT_EQ(run.said(run.motionOf(4), kArcRadius), "4 R6");
  EXPECT_EQ(run.said(run.motionOf(4), kI), "");
  EXPECT_EQ(run.said(run.motionOf(5, 1), kCorner), "5 B2");
}

// Turning.

ControlSettings turningTool() {
  ControlSettings settings = withOffsets();
  settings.parameters["RT.3"] = 0.8;
  settings.parameters["TIP.3"] = 3;
  return settings;
}

TEST(Wl4Origins, ToolsOfLathes) {
  const OriginRun run =
      lathe("%T\nG54 T3 M6\nG0 X50 Z5\nG42 D4 G1 X40 Z0 F200\nZ-20\nX60\nG40 X70\nM30\n%\n", turningTool());
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId m = run.motionOf(5);
  EXPECT_EQ(run.said(m, kX), "4 X40");
  EXPECT_EQ(run.said(m, kZ), "5 Z-20");
  EXPECT_EQ(run.said(m, kCompensation), "4 G42");
  EXPECT_EQ(run.said(m, kTool), "2 T3");
  const DataInForce& data = *dataOf(run.path, m);
  EXPECT_EQ(data.tool, 3);
  EXPECT_DOUBLE_EQ(data.nose_radius, 0.8);
  EXPECT_EQ(data.tip, 3);
  EXPECT_EQ(data.radius.row, 4);
}

TEST(Wl4Origins, OpenCyclesLeadToTheBlockThatCalledThem) {
  const OriginRun run = lathe("%T\nG54 S500 M3 F100\nG0 X60 Z2\nG70 X30 Z-40 #1=1 #2=2\nG0 X80\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  int inside = 0, ends = 0, rapids = 0;
  for (MotionId m = 0; m < run.path.motions.size(); ++m) {
    if (run.path.motions[m].source.depth == 0) continue;
    ++inside;
    EXPECT_EQ(run.said(m, kCycle), "4 G70");
    ends += run.said(m, kZ).find("[4 Z-40]") != std::string::npos;  // W(#24-#1) and #24=#135
    rapids += run.said(m, kX).find("[4 X30]") != std::string::npos;
  }
  EXPECT_EQ(inside, 5);
  EXPECT_GE(ends, 2);
  EXPECT_GE(rapids, 2);
  EXPECT_EQ(run.said(run.last(), kCycle), "");
}

TEST(Wl4Origins, ThreadsOfLathes) {
  const OriginRun run = lathe("%T\nG54 G97 S600 M3\nG0 X30 Z5\nG32 Z-25 F2\nG0 X40\nM30\n%\n");
  EXPECT_EQ(run.said(run.motionOf(4), kThreadLead), "4 F2");
  EXPECT_EQ(run.said(run.motionOf(4), kMotionCode), "4 G32");
}

/// Roughing along Z in passes of 4, an allowance of 0.5 on X, then the block behind it.
constexpr const char* kRoughing =
    "%T\n"
    "G54 T3 M6\n"
    "G0 X66 Z2\n"
    "G1 G77 P100 Q103 E4 I0.5 F150 X20 Z0\n"
    "M1\n"
    "G0 X80 F99\n"
    "M30\n"
    "N100 G1 Z-10\n"
    "N101 X40 Z-20\n"
    "N102 Z-30\n"
    "N103 X66\n"
    "%\n";

TEST(Wl4Origins, PassesOfContourCyclesNameTheContour) {
  const OriginRun run = lathe(kRoughing, turningTool());
  ASSERT_EQ(run.summary.errors, 0) << run.path.diagnostics.all().back().message;
  std::set<std::string> contours, ends;
  for (MotionId m = 0; m < run.path.motions.size(); ++m) {
    const Motion& motion = run.path.motions[m];
    if (motion.source.line != 4) continue;
    EXPECT_EQ(run.said(m, kCycle), "4 G77");
    EXPECT_EQ(run.said(m, kCycleStep), "4 E4");
    EXPECT_EQ(run.said(m, kAllowance), "4 I0.5");
    EXPECT_EQ(run.said(m, kFeed), "4 F150");
    const std::string contour = run.said(m, kContour);
    if (!contour.empty()) contours.insert(contour);
    if (motion.kind == MotionKind::kRapid) {
      EXPECT_EQ(contour, "");
    }
    if (contour == "9 N101 X40 Z-20") {
      EXPECT_EQ(run.said(m, kX), "9 X40");
      EXPECT_EQ(run.said(m, kZ), "9 Z-20");
    }
    if (contour == "10 N102 Z-30") {
      EXPECT_EQ(run.said(m, kX), "9 X40") << "modal in the contour";
      EXPECT_EQ(run.said(m, kZ), "10 Z-30");
    }
  }
  EXPECT_TRUE(contours.contains("8 N100 G1 Z-10"));
  EXPECT_TRUE(contours.contains("9 N101 X40 Z-20"));
  EXPECT_TRUE(contours.contains("10 N102 Z-30"));
  const MotionId behind = run.motionOf(6);
  EXPECT_EQ(run.said(behind, kContour), "");
  EXPECT_EQ(run.said(behind, kCycle), "");
  EXPECT_EQ(run.said(behind, kCycleStep), "");
  EXPECT_EQ(run.said(behind, kZ), "3 Z2") << "the cycle goes back to where it began";
}

TEST(Wl4Origins, FinishingHasTheNoseOfItsCycle) {
  std::string text = kRoughing;
  text.replace(text.find("G1 G77 P100 Q103 E4 I0.5 F150"), 29, "G1 G77 G42 P100 Q103 R0.2 F80");
  const OriginRun run = lathe(text, turningTool());
  ASSERT_EQ(run.summary.errors, 0) << run.path.diagnostics.all().back().message;
  const MotionId m = run.motionOf(4, 3);
  EXPECT_EQ(run.said(m, kCompensation), "4 G42");
  EXPECT_EQ(run.said(m, kAllowance), "4 R0.2");
  EXPECT_EQ(run.said(m, kCycleStep), "");
  EXPECT_NE(run.said(m, kContour), "");
  EXPECT_EQ(run.said(run.motionOf(6), kCompensation), "") << "the cycle ends it";
}

}  // namespace
}  // namespace proveout
