// Where the words behind a motion of the nct control were written.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "origin_run.h"

namespace proveout {
namespace {

using test::OriginRun;
using enum OriginKind;

ControlSettings withOffsets() {
  ControlSettings settings;
  settings.length_offsets[1] = {0.0, 0.0};
  settings.length_offsets[2] = {12.5, 0.25};
  settings.radius_offsets[1] = {3.0, 0.0};
  settings.radius_offsets[2] = {5.0, -0.5};
  settings.work_offsets[1] = Vec3(1, 2, 3);
  return settings;
}

TEST(Origins, ModalWordsAreFoundManyLinesLater) {
  const OriginRun run(
      "G90 G21 G17\n"
      "T5 M6\n"
      "G55 S1000 M3\n"
      "G43 H2 Z50\n"
      "G0 X0 Y0\n"
      "G1 Z-3.5 F200\n"
      "X10\nX20\nX30\nX40\nX50\nX60\nX70\nX80\nX90\nX100\nX110\n"
      "N99 X5 Y7\n"
      "M30\n",
      withOffsets());
  const MotionId m = run.motionOf(18);
  EXPECT_EQ(run.said(m, kX), "18 X5");
  EXPECT_EQ(run.said(m, kY), "18 Y7");
  EXPECT_EQ(run.said(m, kZ), "6 Z-3.5");
  EXPECT_EQ(run.said(m, kMotionCode), "6 G1");
  EXPECT_EQ(run.said(m, kFeed), "6 F200");
  EXPECT_EQ(run.said(m, kTool), "2 T5");
  EXPECT_EQ(run.said(m, kNextTool), "2 T5");
  EXPECT_EQ(run.said(m, kWorkOffset), "3 G55");
  EXPECT_EQ(run.said(m, kSpindle), "3 S1000");
  EXPECT_EQ(run.said(m, kSpindleDirection), "3 M3");
  EXPECT_EQ(run.said(m, kLengthOffset), "4 H2");
  EXPECT_EQ(run.said(m, kLengthCode), "4 G43");
  EXPECT_EQ(run.said(m, kUnits), "1 G21");
  EXPECT_EQ(run.said(m, kDistance), "1 G90");
  EXPECT_EQ(run.said(m, kPlane), "1 G17");
  EXPECT_EQ(run.said(m, kCompensation), "") << "power-on state";
  EXPECT_EQ(run.said(m, kCycle), "");
  EXPECT_EQ(run.said(run.motionOf(17), kY), "5 Y0");
  EXPECT_EQ(originOf(run.path, m, kX, run.text())->block, 99);
  EXPECT_DOUBLE_EQ(run.valueOf(m, kZ), -3.5);
}

TEST(Origins, OfAllWordsComeInTheOrderOfTheKinds) {
  const OriginRun run("G1 X5 F100\nM30\n");
  std::string all;
  for (const ResolvedOrigin& origin : originsOf(run.path, 0, run.text()))
    all += std::string(originKindName(origin.kind)) + "=" + origin.text + " ";
  EXPECT_EQ(all, "X=X5 motion code=G1 feed=F100 ");
}

TEST(Origins, WithoutTheTextPlacesHaveNoColumns) {
  const OriginRun run("G1 X5 F100\nM30\n");
  const LineText none = [](std::uint32_t, std::uint32_t) { return std::string(); };
  const auto origin = originOf(run.path, 0, kX, none);
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->line, 1u);
  EXPECT_EQ(origin->begin, 0);
  EXPECT_EQ(origin->text, "");
}

TEST(Origins, ABlockWithoutMotionCounts) {
  const OriginRun run("G1 X10 Y0 F100\nX10\nY5\nM30\n");
  EXPECT_EQ(run.said(run.motionOf(3), kX), "2 X10");
}

TEST(Origins, IncrementalWordsSaySo) {
  const OriginRun run("G90 G0 X10\nG91 X5\nG90 Y3\nXI2\nU1\nG1 Y8 F100\nM30\n");
  EXPECT_EQ(run.said(run.motionOf(2), kX), "2 X5 step");
  EXPECT_EQ(run.said(run.motionOf(3), kX), "2 X5 step");
  EXPECT_EQ(run.said(run.motionOf(3), kY), "3 Y3");
  EXPECT_EQ(run.said(run.motionOf(4), kX), "4 XI2 step");
  EXPECT_EQ(run.said(run.motionOf(6), kX), "5 U1 step");
  EXPECT_EQ(run.said(run.motionOf(6), kDistance), "3 G90");
}

TEST(Origins, LengthsAreMillimetres) {
  const OriginRun run("G20 G1 X1 F10\nG21 Y2\nG20 X[0.5+0.5] Y1\nM30\n");
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(2), kX), 25.4);
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(2), kY), 2.0);
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(3), kX), 25.4);
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(3), kFeed), 10.0) << "no length";
}

