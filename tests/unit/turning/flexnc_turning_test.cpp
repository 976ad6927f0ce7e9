// The examples of the FlexNC manual as whole programs, run on the control and turned: what they take.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "tests/unit/nc/flexnc_call.h"
#include "tests/unit/nc/flexnc_examples.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

/// Of the volume, mm^3 of mm^3.
constexpr double kShare = 1e-5;
constexpr double kPrinted = 0.05;  ///< mm^3

Toolpath pathOf(const std::string& blocks, const std::map<std::string, double>& parameters = {}) {
  ControlSettings settings;
  settings.parameters = parameters;
  settings.start = Vec3(150, 0, 100);
  Toolpath path;
  ToolpathBuilder builder(path);
  const std::string text = "T1M06D1\nS300M03\nG98F100\n" + blocks + "\nG81X300Z100\nM02\n";
  const InterpretSummary summary =
      interpret(ControlId::kFlexNc, MemoryProgramSource("main.nc", text), settings, builder);
  for (const Diagnostic& d : path.diagnostics.all()) EXPECT_NE(d.severity, Severity::kError) << d.message;
  EXPECT_TRUE(summary.ok());
  return path;
}

/// mm^3 that the path takes off the blank; nothing may be touched at rapid.
double taken(const Toolpath& path, const CylinderShape& blank, const Insert& insert) {
  Result<TurnedStock> stock = TurnedStock::create(blank);
  EXPECT_TRUE(stock);
  Progress progress;
  const auto summary = stock->remove(path, {insertTool(1, insert)}, progress);
  EXPECT_TRUE(summary);
  for (const Contact& contact : summary->contacts) EXPECT_LT(contact.depth_mm, 1e-3) << contact.motion;
  const TurnedShape shape = stock->shape();
  EXPECT_EQ(shape.bodies.size(), 1U);
  return stock->initialVolume() - shape.bodies.front().volume_mm3;
}

/// Small enough for the narrowest bore.
Insert sharp(int orientation) {
  Insert insert = turningInsert(0.0, orientation);
  insert.edge_length = 4.0;
  return insert;
}

class FlexncTurned : public testing::TestWithParam<test::FlexncRoughingExample> {};

// Rows: fnc-3.1-rough fnc-0-coord
TEST_P(FlexncTurned, TakesTheVolumeOfTheTable) {
  const test::FlexncRoughingExample& example = GetParam();
  const PlaneContour profile = test::contourOf(test::flexncAnswer(example.block));
  const double stock = profile.back().to.y(), end = profile.back().to.x();
  const double face = example.block.find("V15") == std::string::npos ? 0.0 : -15.0;
  const bool hole = example.row.starts_with("fnc-3.3");
  CylinderShape blank;
  blank.radius = hole ? profile.front().from.y() + 10.0 : stock;
  blank.inner_radius = hole ? stock : 0.0;
  blank.base = Vec3(0.0, 0.0, end - 10.0);
  blank.length = face - blank.base.z();
  const double volume = taken(pathOf(example.block), blank, sharp(hole ? 2 : 3));
  EXPECT_NEAR(volume, test::removedVolume(profile, face), kShare * volume);
  EXPECT_NEAR(volume, example.volume, kShare * volume + kPrinted);
}

// The contour block behind the roughing block takes nothing more: roughing has left its profile. Row:
// fnc-3.1-contour
TEST(FlexncTurnedContour, FindsNothingBehindRoughing) {
  const std::string rough = "G22.1X87Y19Z0R15U18G45P1C2B2V0", finish = "G22.1X87Y19R15U18G45P0C2K1";
  const CylinderShape blank = bar(43.5, 40.0);
  const double once = taken(pathOf(rough), blank, sharp(3));
  EXPECT_NEAR(taken(pathOf(rough + "\n" + finish), blank, sharp(3)), once, 1e-6 * once);
}

INSTANTIATE_TEST_SUITE_P(Shaft, FlexncTurned, testing::ValuesIn(test::flexncShaftExamples()));
INSTANTIATE_TEST_SUITE_P(Hole, FlexncTurned, testing::ValuesIn(test::flexncHoleExamples()));
INSTANTIATE_TEST_SUITE_P(Constructed, FlexncTurned, testing::ValuesIn(test::flexncConstructedExamples()));

// Volumes of the digest's chapter 10. Rows: fnc-3.6-G79 fnc-3.6-G79.1 fnc-3.6-G79.2
TEST(FlexncTurnedSpecial, FacesABar) {
  CylinderShape blank = bar(11.0, 30.0, 6.0);
  blank.length += 6.0;
  const double volume = taken(pathOf("G79X22Y12Z6P1C2B2"), blank, turningInsert(0.0));
  EXPECT_NEAR(volume / (kPi * (11.0 * 11.0 - 6.0 * 6.0) * 6.0), 1.0, kShare);
}

// The blade's point is its middle: a shift of the corrector puts the edge that is nearer to the axis there.
TEST(FlexncTurnedSpecial, CutsAFaceGroove) {
  Insert blade = grooveInsert(2.0, 0.0);
  blade.orientation = 7;
  const double volume = taken(pathOf("G79.2X80A60Z5P1B2V0H2Q0.8", {{"DXW.1", 1.0}}), bar(50.0, 30.0), blade);
  EXPECT_NEAR(volume / (kPi * (40.0 * 40.0 - 30.0 * 30.0) * 5.0), 1.0, kShare);
}

TEST(FlexncTurnedSpecial, CutsARadialGroove) {
  const double volume = taken(pathOf("G79.1X50A40H2P1C2Y8V13Q0.75"), bar(25.0, 60.0), grooveInsert(2.0, 0.0));
  EXPECT_NEAR(volume / (kPi * (25.0 * 25.0 - 20.0 * 20.0) * 8.0), 1.0, kShare);
}

}  // namespace
}  // namespace proveout
