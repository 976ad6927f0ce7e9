// Tapers that change within a contour (wire EDM manual 7.5; digest wedm, D7.4, D7.6), and what wires cannot
// do.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "wedm_path.h"

namespace proveout::test {
namespace {

constexpr double kClose = 1e-6;  ///< mm
/// What a wire that leans by 5 degrees goes aside in the secondary plane, 20 mm above the main one.
const double kLean = 20.0 * std::tan(degToRad(5.0));

ControlSettings plate(double h1 = 0.0) {
  ControlSettings settings;
  settings.parameters = {{"T", 20.0}, {"H.1", h1}};
  return settings;
}

/// From (2, 3) to the lower side of a square of 10, along it with `blocks`, and round the rest upright.
WedmPath square(const std::string& blocks, double h1 = 0.0, const std::string& side = "G41") {
  return WedmPath("T84 T86; C001; G90 G92 X2. Y3.; G52 A0 " + side + " H001 G01 X2. Y0; " + blocks +
                      " G52 A0 Y10.; X0; Y0; X2.; G40 G50 A0 Y3.; M02;",
                  plate(h1));
}

void expectEnds(const std::vector<Vec2>& got, const std::vector<Vec2>& wanted) {
  ASSERT_GE(got.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    EXPECT_LT((got[k] - wanted[k]).norm(), kClose) << k << ": " << got[k].x() << " " << got[k].y();
}

/// Every motion begins where the one before has ended, in both planes.
void expectUnbroken(const WedmPath& run) {
  for (std::size_t k = 1; k < run.count(); ++k) {
    EXPECT_LT((run.wire(k).lower.from - run.wire(k - 1).lower.to).norm(), kClose) << k;
    EXPECT_LT((run.wire(k).upper.from - run.wire(k - 1).upper.to).norm(), kClose) << k;
  }
}

TEST(WedmTaper, ChangesOnTheSpotBetweenCollinearLinesWithoutAnOffset) {
  const WedmPath run = square("G52 A0 X5.; G52 A5. X10.;");
  EXPECT_EQ(run.error(), "");
  EXPECT_TRUE(run.warns("wedm-7.5-tilt"));
  expectEnds(run.ends(), {{2, 0}, {5, 0}, {5, 0}, {10, 0}, {10, 10}});
  expectEnds(run.ends(true), {{2, 0}, {5, 0}, {5, -kLean}, {10, -kLean}, {10, 10}});
  expectUnbroken(run);
}

TEST(WedmTaper, ChangesBackAndToTheOtherSideOnTheSpot) {
  const double two = 20.0 * std::tan(degToRad(2.0));
  const WedmPath less = square("G52 A5. X5.; G52 A2. X10.;");
  expectEnds(less.ends(true), {{2, -kLean}, {5, -kLean}, {5, -two}, {10, -two}, {10, 10}});
  expectUnbroken(less);
  const WedmPath other = square("G52 A5. X5.; G51 A2. X10.;");
  expectEnds(other.ends(true), {{2, -kLean}, {5, -kLean}, {5, two}, {10, two}, {10, 10}});
  expectUnbroken(other);
  const WedmPath none = square("G52 A5. X5.; G52 A0 X10.;");
  expectEnds(none.ends(true), {{2, -kLean}, {5, -kLean}, {5, 0}, {10, 0}, {10, 10}});
  expectUnbroken(none);
}

TEST(WedmTaper, ChangesOnTheSpotWithAnOffsetOnEitherSide) {
  for (const char* side : {"G41", "G42"}) {
    const double off = side[2] == '1' ? 0.1 : -0.1;
    const WedmPath run = square("G52 A0 X5.; G52 A5. X10.;", 0.1, side);
    EXPECT_EQ(run.error(), "") << side;
    expectEnds(run.ends(), {{2, off}, {5, off}, {5, off}});
    expectEnds(run.ends(true), {{2, off}, {5, off}, {5, off - kLean}});
    expectUnbroken(run);
  }
  // Also where the change is smaller than the offset.
  EXPECT_EQ(square("G52 A0 X5.; G52 A0.2 X10.;", 0.1).error(), "");
  EXPECT_EQ(square("G52 A0.2 X5.; G51 A0.2 X10.;", 0.1).error(), "");
}

/// Points of one slanted line, rounded, with an offset that stays or changes.
TEST(WedmTaper, OffsetsOfRoundedPointsOfOneLine) {
  const std::string line = "T84 T86; C001; H002=150; G90 G92 X2. Y3.; G52 A0 G41 H001 G01 X3. Y0.3; ";
  const std::string end = " X20. Y2.; G40 G50 A0 Y10.; M02;";
  for (const char* middle : {"X6.667 Y0.667;", "X6.667 Y0.666;", "X6.666 Y0.667;"}) {
    for (const char* change : {" G52 A5.", " G41 H002", " G41 H002 G52 A5."}) {
      const WedmPath run(line + "G52 A0 " + middle + change + end, plate(0.1));
      EXPECT_EQ(run.error(), "") << middle << change;
      expectUnbroken(run);
      for (std::size_t k = 0; k < run.count(); ++k)
        EXPECT_LT(run.wire(k).upper.to.norm(), 25.0) << middle << change << k;
    }
  }
}

/// An overcut on either side of the change is found.
TEST(WedmTaper, ChangesOnTheSpotHideNoOvercut) {
  EXPECT_EQ(square("G52 A0 X5.; G52 A5. X9.; G03 X9.2 Y0.2 J0.2; G01 X9.4 Y0.2; Y5.;", 0.5).error(),
            "wedm-5.6.7-overcut");
}

/// CAM writes points of one slanted line to a thousandth: its pieces are collinear to within that alone.
TEST(WedmTaper, TakesRoundedPointsOfOneLineForCollinear) {
  for (const char* middle : {"X6.667 Y0.667", "X6.667 Y0.666", "X6.666 Y0.667"}) {
    const WedmPath run("T84 T86; C001; G90 G92 X2. Y3.; G52 A0 G41 H001 G01 X3. Y0.3; G52 A0 " +
                           std::string(middle) + "; G52 A5. X20. Y2.; G40 G50 A0 Y10.; M02;",
                       plate());
    EXPECT_EQ(run.error(), "") << middle;
    EXPECT_TRUE(run.warns("wedm-7.5-tilt")) << middle;
    expectUnbroken(run);
    // The upper point stays beside the lower one.
    for (std::size_t k = 0; k + 1 < run.count(); ++k)
      EXPECT_LT((run.wire(k).upper.to - run.wire(k).lower.to).norm(), kLean + 1e-3) << middle << " " << k;
  }
}

TEST(WedmTaper, CannotChangeWhereAnArcGoesOnTangentially) {
  const WedmPath run = square("G52 A0 X5.; G52 A5. G03 X10. Y5. J5.; G01");
  EXPECT_EQ(run.error(), "wedm-7.5-error");
}

/// A corner with an arc has the point in which the shifted elements meet.
TEST(WedmTaper, ChangesAtACornerWithAnArc) {
  const WedmPath run(
      "T84 T86; C001; G90 G92 X0 Y-3.; G52 A0 G41 H001 G01 X0 Y0; G52 A0 X10.; "
      "G52 A5. G02 X20. I5.; G52 A0 G01 X30.; G40 G50 A0 Y-3.; M02;",
      plate());
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  // The arc about (15, 0), clockwise, leans to the right: a smaller circle above.
  const double r = 5.0 - kLean;
  EXPECT_NEAR((run.wire(2).upper.from - Vec2(15, 0)).norm(), r, kClose);
  EXPECT_NEAR(run.wire(2).upper.from.y(), 0.0, kClose) << "on the line, which does not lean";
  expectUnbroken(run);
}

TEST(WedmTilt, EndsBeyond45DegreesUnlessTheMachineLeansFarther) {
  const std::string lean = "G92X0Y0U0V0;G74;G01X9.U25.;X20.U0;G75;M02;";
  ControlSettings settings = plate();
  const WedmPath refused("T84T86;C001;" + lean, settings);
  EXPECT_EQ(refused.error(), "wedm-tilt");
  EXPECT_NE(refused.first(Severity::kError).message.find("51.340 degrees"), std::string::npos)
      << refused.first(Severity::kError).message;
  settings.parameters["MAX_TILT"] = 60;
  EXPECT_EQ(WedmPath("T84T86;C001;" + lean, settings).error(), "");
  const std::string shapes = "T84T86;C001;\nG92X0Y0;\nG61;\nG01X1.Y0:G01X25.Y0;\nG60;\nM02;\n";
  EXPECT_EQ(WedmPath(shapes, plate()).error(), "wedm-tilt");
}

TEST(WedmArcs, EndWhereNoMachineGets) {
  const std::string head = "T84T86;C001;\nG92X-18.Y0;\nG01X-10.;\n";
  for (const char* arc : {"G02 I9999.;", "G03 J-99999.;", "G03 X-10. Y0.01 I2000.;"}) {
    const WedmPath run(head + arc + "\nM02;\n");
    EXPECT_EQ(run.error(), "wedm-5.3-far") << arc;
  }
  EXPECT_EQ(WedmPath(head + "G02 I900.;\nM02;\n").error(), "");
  // Flat arcs have large radii.
  EXPECT_EQ(WedmPath(head + "G02 X10. I10. J-50000.;\nM02;\n").error(), "");
}

TEST(WedmComments, AreClosedWhereTheTextEnds) {
  const std::string head = "T84T86;C001;\nG92X0Y0;\nG01X1.;\n";
  for (const char* end : {"M02 (open;", "M02;(open", "M02;\n(open", "M02;\n\nN0001 (open;\nX2.;\nM99;"}) {
    const WedmPath run(head + end, plate());
    EXPECT_EQ(run.error(), "wedm-syntax") << end;
    EXPECT_NE(run.first(Severity::kError).message.find("not closed"), std::string::npos) << end;
  }
  EXPECT_EQ(WedmPath(head + "M02;\n(of the (plate);\n", plate()).error(), "");
}

}  // namespace
}  // namespace proveout::test
