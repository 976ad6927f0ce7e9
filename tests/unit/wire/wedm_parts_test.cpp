// Programs of the wire EDM control down to the section that the wire leaves, against the closed forms of the
// constructed tests of the digest wedm, D14. Contours of one corner are closed to parts that have no other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "removal/process/wire_piece.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

constexpr double kThickness = 10.0;
/// Of areas, mm2: some hundredths of a millimetre of contour, where an arc begins, lie at 0.0001 mm.
constexpr double kWithin = 2e-5;

/// Areas of the bodies that a program leaves of a plate of 120 x 120, mm2, the largest first.
struct Cut {
  std::vector<double> areas;
  std::string error;

  /// `kerf_mm`: half the width of the kerf.
  Cut(const std::string& text, double kerf_mm) {
    Toolpath path;
    ToolpathBuilder builder(path);
    ControlSettings settings;
    settings.parameters = {{"T", kThickness}, {"H.1", kerf_mm}};
    interpret(ControlId::kWedm, MemoryProgramSource("main.nc", "T84 T86; C001; " + text + " M02;"), settings,
              builder);
    for (const Diagnostic& d : path.diagnostics.all()) {
      if (d.severity == Severity::kError) error += d.code + " ";
    }
    if (error.empty()) remove(path, kerf_mm);
  }

 private:
  void remove(const Toolpath& path, double kerf_mm) {
    Tool wire;
    wire.number = 1;
    wire.type = ToolType::kWire;
    wire.diameter = 2 * kerf_mm - 0.02;
    wire.spark_gap = 0.01;
    const Result<PrismBlank> blank = prismOf(BoxShape{{-60, -60, 0}, {60, 60, kThickness}});
    ASSERT_TRUE(blank.ok());
    WirePiece piece{WireStock(*blank)};
    Progress progress;
    const Result<Machined> made = piece.machine(path, {wire}, {}, progress);
    ASSERT_TRUE(made.ok()) << made.error().message;
    for (const StockBody& body : *made->bodies) areas.push_back(body.volume_mm3 / kThickness);
  }
};

/// The plate less its largest body: what a contour cuts out of it, kerf and all.
double holeOf(const Cut& cut) { return 120.0 * 120.0 - cut.areas.at(0); }
/// Of what is within `distance` of a convex polygon.
double grown(double area, double perimeter, double distance) {
  return area + perimeter * distance + kPi * distance * distance;
}
double triangle(double side) { return std::sqrt(3.0) / 4.0 * side * side; }
double hexagon(double side) { return 6.0 * triangle(side); }

/// From the middle of the lower side round a regular polygon of side 10 with a corner at (10, 0), counter-
/// clockwise, and out again. The wire comes from `y`, outside or inside.
std::string polygon(int corners, const std::string& codes, double y) {
  std::string text = "G92 X5. Y" + std::to_string(y) + "; " + codes + " H001 G01 Y0; ";
  Vec2 at(0, 0);
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * kPi * k / corners;
    at += 10.0 * Vec2(std::cos(angle), std::sin(angle));
    points.push_back(at);
  }
  const auto word = [](double value) { return fmt::format("{:.10f}", value); };
  for (const Vec2& p : points) text += "X" + word(p.x()) + " Y" + word(p.y()) + "; ";
  return text + "X5.; G40 Y" + std::to_string(y) + ";";
}

// K1, K2. Rows: wedm-5.6.3-joins wedm-5.5.2-G28 wedm-5.5.2-G29
TEST(WedmParts, AcuteCornersOfAPunch) {
  const Cut round(polygon(3, "G28 G42", -80), 0.5), straight(polygon(3, "G29 G42", -80), 0.5);
  for (const Cut* cut : {&round, &straight}) {
    ASSERT_EQ(cut->areas.size(), 2u) << cut->error;
    EXPECT_NEAR(cut->areas[1], triangle(10), kWithin) << "the corners stay sharp";
  }
  // The lead-in is a slot from the border of the plate to the hole.
  const double slot = 1.0 * (60 - 1.0);
  EXPECT_NEAR(holeOf(round) - slot, grown(triangle(10), 30, 1.0), kWithin);
  // The wire's way is a triangle less the tips that G29 cuts off.
  const double whole = 10 + std::sqrt(3.0), tip = (whole - 11) / 2;
  EXPECT_NEAR(holeOf(straight) - slot, grown(triangle(whole) - 3 * triangle(tip), 3 * (11 + tip), 0.5),
              kWithin);
}

// K3, K4. Rows: wedm-5.6.3-joins wedm-5.5.2-G29
TEST(WedmParts, ObtuseCornersOfAPunchAndADie) {
  const Cut punch(polygon(6, "G29 G42", -80), 0.5), die(polygon(6, "G41", 8), 0.5);
  ASSERT_EQ(punch.areas.size(), 2u) << punch.error;
  EXPECT_NEAR(punch.areas[1], hexagon(10), kWithin);
  const double outer = 10 + 1 / std::sqrt(3.0), inner = 10 - 1 / std::sqrt(3.0);
  EXPECT_NEAR(holeOf(punch) - 59.0, grown(hexagon(outer), 6 * outer, 0.5), kWithin);
  ASSERT_EQ(die.areas.size(), 2u) << die.error;
  EXPECT_NEAR(holeOf(die), grown(hexagon(inner), 6 * inner, 0.5), kWithin);
}