TEST(Origins, ArcWordsBelongToTheirBlock) {
  const OriginRun run("G1 X10 F100\nG2 X20 Y0 I5 J0\nG3 X30 R6\nG1 X40\nG18 G2 X45 Z5 K5 I0\nM30\n");
  EXPECT_EQ(run.said(run.motionOf(2), kI), "2 I5");
  EXPECT_EQ(run.said(run.motionOf(2), kJ), "2 J0");
  EXPECT_EQ(run.said(run.motionOf(2), kArcRadius), "");
  EXPECT_EQ(run.said(run.motionOf(3), kArcRadius), "3 R6");
  EXPECT_EQ(run.said(run.motionOf(3), kI), "");
  EXPECT_EQ(run.said(run.motionOf(4), kArcRadius), "");
  EXPECT_EQ(run.said(run.motionOf(4), kMotionCode), "4 G1");
  EXPECT_EQ(run.said(run.motionOf(5), kK), "5 K5");
  EXPECT_EQ(run.said(run.motionOf(5), kPlane), "5 G18");
}

TEST(Origins, CornersAndDirections) {
  const OriginRun run("G1 X20 F100 ,C2\nY20 ,R1\nX40 ,A45\nX60\nM30\n");
  EXPECT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(1, 1), kCorner), "1 ,C2") << "the chamfer itself";
  EXPECT_EQ(run.said(run.motionOf(2, 1), kCorner), "2 ,R1");
  EXPECT_EQ(run.said(run.motionOf(3), kAngle), "3 ,A45");
  EXPECT_EQ(run.said(run.motionOf(4), kCorner), "");
}

// Modal drilling: the words of the block that called the cycle hold at later holes.

TEST(Origins, CycleWordsHoldUntilG80) {
  const OriginRun run(
      "G0 X0 Y0 Z50\n"
      "F100\n"
      "G99 G83 X10 Y10 Z-12 R2 Q5\n"
      "X20\n"
      "Y20\n"
      "G80\n"
      "X30\n"
      "Z60\n"
      "M30\n");
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId hole = run.motionOf(5);
  EXPECT_EQ(run.said(hole, kCycle), "3 G83");
  EXPECT_EQ(run.said(hole, kCycleDepth), "3 Z-12");
  EXPECT_EQ(run.said(hole, kCyclePlane), "3 R2");
  EXPECT_EQ(run.said(hole, kCycleStep), "3 Q5");
  EXPECT_EQ(run.said(hole, kCycleReturn), "3 G99");
  EXPECT_EQ(run.said(hole, kX), "4 X20");
  EXPECT_EQ(run.said(hole, kY), "5 Y20");
  const MotionId behind = run.motionOf(7);
  for (const OriginKind kind : {kCycle, kCycleDepth, kCyclePlane, kCycleStep, kCycleReturn})
    EXPECT_EQ(run.said(behind, kind), "") << originKindName(kind);
  EXPECT_EQ(run.said(behind, kZ), "3 R2") << "G99 left the tool on the R plane";
  EXPECT_DOUBLE_EQ(run.valueOf(behind, kZ), 2.0);
}

