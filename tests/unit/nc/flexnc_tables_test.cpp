// Templates of the FlexNC control against the tables 9.1 to 9.4 of the digest: profile, centers of arcs,
// start point, passes and the volume that they take. The rows that each example proves stand beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "flexnc_call.h"
#include "flexnc_examples.h"

namespace proveout {
namespace {

using nc::CycleAnswer;
using nc::CycleMove;
using test::contourOf;
using test::FlexncContourExample;
using test::FlexncRoughingExample;
using Role = CycleMove::Role;

constexpr double kPrinted = 0.0005001;      ///< mm; three digits behind the point
constexpr double kPrintedVolume = 0.05001;  ///< mm^3

/// "X,Z X,Z" with X a diameter, as (z, r).
std::vector<Vec2> points(const std::string& text) {
  std::istringstream in(text);
  std::vector<Vec2> out;
  double x = 0.0, z = 0.0;
  char mark = 0;
  while (in >> x >> mark >> z) out.emplace_back(z, x / 2.0);
  return out;
}

void expectPoints(const std::vector<Vec2>& got, const std::string& wanted) {
  const std::vector<Vec2> points_wanted = points(wanted);
  ASSERT_EQ(got.size(), points_wanted.size());
  for (std::size_t k = 0; k < got.size(); ++k) {
    EXPECT_NEAR(got[k].x(), points_wanted[k].x(), kPrinted) << "Z of point " << k;
    EXPECT_NEAR(2.0 * got[k].y(), 2.0 * points_wanted[k].y(), kPrinted) << "X of point " << k;
  }
}

std::vector<Vec2> cornersOf(const PlaneContour& contour) {
  std::vector<Vec2> out = {contour.front().from};
  for (const ContourElement& e : contour) out.push_back(e.to);
  return out;
}

std::vector<Vec2> centersOf(const PlaneContour& contour) {
  std::vector<Vec2> out;
  for (const ContourElement& e : contour) {
    if (e.arc) out.push_back(e.center);
  }
  return out;
}

/// Ends of the passes parallel to Z, in order.
std::vector<Vec2> passEnds(const CycleAnswer& answer) {
  std::vector<Vec2> ends;
  for (const CycleMove& move : answer.moves) {
    if (move.role == Role::kPass) ends.push_back(move.element.to);
  }
  return ends;
}

void expectChained(const std::vector<CycleMove>& moves) {
  for (std::size_t k = 1; k < moves.size(); ++k)
    EXPECT_LT((moves[k].element.from - moves[k - 1].element.to).norm(), 1e-12) << k;
}

/// `z_face`: where the volume begins.
void expectRoughing(const FlexncRoughingExample& example, double z_face) {
  const CycleAnswer answer = test::flexncAnswer(example.block);
  ASSERT_FALSE(answer.alarm) << answer.alarm->text;
  EXPECT_TRUE(answer.warnings.empty()) << answer.warnings.front().text;
  const PlaneContour contour = contourOf(answer);
  expectPoints(cornersOf(contour), example.profile);
  expectPoints(centersOf(contour), example.centers);
  expectPoints({answer.moves.front().element.to}, example.start);
  expectChained(answer.moves);
  const std::vector<Vec2> ends = passEnds(answer);
  ASSERT_EQ(static_cast<int>(ends.size()), example.passes);
  EXPECT_EQ(answer.passes, example.passes + 1);
  expectPoints({ends[0], ends[1], ends.back()}, example.ends);
  EXPECT_NEAR(test::removedVolume(contour, z_face), example.volume, kPrintedVolume);
}

class FlexncRoughing : public testing::TestWithParam<FlexncRoughingExample> {};

// Rows: fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-rough
TEST_P(FlexncRoughing, CutsWhatTheTableSays) {
  const FlexncRoughingExample& example = GetParam();
  SCOPED_TRACE(example.row + " " + example.block);
  expectRoughing(example, example.block.find("V15") == std::string::npos ? 0.0 : -15.0);
}

/// But the one whose profile begins in front of its start point.
std::vector<FlexncRoughingExample> wholeProfiles(std::vector<FlexncRoughingExample> examples) {
  std::erase_if(examples, [](const FlexncRoughingExample& e) { return e.row == "fnc-3.2-G13.5"; });
  return examples;
}

INSTANTIATE_TEST_SUITE_P(Shaft, FlexncRoughing,
                         testing::ValuesIn(wholeProfiles(test::flexncShaftExamples())));
INSTANTIATE_TEST_SUITE_P(Hole, FlexncRoughing, testing::ValuesIn(test::flexncHoleExamples()));
INSTANTIATE_TEST_SUITE_P(Constructed, FlexncRoughing, testing::ValuesIn(test::flexncConstructedExamples()));

// Row: fnc-3.2-G13.5. Its profile begins at Z5.142 and is cut from the start plane Z3 on, where the concave
// arc of radius 10 about (X28, Z5.142) has the diameter 2 (14 - sqrt(100 - 2.142^2)).
TEST(FlexncRoughingClipped, BeginsAtItsStartPlane) {
  const auto& examples = test::flexncShaftExamples();
  const auto found =
      std::find_if(examples.begin(), examples.end(), [](const auto& e) { return e.row == "fnc-3.2-G13.5"; });
  const CycleAnswer answer = test::flexncAnswer(found->block);
  ASSERT_FALSE(answer.alarm);
  ASSERT_EQ(answer.warnings.size(), 1U);
  EXPECT_EQ(answer.warnings.front().id, "fnc-z-front");
  const PlaneContour contour = contourOf(answer);
  const std::vector<Vec2> wanted = points(found->profile), got = cornersOf(contour);
  ASSERT_EQ(got.size(), wanted.size());
  const double ahead = wanted[0].x() - 3.0, entry = 14.0 - std::sqrt(100.0 - ahead * ahead);
  EXPECT_NEAR(got[0].x(), 3.0, 1e-9);
  EXPECT_NEAR(got[0].y(), entry, kPrinted);
  for (std::size_t k = 1; k < got.size(); ++k) EXPECT_LT((got[k] - wanted[k]).norm(), 2.0 * kPrinted);
  expectPoints(centersOf(contour), found->centers);
  EXPECT_EQ(static_cast<int>(passEnds(answer).size()), found->passes);
  const std::vector<Vec2> ends = passEnds(answer);
  expectPoints({ends[0], ends[1], ends.back()}, found->ends);
  EXPECT_NEAR(test::removedVolume(contour, 0.0), found->volume, kPrintedVolume);
}

struct UpExample {
  std::string block, centers, ends;
};

// What rotation words make where X is drawn upwards. Rows: fnc-3.2-G3.1 fnc-3.2-G12 fnc-3.2-G13 fnc-3.3-G12
// fnc-3.3-G13
TEST(FlexncRoughingUp, BendsTheOtherWay) {
  const std::vector<UpExample> examples = {
      {"G3.1X60A50R20Z10P1.5B2C2V0", "20.649,-13.588", "57,-5.242 54,-2.546 51,-0.561"},
      {"G12X60R20Z10P1.5C2B2V0", "60,-10", "57,-29.944 54,-29.774 21,-14.444"},
      {"G13X70R18Z0P1.5C2B2V0", "34,-18", "67,-10.806 64,-8.050 37,-0.063"},
      {"G12X60R20Z10P1.5C-2B2V0", "60,-10", ""},
      {"G13X20R18Z0P2C-3B2V0", "56,-18", ""}};
  for (const UpExample& example : examples) {
    SCOPED_TRACE(example.block);
    nc::CycleCall call = test::flexncCall(example.block);
    const CycleAnswer down = performCycle(call);
    call.arc_view = nc::ArcView::kXUp;
    const CycleAnswer up = performCycle(call);
    ASSERT_FALSE(up.alarm);
    expectPoints(centersOf(contourOf(up)), example.centers);
    EXPECT_EQ(passEnds(up).size(), passEnds(down).size());
    const double turned = contourOf(up)[0].sweep, before = contourOf(down)[0].sweep;
    EXPECT_NEAR(turned, -before, 1e-12);
    const std::vector<Vec2> ends = passEnds(up);
    if (!example.ends.empty()) expectPoints({ends[0], ends[1], ends.back()}, example.ends);
  }
}

// What the templates settle themselves does not depend on the view.
TEST(FlexncRoughingUp, LeavesCompoundTemplatesAlone) {
  for (const FlexncRoughingExample& example : test::flexncShaftExamples()) {
    if (example.row == "fnc-3.2-G3.1" || example.row == "fnc-3.2-G12" || example.row == "fnc-3.2-G13")
      continue;
    nc::CycleCall call = test::flexncCall(example.block);
    const CycleAnswer down = performCycle(call);
    call.arc_view = nc::ArcView::kXUp;
    const CycleAnswer up = performCycle(call);
    ASSERT_EQ(up.moves.size(), down.moves.size()) << example.block;
    for (std::size_t k = 0; k < up.moves.size(); ++k)
      EXPECT_EQ(up.moves[k].element.sweep, down.moves[k].element.sweep) << example.block;
  }
}

class FlexncContour : public testing::TestWithParam<FlexncContourExample> {};

// Rows: fnc-3.1-K fnc-3.1-contour
TEST_P(FlexncContour, FollowsWhatTheTableSays) {
  const FlexncContourExample& example = GetParam();
  SCOPED_TRACE(example.row + " " + example.block);
  const CycleAnswer answer = test::flexncAnswer(example.block);
  ASSERT_FALSE(answer.alarm) << answer.alarm->text;
  const PlaneContour contour = contourOf(answer);
  expectPoints(cornersOf(contour), example.profile);
  expectPoints(centersOf(contour), example.centers);
  expectChained(answer.moves);
}

// With K0 the same elements run from wherever the tool is. Row: fnc-3.1-K
TEST_P(FlexncContour, RunsInIncrements) {
  const FlexncContourExample& example = GetParam();
  SCOPED_TRACE(example.block);
  std::string block = example.block;
  block.replace(block.find("K1"), 2, "K0");
  const Vec2 at(-7.25, 31.5);
  nc::CycleCall call = test::flexncCall(block, at);
  call.chain = nc::ContourChain{};
  const CycleAnswer next = performCycle(call), first = test::flexncAnswer(example.block);
  ASSERT_FALSE(next.alarm) << next.alarm->text;
  const PlaneContour moved = contourOf(next), contour = contourOf(first);
  ASSERT_EQ(moved.size(), contour.size());
  const Vec2 shift = at - contour.front().from;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    EXPECT_LT((moved[k].from - contour[k].from - shift).norm(), 1e-12);
    EXPECT_LT((moved[k].to - contour[k].to - shift).norm(), 1e-12);
    if (moved[k].arc) {
      EXPECT_LT((moved[k].center - contour[k].center - shift).norm(), 1e-12);
    }
    EXPECT_EQ(moved[k].sweep, contour[k].sweep);
  }
  const Vec2 way = moved.back().to - at;
  expectPoints({way}, example.increments);
}

INSTANTIATE_TEST_SUITE_P(Examples, FlexncContour, testing::ValuesIn(test::flexncContourExamples()));

// Centers of the contours that turn with the view. Rows: fnc-3.4-G3.1 fnc-3.4-G12 fnc-3.4-G13 fnc-3.5-G12
TEST(FlexncContourUp, BendsTheOtherWay) {
  const std::vector<UpExample> examples = {{"G3.1X60A50R20Z10P0C2K1", "20.649,-13.588", ""},
                                           {"G12X40R15P0C2K1", "40,0", ""},
                                           {"G13X40R15P0C2K1", "10,-15", ""},
                                           {"G12X9R14P0C-2K1", "9,0", ""}};
  for (const UpExample& example : examples) {
    nc::CycleCall call = test::flexncCall(example.block);
    call.arc_view = nc::ArcView::kXUp;
    expectPoints(centersOf(contourOf(performCycle(call))), example.centers);
  }
}

}  // namespace
}  // namespace proveout
