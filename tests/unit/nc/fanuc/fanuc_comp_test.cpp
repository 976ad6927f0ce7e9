// Cutter compensation of Fanuc-like mills (iso-fanuc, section 8).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace fanuc_comp_test {
namespace {

using Lines = std::vector<std::string>;
using Parameters = std::map<std::string, double>;

/// D1 = 5, D2 = 3, D3 = -5.
IsoRun mill(const std::string& body, Parameters parameters = {}) {
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.parameters.emplace("rapid", 1);  // straight
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.radius_offsets[2] = {2.5, 0.5};
  settings.radius_offsets[3] = {-5.0, 0.0};
  settings.tool_radii[7] = 4.0;
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100\n" + body + "M30\n", settings};
}
Lines motions(const std::string& body, Parameters parameters = {}) {
  const IsoRun run = mill(body, std::move(parameters));
  EXPECT_EQ(run.error(), "") << body << run.message();
  return run.motions();
}

// fan-8-G41 fan-8-G40; acceptance 16
TEST(FanucComp, AroundASquare) {
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nX40\nY0\nG40 X60\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 45 35 0", "F 45 0 0", "F 60 0 0"}));
  EXPECT_EQ(motions("G0 X-20 Y-20\nG41 D1 G1 X0 F200\nY40\nX40\nY0\nX-10\nG40 Y-20\n"),
            (Lines{"R -20 -20 0", "F -5 -20 0", "F -5 45 0", "F 45 45 0", "F 45 -5 0", "F -10 -5 0",
                   "F -10 -20 0"}));
}

// fan-8-startA fan-8-startB; acceptance 17
TEST(FanucComp, StartUpByTheCorner) {
  const std::string body = "G0 X20 Y0\nG41 D1 G1 X0 Y0\nY30\nG40 X-20\n";
  EXPECT_EQ(motions(body)[1], "F -5 0 0");
  EXPECT_EQ(motions(body, {{"comp_startup", 1}})[1], "F -5 -5 0");
  // Deflection 135: the two corner points, from (20,-20) in the direction (-1,1), then +X... then -Y.
  const Lines b = motions("G0 X-20 Y0\nG41 D1 G1 X0 Y0\nX-10 Y-10\nG40 X-20\n", {{"comp_startup", 1}});
  EXPECT_EQ(b[1], "F 5 5 0");
  EXPECT_EQ(b[2], "F 7.0711 0 0");
  // The way out is the mirror image of the way in.
  const std::string out = "G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG40 X20\n";
  EXPECT_EQ(motions(out), (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F 20 30 0"}));
  EXPECT_EQ(motions(out, {{"comp_startup", 1}}), (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 20 30 0"}));
  // Inside corners are square in both.
  EXPECT_EQ(motions("G0 X-20\nG41 D1 G1 X0 Y0\nY30\nG40 X-20\n", {{"comp_startup", 1}}),
            (Lines{"R -20 0 0", "F -5 0 0", "F -5 30 0", "F -20 30 0"}));
}

TEST(FanucComp, SwitchedOnWithoutAMotion) {
  const std::string body = "G0 X0 Y-20\nG41 D1\nG1 X0 Y0\nY30\nX40\nG40 Y0\n";
  // A, B: the next motion is the way in.
  EXPECT_EQ(motions(body), (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 40 35 0", "F 40 0 0"}));
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 X0 Y-20\nG1 X0 Y0\nY30\nX40\nG40 Y0\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 40 35 0", "F 40 0 0"}));
  // C: at once, square to the next block.
  EXPECT_EQ(motions(body, {{"comp_startup", 2}}),
            (Lines{"R 0 -20 0", "F -5 -20 0", "F -5 0 0", "F -5 35 0", "F 40 35 0", "F 40 0 0"}));
  // With Z alone the vector is made by the next motion in the plane.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 Z-2\nX0 Y0\nY30\nG40 X-20\n"),
            (Lines{"R 0 -20 0", "F 0 -20 -2", "F -5 0 -2", "F -5 30 -2", "F -20 30 -2"}));
}

// fan-8-inner; acceptance 18
TEST(FanucComp, InsideCorner) {
  EXPECT_EQ(motions("G0 X-20\nG41 D1 G1 X0 Y0\nY30\nX-30\nG40 Y60\n"),
            (Lines{"R -20 0 0", "F -5 0 0", "F -5 25 0", "F -30 25 0", "F -30 60 0"}));
}

// fan-8-corner; acceptance 19 and the table of section 8
TEST(FanucComp, OutsideCorners) {
  struct Corner {
    int deflection;
    Lines points;
  };
  const std::vector<Corner> corners{{5, {"F 0.2183 5 0"}},
                                    {45, {"F 2.0711 5 0"}},
                                    {90, {"F 5 5 0"}},
                                    {120, {"F 5 5 0", "F 6.8301 1.8301 0"}},
                                    {135, {"F 5 5 0", "F 7.0711 0 0"}},
                                    {175, {"F 5 5 0", "F 5.4168 -4.5452 0"}}};
  for (const Corner& corner : corners) {
    const double angle = -corner.deflection * M_PI / 180.0;
    const std::string next = fmt::format("X{:.3f} Y{:.3f}\n", 5000 * std::cos(angle), 5000 * std::sin(angle));
    const Lines all = motions("G0 X-60 Y-20\nG41 D1 G1 X-50 Y0\nX0\n" + next + "G40 X9000 Y-9000\n");
    ASSERT_GT(all.size(), 2 + corner.points.size());
    for (std::size_t k = 0; k < corner.points.size(); ++k) {
      EXPECT_EQ(all[2 + k], corner.points[k]) << corner.deflection;
    }
  }
}

TEST(FanucComp, ArcsMeetByTheirTangents) {
  // A half circle outside: same centre, radius 20 + 5; its ends by the lines' normals.
  EXPECT_EQ(motions("G0 X-40 Y-20\nG41 D1 G1 X-20\nY0\nG2 X20 R20\nG1 Y-20\nG40 X40\n"),
            (Lines{"R -40 -20 0", "F -25 -20 0", "F -25 0 0", "A 25 0 0 c 0 0 0 -180", "F 25 -20 0",
                   "F 40 -20 0"}));
  // Outside corner of 90 degrees into an arc: the corner's end is where the offset arc starts.
  EXPECT_EQ(motions("G0 X-40 Y0\nG41 D1 G1 X-20\nX0\nG2 X-20 Y-20 R20\nG40 G1 X-40\n")[2], "F 5 5 0");
  EXPECT_EQ(
      motions("G0 X-40 Y0\nG41 D1 G1 X-20\nX0\nG2 X-20 Y-20 I-20 J0\nG40 G1 X-40\n"),
      (Lines{"R -40 0 0", "F -20 5 0", "F 5 5 0", "F 5 0 0", "A -20 -25 0 c -20 0 0 -90", "F -40 -20 0"}));
}

// fan-8-041 fan-8-034; acceptance 20
TEST(FanucComp, Refusals) {
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY20\nG3 X-4 Y24 R4\nG1 X-40\nG40 Y40\n").error(), "fanuc-041");
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY20\nG3 X-5 Y25 R5\nG1 X-40\nG40 Y40\n").error(), "fanuc-041");
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY20\nG3 X-6 Y26 R6\nG1 X-40\nG40 Y40\n").error(), "");
  // A groove of 8 is too narrow for the cutter of 10.
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY20\nX-8\nY0\nG40 X-20\n").error(), "fanuc-041");
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G2 X20 Y0 R20\n").error(), "fanuc-034");
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1\nG2 X20 Y0 R20\n").error(), "fanuc-034");
  EXPECT_EQ(mill("G41 D1 G1 X0 Y10\nY20\nG40 G2 X20 Y40 R20\n").error(), "fanuc-034");
  EXPECT_EQ(mill("G41 D1 G1 X0 Y10\nY20\nG40\nG2 X20 Y40 R20\n").error(), "fanuc-034");
  EXPECT_EQ(mill("G41 D1 G1 X0 Y10\nG18\nX20\n").error(), "fanuc-037");
  // An arc inside with room for the cutter, and one whose offset does not meet that of the line: 033.
  EXPECT_EQ(mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nX20\nG3 X20 Y12 R6\nG1 X0 Y12\nG40 X-20\n").error(), "");
  EXPECT_EQ(mill("G0 X-20 Y0\nG41 D1 G1 X10\nX20\nG3 X16.961 Y3.504 I-5.903 J-2.051\nG1 X-27.478 Y26.421\n")
                .error(),
            "fanuc-033");
}

// Section 10: the places of drilling cycles are compensated, the holes themselves keep the vector.
TEST(FanucComp, DrillingCycles) {
  EXPECT_EQ(motions("G0 X-20 Y0\nG41 D1 G1 X0 Y0\nG99 G81 X0 Y30 Z-5 R2\nX40\nY0\nG80\nG40 G0 X60\n"),
            (Lines{"R -20 0 0", "F -5 0 0", "R -5 35 0", "R -5 35 2", "F -5 35 -5", "R -5 35 2", "R 45 35 2",
                   "F 45 35 -5", "R 45 35 2", "R 45 0 2", "F 45 0 -5", "R 45 0 2", "R 60 0 2"}));
  // The way to the first hole is the start-up, square to the next; repeats at a place drill there again.
  EXPECT_EQ(motions("G99 G41 D1 G81 X20 Y0 Z-5 R2\nX40 K2\nG80 G40 G0 X60\n"),
            (Lines{"R 20 5 0", "R 20 5 2", "F 20 5 -5", "R 20 5 2", "R 40 5 2", "F 40 5 -5", "R 40 5 2",
                   "F 40 5 -5", "R 40 5 2", "R 60 0 2"}));
  // Pecks and dwells stay in the hole.
  EXPECT_EQ(motions("G0 X-20 Y0\nG41 D1 G1 X0 Y0\nG99 G83 X0 Y30 Z-5 R2 Q4\nG80\nG0 X40\nG40 Y0\n"),
            (Lines{"R -20 0 0", "F -5 0 0", "R -5 35 0", "R -5 35 2", "F -5 35 -2", "R -5 35 2",
                   "R -5 35 -1.5", "F -5 35 -5", "R -5 35 2", "R 40 35 2", "R 40 0 2"}));
  // A shift across the hole would be a motion of the plane.
  EXPECT_EQ(mill("G41 D1 G1 X0 Y10\nG76 X0 Y30 Z-5 R2 Q1\n").error(), "fanuc-cycle-in-comp");
}

// fan-8-cancel
TEST(FanucComp, Cancel) {
  // With I J the end of the last block is the intersection with that line: from (40,30) along +X.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nX40\nG40 X60 Y0 I0 J-1\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 45 35 0", "F 60 0 0"}));
  // Without a motion the vector goes with the next one.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nX40\nG40\nZ5\nX60\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 40 35 0", "F 40 35 5", "F 60 30 5"}));
}

// fan-8-nomove
TEST(FanucComp, BlocksWithoutMotion) {
  const auto program = [](const std::string& between) {
    return "G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\n" + between + "X40\nG40 Y60\n";
  };
  const Lines bridged{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F 40 35 0", "F 40 60 0"};
  EXPECT_EQ(motions(program("")), bridged);
  EXPECT_EQ(motions(program("M8\n")), bridged);
  EXPECT_EQ(motions(program("G4 P100\n")), bridged);
  EXPECT_EQ(motions(program("F200\n")), bridged);
  EXPECT_EQ(motions(program("#100=5\n(TEXT)\n\nM8\n#101=6\n")), bridged);
  const Lines square{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F 40 35 0", "F 40 60 0"};
  EXPECT_EQ(motions(program("M8\nM9\n")), square);
  EXPECT_EQ(motions(program("G4 P100\nF50\n")), square);
  EXPECT_EQ(motions(program("G91 X0\nG90\n")), square);
  // Motions across the plane keep the vector: one is bridged, two are not.
  EXPECT_EQ(motions(program("Z-5\n")),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 35 0", "F -5 35 -5", "F 40 35 -5", "F 40 60 -5"}));
  EXPECT_EQ(motions(program("Z-5\nZ-6\n")), (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F -5 30 -5",
                                                   "F -5 30 -6", "F 40 35 -6", "F 40 60 -6"}));
  // Behind the start-up block: square to it.
  EXPECT_EQ(motions("G0 X-20 Y0\nG41 D1 G1 X0 Y0\nM8\nM9\nY30\nX40\nG40 Y60\n"),
            (Lines{"R -20 0 0", "F 0 5 0", "F -5 35 0", "F 40 35 0", "F 40 60 0"}));
  // A call and its return are none.
  EXPECT_EQ(IsoRun(ControlId::kFanucMill,
                   "O1\nG21 G90 G17 F100\nG10 L12 P1 R5\nG0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nM98 P2\nM98 P2\n"
                   "X40\nG40 Y60\nM30\nO2\nM99\n")
                .motions(),
            bridged);
}

// fan-8-dchange fan-8-inside
TEST(FanucComp, OtherRadii) {
  // The new vector stands at the end of the block that names D.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nD2 Y60\nX40\nG40 Y90\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F -3 63 0", "F 40 63 0", "F 40 90 0"}));
  // Data of the active D act with the next vector.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG10 L12 P1 R3\nY60\nX40\nG40 Y90\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F -3 63 0", "F 40 63 0", "F 40 90 0"}));
  // A negative radius swaps the sides.
  EXPECT_EQ(motions("G0 X0 Y-20\nG42 D3 G1 X0 Y0\nY30\nX40\nG40 Y90\n"),
            motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nX40\nG40 Y90\n"));
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D0 G1 X0 Y0\nY30\nX40\nG40 Y90\n"),
            (Lines{"R 0 -20 0", "F 0 0 0", "F 0 30 0", "F 40 30 0", "F 40 90 0"}));
}

// fan-8-sidechange fan-8-G42
TEST(FanucComp, ChangeOfSide) {
  // Lines at right angles: the point where both offsets meet.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG42 X40\nG40 Y90\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 25 0", "F 40 25 0", "F 40 90 0"}));
  // In one line: from square to square.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG42 Y60\nG40 X40\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F 5 30 0", "F 5 60 0", "F 40 60 0"}));
  // Back along the same line: the tool stays on its side.
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG42 Y0\nG40 X40\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "F -5 0 0", "F 40 0 0"}));
}

// fan-8-G39
TEST(FanucComp, CornerArc) {
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG39\nX40\nG40 Y90\n"),
            (Lines{"R 0 -20 0", "F -5 0 0", "F -5 30 0", "A 0 35 0 c 0 30 0 -90", "F 40 35 0", "F 40 90 0"}));
  EXPECT_EQ(motions("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG39 I1 J0\nX40\nG40 Y90\n")[3],
            "A 0 35 0 c 0 30 0 -90");
}

// fan-8-dmissing
TEST(FanucComp, MissingD) {
  const std::string body = "T7 M6\nG0 X0 Y-20\nG41 D9 G1 X0 Y0\nY30\nG40 X-20\n";
  const IsoRun own = mill(body);
  EXPECT_EQ(own.motions()[1], "F -4 0 0");
  EXPECT_TRUE(own.tells("fanuc-offset-missing"));
  const IsoRun none = mill(body, {{"d_default", 1}});
  EXPECT_EQ(none.motions()[1], "F 0 0 0");
  EXPECT_TRUE(none.tells("fanuc-offset-missing"));
  EXPECT_EQ(mill("G41 D1000 G1 X5\n").error(), "fanuc-030");
}

// fan-8-feed: F is of the tool centre, inside arcs and outside.
TEST(FanucComp, FeedIsOfTheCentre) {
  const IsoRun run = mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY20\nG3 X-10 Y30 R10\nG1 X-40\nG40 Y60\n");
  ASSERT_EQ(run.error(), "");
  for (const Motion& m : run.path.motions) {
    if (m.arc >= 0) EXPECT_DOUBLE_EQ(m.feed, 100.0);
  }
}

// fan-8-G41.1
TEST(FanucComp, NormalDirectionIsNoted) {
  const IsoRun run = mill("G41.1 G1 X10\nY10\nG40.1\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_TRUE(run.tells("fanuc-normal-direction"));
  EXPECT_EQ(run.motions(), (Lines{"F 10 0 0", "F 10 10 0"}));
}

TEST(FanucComp, ReferenceInCompensation) {
  // Without the vector to the intermediate point; the next block is a start-up again.
  const IsoRun run = mill("G0 X0 Y-20\nG41 D1 G1 X0 Y0\nY30\nG91 G28 Z0\nG90 X40\nY0\nG40 X60\n");
  EXPECT_EQ(run.error(), "") << run.message();
  const Lines all = run.motions();
  EXPECT_EQ(all[all.size() - 3], "F 45 30 0");
}

TEST(FanucComp, OtherPlanes) {
  EXPECT_EQ(motions("G18 G0 Z-20\nG41 D1 G1 X0 Z0\nZ30\nX40\nG40 Z60\n").back(), "F 40 0 60");
  EXPECT_EQ(motions("G18 G0 Z-20\nG41 D1 G1 X0 Z0\nZ30\nX40\nG40 Z60\n")[1], "F 5 0 0");
}

}  // namespace
}  // namespace fanuc_comp_test
}  // namespace proveout::test