TEST(Origins, ZInACycleIsTheWordOfTheLevel) {
  const OriginRun run("G0 X0 Y0 Z50\nG98 G83 X10 Z-9 R1 Q4 F100\nX20\nG80\nG0 Y5\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  int depth = 0, plane = 0, step = 0, initial = 0;
  for (MotionId m = 1; m < run.path.motions.size() && run.path.motions[m].source.line <= 3; ++m) {
    const double z = run.path.motions[m].to.z();
    const std::string said = run.said(m, kZ);
    const std::string wanted = z == -9.0 ? "2 Z-9" : z == 1.0 ? "2 R1" : z == 50.0 ? "1 Z50" : "2 Q4";
    EXPECT_EQ(said, wanted) << m << " at " << z;
    (z == -9.0 ? depth : z == 1.0 ? plane : z == 50.0 ? initial : step) += 1;
  }
  EXPECT_GE(depth, 2);
  EXPECT_GE(plane, 2);
  EXPECT_GE(step, 4);
  EXPECT_GE(initial, 2);
  EXPECT_EQ(run.said(run.last(), kZ), "1 Z50") << "G98 went back to the initial level";
}

TEST(Origins, CycleWordsMayChangeFromHoleToHole) {
  const OriginRun run("G0 X0 Z50\nG99 G81 X10 Z-5 R2 F100\nX20 R3\nX30 Z-6\nG1 X40\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3, 2), kZ), "2 Z-5");
  EXPECT_EQ(run.said(run.motionOf(3), kZ), "2 R2") << "to the next hole on the level of the last one";
  EXPECT_EQ(run.said(run.motionOf(3), kCyclePlane), "3 R3");
  EXPECT_EQ(run.said(run.motionOf(4, 1), kZ), "4 Z-6");
  EXPECT_EQ(run.said(run.motionOf(4, 1), kCyclePlane), "3 R3");
  EXPECT_EQ(run.said(run.motionOf(5), kZ), "3 R3") << "a code of group 1 ends the cycle";
  EXPECT_EQ(run.said(run.motionOf(5), kCycle), "");
}

TEST(Origins, CyclesAlongOtherAxes) {
  const OriginRun run("G18 G0 Y50\nG81 X10 Y-5 R2 F100\nX20\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3, 1), kCycleDepth), "2 Y-5");
  EXPECT_EQ(run.said(run.motionOf(3, 2), kY), "2 Y-5");
  EXPECT_EQ(run.said(run.motionOf(2), kY), "1 Y50");
}

// Tools, offsets, compensation.

TEST(Origins, TheToolIsThatOfTheChange) {
  const OriginRun run("T1\nM6\nT2\nG0 X1\nM6\nX2\nM30\n");
  EXPECT_EQ(run.said(run.motionOf(4), kTool), "1 T1");
  EXPECT_EQ(run.said(run.motionOf(4), kNextTool), "3 T2");
  EXPECT_EQ(run.said(run.motionOf(6), kTool), "3 T2");
  EXPECT_EQ(dataOf(run.path, run.motionOf(4))->tool, 1);
  EXPECT_EQ(dataOf(run.path, run.motionOf(6))->tool, 2);
}

TEST(Origins, NoWordSaysWhereAToolIsChanged) {
  ControlSettings settings;
  settings.tool_change.x = 300;
  settings.tool_change.z = 200;
  const OriginRun run("G0 X1 Y2 Z3\nT1\nM6\nX4\nY5 M6\nG0 Z6\nM6 X7\nM30\n", settings);
  ASSERT_EQ(run.summary.errors, 0);
  for (const std::size_t n : {0u, 1u}) {  // up, and level
    ASSERT_NE(run.motionOf(3, n), kNoMotion);
    EXPECT_EQ(run.said(run.motionOf(3, n), kZ), "");
    EXPECT_EQ(run.said(run.motionOf(3, n), kX), "");
    EXPECT_EQ(run.said(run.motionOf(3, n), kY), "1 Y2");
  }
  EXPECT_EQ(run.said(run.motionOf(4), kX), "4 X4");
  EXPECT_EQ(run.said(run.motionOf(4), kZ), "");
  EXPECT_EQ(run.said(run.motionOf(6), kZ), "6 Z6");
  EXPECT_EQ(run.said(run.motionOf(7), kX), "7 X7");
  EXPECT_EQ(run.said(run.last(), kX), "");  // M6 comes behind the motion of its block
  EXPECT_EQ(run.said(run.last(), kZ), "");
}

TEST(Origins, CutterCompensation) {
  const OriginRun run("G0 X0 Y0\nG41 D2 G1 X10 F100\nX20\nY20\nG40 X0\nX-5\nM30\n", withOffsets());
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(4), kCompensation), "2 G41");
  EXPECT_EQ(run.said(run.motionOf(4), kRadiusOffset), "2 D2");
  EXPECT_EQ(run.said(run.motionOf(4), kX), "3 X20");
  EXPECT_EQ(run.said(run.motionOf(6), kCompensation), "5 G40");
  const OffsetInForce& radius = dataOf(run.path, run.motionOf(4))->radius;
  EXPECT_EQ(radius.row, 2);
  EXPECT_DOUBLE_EQ(radius.value(), 4.5);
  EXPECT_EQ(radius.geometry_by, 0u) << "of the job";
}

TEST(Origins, OffsetRowsOfTheJobAndOfTheProgram) {
  const OriginRun run(
      "G43 H2 G0 Z10\n"
      "G10 L10 P1 R7\n"
      "#11001=0.5\n"
      "G43 H1 Z20\n"
      "G44 H1 Z30\n"
      "G49 Z40\n"
      "M30\n",
      withOffsets());
  ASSERT_EQ(run.summary.errors, 0);
  const DataInForce& job = *dataOf(run.path, run.motionOf(1));
  EXPECT_EQ(job.length.row, 2);
  EXPECT_DOUBLE_EQ(job.length.value(), 12.75);
  EXPECT_EQ(job.length.geometry_by, 0u);
  EXPECT_DOUBLE_EQ(job.length_offset.z(), 12.75);
  const DataInForce& own = *dataOf(run.path, run.motionOf(4));
  EXPECT_EQ(own.length.row, 1);
  EXPECT_DOUBLE_EQ(own.length.value(), 7.5);
  EXPECT_EQ(run.saidBy(own.length.geometry_by), "2 R7");
  EXPECT_EQ(run.saidBy(own.length.wear_by), "3 #11001=0.5");
  EXPECT_DOUBLE_EQ(dataOf(run.path, run.motionOf(5))->length_offset.z(), -7.5);
  EXPECT_DOUBLE_EQ(dataOf(run.path, run.motionOf(6))->length_offset.z(), 0.0);
  EXPECT_EQ(run.said(run.motionOf(6), kLengthCode), "6 G49");
}

TEST(Origins, ARowIsTheOneThatHHasRead) {
  const OriginRun run("G43 H1 G0 Z10\nG10 L10 P1 R7\nX5\nH1\nX6\nM30\n", withOffsets());
  EXPECT_DOUBLE_EQ(dataOf(run.path, run.motionOf(3))->length.value(), 0.0);
  EXPECT_DOUBLE_EQ(dataOf(run.path, run.motionOf(5))->length.value(), 7.0);
}

TEST(Origins, WorkOffsetsAndShifts) {
  const OriginRun run(
      "G0 X1\n"
      "G55 X2\n"
      "G10 L2 P2 Z4\n"
      "#5222=9\n"
      "X3\n"
      "#5242=8\n"
      "G52 X0.5 Y0.25\n"
      "X4\n"
      "G92 Y0\n"
      "X5\n"
      "G10 L20 P3 X1\n"
      "G54.1 P3 X6\n"
      "M30\n",
      withOffsets());
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(1), kWorkOffset), "");
  EXPECT_EQ(dataOf(run.path, run.motionOf(1))->work_system, 1);
  const DataInForce& job = *dataOf(run.path, run.motionOf(2));
  EXPECT_EQ(job.work_system, 2);
  EXPECT_EQ(job.work_offset.value, Vec3(1, 2, 3));
  EXPECT_EQ(job.work_offset.set_by[2], 0u);
  const DataInForce& changed = *dataOf(run.path, run.motionOf(5));
  EXPECT_EQ(changed.work_offset.value.z(), 4);
  EXPECT_EQ(run.saidBy(changed.work_offset.set_by[2]), "3 Z4");
  EXPECT_EQ(run.saidBy(changed.work_offset.set_by[0]), "") << "still the job's";
  const DataInForce& second = *dataOf(run.path, run.motionOf(8));
  EXPECT_EQ(run.saidBy(second.work_offset.set_by[1]), "6 #5242=8");
  EXPECT_EQ(second.shift.value.y(), 0.25);
  EXPECT_EQ(run.saidBy(second.shift.set_by[1]), "7 Y0.25");
  EXPECT_EQ(run.said(run.motionOf(8), kShift), "7 G52");
  const DataInForce& third = *dataOf(run.path, run.motionOf(10));
  EXPECT_EQ(run.saidBy(third.shift.set_by[1]), "9 Y0");
  EXPECT_EQ(run.saidBy(third.shift.set_by[0]), "7 X0.5");
  EXPECT_EQ(run.said(run.motionOf(10), kShift), "9 G92");
  EXPECT_EQ(run.said(run.motionOf(12), kWorkOffset), "12 G54.1");
  const DataInForce& extended = *dataOf(run.path, run.motionOf(12));
  EXPECT_EQ(extended.work_system, 103);
  EXPECT_EQ(run.saidBy(extended.work_offset.set_by[0]), "11 X1");
}