/// Between a line and a circle of radius 5 about a point on it, outside of the circle, filled by a radius.
double fillet(double radius) {
  const double along = std::sqrt((5 + radius) * (5 + radius) - radius * radius);
  const double angle = std::atan2(radius, along);
  return 0.5 * (along * radius - 25 * angle - radius * radius * (kPi / 2 - angle));
}

/// A part below or above the line of K5 and K6 with a half disc on it, 30 x 10.
std::string bridge(bool below, const std::string& corner) {
  const std::string far = below ? "-10." : "10.", middle = below ? "-5." : "5.";
  return "G92 X-80. Y" + middle + "; " + (below ? "G41" : "G42") + " H001 G01 X0; Y0; X10." + corner +
         "; G02 X20. I5." + corner + "; G01 X30.; Y" + far + "; X0; Y" + middle + "; G40 X-80.;";
}

// K5, K6, K10. Rows: wedm-5.6.3-joins wedm-14-R
TEST(WedmParts, LinesAndArcs) {
  const double half = kPi * 25 / 2;
  const Cut bump(bridge(true, ""), 0.5), dent(bridge(false, ""), 0.5), rounded(bridge(true, " R2."), 0.5);
  for (const Cut* cut : {&bump, &dent, &rounded}) ASSERT_EQ(cut->areas.size(), 2u) << cut->error;
  EXPECT_NEAR(bump.areas[1], 300 + half + 2 * fillet(0.5), kWithin) << "the kerf leaves its own radius";
  EXPECT_NEAR(dent.areas[1], 300 - half, kWithin);
  EXPECT_NEAR(rounded.areas[1], 300 + half + 2 * fillet(2.0), kWithin);
}

std::string squareHole(const std::string& overcut) {
  return "G92X1.5Y1.5;G42H000;G01Y1.;G01Y0;G42H001;" + overcut + "X0;Y3.;X3.;Y0;X1.5;G36;G40G01Y1.;";
}

// K7, K8. Row: wedm-5.5.5-G37
TEST(WedmParts, CornersOfADie) {
  const double r = 0.11;
  EXPECT_NEAR(holeOf(Cut(squareHole(""), r)), 9 - (4 - kPi) * r * r, kWithin);
  // What a spike takes behind the corner: the half disc about its tip, with what the kerf's sides leave of
  // the walls, less the square between the tip and the corner.
  const double tip = r - 0.05 / std::sqrt(2.0), side = r * std::sqrt(2.0), arm = r / std::sqrt(2.0);
  const std::vector<Vec2> loop{{0, 0}, {0, side}, {tip - arm, tip + arm}, {tip + arm, tip - arm}, {side, 0}};
  double gouge = kPi * r * r / 2;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
    gouge += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_GT(gouge, 0.0);
  EXPECT_NEAR(holeOf(Cut(squareHole("G37X50;"), r)), 9 + 4 * gouge, kWithin);
}

std::string roundedSquare(const std::string& code, const std::string& away) {
  return "G92 X" + away + " Y5.; " + code + " H001 G01 X0; Y0 R2.; X10. R2.; Y10. R2.; X0 R2.; Y5.; G40 X" +
         away + ";";
}

// K9. Row: wedm-14-R
TEST(WedmParts, RoundedCorners) {
  const double area = 100 - (4 - kPi) * 4;
  const Cut punch(roundedSquare("G42", "-80."), 0.1), die(roundedSquare("G41", "5."), 0.1);
  ASSERT_EQ(punch.areas.size(), 2u) << punch.error;
  EXPECT_NEAR(punch.areas[1], area, kWithin);
  ASSERT_EQ(die.areas.size(), 2u) << die.error;
  EXPECT_NEAR(holeOf(die), area, kWithin);
}

// K19, K20. Row: wedm-5.6.7-overcut
TEST(WedmParts, WhereTheWireDoesNotFit) {
  EXPECT_EQ(Cut("G92 X0 Y0; G41 H001 G01 X1.; G03 X1. I-1.; G40 G01 X0;", 1.2).error, "wedm-5.6.7-overcut ");
  const std::string slot = "G92 X-5. Y80.; G41 H001 G01 X0 Y80.; Y0; X2.; Y80.; G40 X9.;";
  EXPECT_EQ(Cut(slot, 1.2).error, "wedm-5.6.7-overcut ");
  // One slot of 2 mm, the corners of which have the kerf's radius.
  const Cut fits(slot, 0.9);
  EXPECT_EQ(fits.error, "");
  ASSERT_EQ(fits.areas.size(), 1u);
  EXPECT_NEAR(holeOf(fits), 2 * 60 - (4 - kPi) / 2 * 0.9 * 0.9, kWithin);
}

}  // namespace
}  // namespace proveout