TEST(Origins, WordsOfShiftsAreNoPositions) {
  const OriginRun run("G0 X1 Y1\nG52 X10\nG68 X5 Y5 R90\nG69\nG52 X0\nG4 P1\nY2\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(7), kX), "1 X1");
  EXPECT_EQ(run.said(run.motionOf(7), kRotation), "4 G69");
}

TEST(Origins, Transforms) {
  const OriginRun run(
      "G0 X1\nG51.1 X0\nX2\nG50.1 X0\nG51 X0 Y0 P2\nX3\nG68 X0 Y0 R30\nX4\nG69 G50\nX5\nG16\nX6 Y10\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3), kMirror), "2 G51.1");
  EXPECT_EQ(run.said(run.motionOf(6), kMirror), "4 G50.1");
  EXPECT_EQ(run.said(run.motionOf(6), kScaling), "5 G51");
  EXPECT_EQ(run.said(run.motionOf(8), kRotation), "7 G68");
  EXPECT_EQ(run.said(run.motionOf(10), kScaling), "9 G50");
  EXPECT_EQ(run.said(run.motionOf(12), kPolar), "11 G16");
}

TEST(Origins, ThreadsHaveALeadOfTheirOwn) {
  const OriginRun run("S500 M3\nG1 X10 F100\nG33 Z-10 F2\nG1 X20\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3), kThreadLead), "3 F2");
  EXPECT_EQ(run.said(run.motionOf(4), kFeed), "2 F100");
}

TEST(Origins, PositionsByOtherCodes) {
  ControlSettings settings;
  settings.reference_points[0] = Vec3(0, 0, 100);
  const OriginRun run("G0 X10 Y10 Z10\nG53 Z50\nX11\nG28 Y20\nX12\nM30\n", settings);
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3), kZ), "2 Z50");
  EXPECT_EQ(run.said(run.motionOf(5), kY), "4 Y20");
}

// Lines whose text alone does not show the words.

TEST(Origins, ConditionalBlocksCommentsAndNames) {
  ControlSettings settings;
  AxisSettings axis;
  axis.name = "C";
  axis.number = 4;
  settings.axes.push_back(axis);
  const OriginRun run(
      "G1 F100\n"
      "IF[1EQ1] X5 (X6) Y2\n"
      "G1 X7 (to Z-9\n"
      "X8) Z-1\n"
      "G0 (G1 X9) X9 C30\n"
      "AX[1]=12 F200\n"
      "X13 Y#0\n"
      "M30\n",
      settings);
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(2), kX), "2 X5");
  EXPECT_EQ(run.said(run.motionOf(2), kY), "2 Y2");
  EXPECT_EQ(run.said(run.motionOf(4), kX), "3 X7");
  EXPECT_EQ(run.said(run.motionOf(4), kZ), "4 Z-1");
  EXPECT_EQ(run.said(run.motionOf(5), kMotionCode), "5 G0");
  EXPECT_EQ(run.said(run.motionOf(5), kC), "5 C30");
  EXPECT_EQ(run.said(run.motionOf(6), kX), "6 AX[1]=12");
  EXPECT_EQ(run.said(run.motionOf(7), kY), "2 Y2") << "a vacant word is none";
}

TEST(Origins, ABadBlockLeavesTheWordsAsTheyWere) {
  ControlSettings settings;
  settings.max_errors = 2;
  const OriginRun run("G1 X1 F100\nX2 F0\nY3\nM30\n", settings);
  EXPECT_EQ(run.summary.errors, 1);
  EXPECT_EQ(run.said(run.motionOf(3), kX), "1 X1");
  EXPECT_EQ(run.said(run.motionOf(3), kFeed), "1 F100");
}

// Variables, macros, subprograms.

TEST(Origins, VariablesAreFollowedToTheirAssignments) {
  const OriginRun run("G1 F100\n#102=1.5\nX1\n#101=-[#102*2]\n\nX2\nX3\nX4\nG1 Z#101\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId m = run.motionOf(9);
  EXPECT_EQ(run.said(m, kZ), "9 Z#101 <- [4 #101=-[#102*2] <- [2 #102=1.5]]");
  EXPECT_DOUBLE_EQ(run.valueOf(m, kZ), -3.0);
  EXPECT_DOUBLE_EQ(originOf(run.path, m, kZ, run.text())->from[0].value, -3.0);
}

TEST(Origins, AnAssignmentReadsWhatStandsOnItsRight) {
  const OriginRun run("G1 F100\n#1=100\n#2=7\n#[#1+1]=#2\nX#101\nX[#101+#2]\nM30\n");
  EXPECT_EQ(run.said(run.motionOf(5), kX), "5 X#101 <- [4 #[#1+1]=#2 <- [3 #2=7]]");
  EXPECT_EQ(run.said(run.motionOf(6), kX), "6 X[#101+#2] <- [4 #[#1+1]=#2 <- [3 #2=7]] <- [3 #2=7]");
}

TEST(Origins, ArgumentsOfMacros) {
  const OriginRun run("G1 F100\n#500=-4\nG65 P10 A5 Z#500\nG65 P10 A6 Z-1\nM30\n", {},
                      {{"O0010.nc", "#2=#1*2\nX#2\nZ#26\nM99\n"}});
  ASSERT_EQ(run.summary.errors, 0);
  ASSERT_EQ(run.path.motions.size(), 4u);
  EXPECT_EQ(run.said(0, kX), "O0010.nc:2 X#2 <- [O0010.nc:1 #2=#1*2 <- [3 A5]]");
  EXPECT_EQ(run.said(1, kZ), "O0010.nc:3 Z#26 <- [3 Z#500 <- [2 #500=-4]]");
  EXPECT_EQ(run.said(2, kX), "O0010.nc:2 X#2 <- [O0010.nc:1 #2=#1*2 <- [4 A6]]");
  EXPECT_EQ(run.said(3, kZ), "O0010.nc:3 Z#26 <- [4 Z-1]");
  EXPECT_EQ(run.path.motions[3].source.depth, 1);
}

TEST(Origins, ModalMacrosKeepTheirArguments) {
  const OriginRun run("G1 F100\nG66 P10 Z-3\nX10\nG67\nM30\n", {}, {{"O0010.nc", "Z#26\nM99\n"}});
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.last(), kZ), "O0010.nc:1 Z#26 <- [2 Z-3]");
  EXPECT_EQ(run.said(run.last(), kX), "3 X10");
}

TEST(Origins, SubprogramsAreOtherPlaces) {
  const OriginRun run("G1 X1 Z-1 F100\nM98 P10 L2\nX2\nM98 P10\nX3\nM30\n", {},
                      {{"O0010.nc", "Y5\nM98 P11\nY6\nM99\n"}, {"O0011.nc", "Z-2\nM99\n"}});
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId first = run.motionOf(1, 0, 1);
  EXPECT_EQ(run.said(first, kY), "O0010.nc:1 Y5");
  EXPECT_EQ(run.said(first, kZ), "1 Z-1") << "of the caller";
  EXPECT_EQ(run.said(first, kX), "1 X1");
  const MotionId second = run.motionOf(1, 1, 1);
  EXPECT_EQ(run.said(second, kZ), "O0011.nc:1 Z-2") << "of the last round";
  EXPECT_EQ(originOf(run.path, second, kZ, run.text())->depth, 2);
  EXPECT_EQ(run.said(run.motionOf(3), kY), "O0010.nc:3 Y6");
  EXPECT_EQ(run.said(run.motionOf(3), kFeed), "1 F100");
  EXPECT_EQ(run.said(run.motionOf(5), kX), "5 X3");
}

TEST(Origins, LoopsStayWithinBounds) {
  const OriginRun run(
      "G1 F1000\n#1=0\n#2=-0.001\nWHILE[#1LT20000]DO1\n#1=#1+1\nX#1 Z[#2*#1]\nY#1\nEND1\nX-1\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId m = run.motionOf(6, 15000);
  EXPECT_EQ(run.said(m, kX), "6 X#1 <- [5 #1=#1+1 <- [2 #1=0]]");
  EXPECT_EQ(run.said(m, kZ), "6 Z[#2*#1] <- [3 #2=-0.001] <- [5 #1=#1+1 <- [2 #1=0]]");
  EXPECT_DOUBLE_EQ(run.valueOf(run.motionOf(6, 5), kX), 6.0);
  EXPECT_TRUE(std::isnan(run.valueOf(m, kX))) << "too many values to keep them all";
  EXPECT_LT(run.path.origins.bytes(), run.path.motions.size() * sizeof(Motion) / 20);
}

TEST(Origins, VariablesThatFeedEachOther) {
  const OriginRun run(
      "G1 F1000\n#1=1\n#2=0\n#3=0\nWHILE[#3LT500]DO1\n#2=#1+1\n#1=#2+1\n#3=#3+1\nX#1\nY#2\nEND1\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(9, 400), kX), "9 X#1 <- [7 #1=#2+1 <- [6 #2=#1+1 <- [2 #1=1]]]");
  EXPECT_LT(run.path.origins.words.size(), 1000u);
}

std::size_t countBehind(const ResolvedOrigin& origin) {
  std::size_t count = origin.from.size();
  for (const ResolvedOrigin& from : origin.from) count += countBehind(from);
  return count;
}

TEST(Origins, VariablesThatAllReadEachOtherStayWithinBounds) {
  std::string text = "G1 F100\n";
  for (int k = 1; k <= 8; ++k) text += fmt::format("#{}={}\n", 100 + k, k);
  text += "#1=0\nWHILE[#1LT500]DO1\n";
  for (int k = 1; k <= 8; ++k)
    text += fmt::format("#{}=SIN[#101+#102+#103+#104+#105+#106+#107+#108]\n", 100 + k);
  const OriginRun run(text + "X[#101+#1]\nY[#108-#1]\n#1=#1+1\nEND1\nM30\n");
  ASSERT_EQ(run.summary.errors, 0);
  ASSERT_GE(run.path.motions.size(), 1000u);
  EXPECT_LT(run.path.origins.words.size(), 8u * 1024u);
  const auto origin = originOf(run.path, run.last(), kY, run.text());
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->text, "Y[#108-#1]");
  EXPECT_LE(countBehind(*origin), kMostBehind);
  const auto early = originOf(run.path, 0, kX, run.text());
  ASSERT_FALSE(early->from.empty());
  EXPECT_EQ(early->from[0].line, 12u);
}

TEST(Origins, LongChainsEndAfterSomeGenerations) {
  std::string text = "G1 F100\n#100=1\n";
  for (int k = 101; k < 140; ++k) text += fmt::format("#{}=#{}+1\n", k, k - 1);
  const OriginRun run(text + "X#139\nM30\n");
  auto origin = originOf(run.path, run.last(), kX, run.text());
  ASSERT_TRUE(origin);
  int generations = 0;
  for (const ResolvedOrigin* at = &*origin; !at->from.empty(); at = &at->from[0]) {
    ASSERT_EQ(at->from.size(), 1u);
    EXPECT_EQ(at->from[0].line, at->line - 1);
    ++generations;
  }
  EXPECT_GE(generations, 1);
  EXPECT_LE(generations, 8);
}

TEST(Origins, SystemVariablesTellOfWords) {
  const OriginRun run("G43 H1 G1 X3 F100\nG10 L10 P1 R5\nY#5001\nZ[#10001+1]\nF[#4109*2] X1\nM30\n",
                      withOffsets());
  ASSERT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.said(run.motionOf(3), kY), "3 Y#5001 <- [1 X3]");
  EXPECT_EQ(run.said(run.motionOf(4), kZ), "4 Z[#10001+1] <- [2 R5]");
  EXPECT_EQ(run.said(run.motionOf(5), kFeed), "5 F[#4109*2] <- [1 F100]");
}

TEST(Origins, ThePocketMacroLeadsToItsCall) {
  ControlSettings settings = withOffsets();
  const OriginRun run("G0 X0 Y0 Z5\nG65 P9999 X40 Y30 Z4 R6 D1 Q2 K1 F300\nM30\n", settings);
  ASSERT_EQ(run.summary.errors, 0);
  const auto origin = originOf(run.path, run.last() / 2, kX, run.text());
  ASSERT_TRUE(origin);
  EXPECT_NE(run.path.files[origin->file], "main.nc");
  ASSERT_FALSE(origin->from.empty());
  const ResolvedOrigin* at = &*origin;
  while (at->file != 0) {
    ASSERT_FALSE(at->from.empty());
    at = &at->from[0];
  }
  EXPECT_EQ(at->line, 2u);
  EXPECT_EQ(at->text, "G65");
  EXPECT_EQ(at->from[0].text, "K1");
}

TEST(Origins, InterruptMacrosGiveTheWordsBack) {
  ControlSettings settings;
  settings.interrupt_blocks = {3};
  settings.parameters["N1758.USD"] = 1;
  settings.parameters["N1758.TPI"] = 1;
  const OriginRun run("G1 X1 Z-1 F100\nM96 P10\nN3 X2\nY3\nM30\n", settings,
                      {{"O0010.nc", "G0 Z5 F900\nG91 X1\nM99\n"}});
  ASSERT_EQ(run.summary.errors, 0);
  const MotionId m = run.motionOf(4);
  EXPECT_EQ(run.said(m, kMotionCode), "1 G1");
  EXPECT_EQ(run.said(m, kFeed), "1 F100");
  EXPECT_EQ(run.said(m, kDistance), "");
  EXPECT_EQ(run.said(m, kZ), "O0010.nc:1 Z5") << "the axes stay";
}

// Sizes, sharing, channels.

TEST(Origins, PlainBlocksShareTheirSets) {
  std::string text = "T1 M6\nG0 Z5\nG1 Z-1 F100\n";
  for (int k = 0; k < 3000; ++k)
    text += fmt::format("{}{}\n", k % 3 == 0 ? "X" : k % 3 == 1 ? "Y" : "G1 X", k);
  const OriginRun run(text + "M30\n");
  EXPECT_EQ(run.path.motions.size(), 3001u);
  EXPECT_LT(run.path.origins.sets.size(), 60u);
  EXPECT_TRUE(run.path.origins.words.empty());
  EXPECT_EQ(run.said(run.last(), kY), fmt::format("{} Y2998", 3 + 2999));
}

TEST(Origins, MotionsAreNoLargerForThem) { EXPECT_EQ(sizeof(SourceRef), 24u); }

TEST(Origins, ChannelsHaveTheirOwn) {
  const MemoryProgramSource first("first.nc", "#500=-7\nG1 X10 Z-1 F100\nX20\nX30\nM30\n");
  const MemoryProgramSource second("second.nc", "G4 P0.1\n\nG1 X1 Y5 F50\nZ#500\nY6\nM30\n");
  std::vector<ChannelProgram> programs{{&first, {}}, {&second, {}}};
  for (int k = 0; k < 2; ++k) {
    programs[static_cast<std::size_t>(k)].settings.channel = k + 1;
    programs[static_cast<std::size_t>(k)].settings.start = Vec3::Zero();
    programs[static_cast<std::size_t>(k)].settings.parameters["N1701"] = 10;
  }
  Toolpath path;
  ToolpathBuilder sink(path);
  const InterpretSummary summary = interpretChannels(ControlId::kNct, programs, sink);
  ASSERT_EQ(summary.errors, 0);
  ASSERT_EQ(path.motions.size(), 6u);
  const LineText text = [&](std::uint32_t file, std::uint32_t line) {
    const MemoryProgramSource& source = path.files[file] == "first.nc" ? first : second;
    const nc::SourceText lines("", "", source.mainProgram()->bytes);
    return std::string(lines.lines()[line - 1]);
  };
  const auto said = [&](MotionId m, OriginKind kind) {
    const auto origin = originOf(path, m, kind, text);
    if (!origin) return std::string();
    return fmt::format("{}:{} {}", path.files[origin->file], origin->line, origin->text);
  };
  int seen = 0;
  for (MotionId m = 0; m < path.motions.size(); ++m) {
    const Motion& motion = path.motions[m];
    const std::string file = path.files[motion.source.file];
    if (file == "first.nc") {
      EXPECT_EQ(said(m, kZ), "first.nc:2 Z-1");
      EXPECT_EQ(said(m, kFeed), "first.nc:2 F100");
      EXPECT_EQ(said(m, kY), "");
    } else {
      EXPECT_EQ(said(m, kFeed), "second.nc:3 F50");
      EXPECT_EQ(said(m, kX), "second.nc:3 X1");
      if (motion.source.line < 4) continue;
      ++seen;
      EXPECT_EQ(said(m, kZ), "second.nc:4 Z#500");
      const auto origin = originOf(path, m, kZ, text);
      ASSERT_EQ(origin->from.size(), 1u) << "a common variable";
      EXPECT_EQ(path.files[origin->from[0].file], "first.nc");
      EXPECT_EQ(origin->from[0].text, "#500=-7");
    }
  }
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace proveout
