// Pieces that come free: when, and what they are.
#include "removal/wire/falls/wire_falls.h"

#include <gtest/gtest.h>

#include "removal/wire/falls/fixture_solid.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

using test::lineWay;

constexpr double kKerf = 0.11;
const std::vector<PlaneLoop> kPlate{rectangleLoop({-20, -20}, {20, 20})};

/// A square of side 2 `half` about a place, from the middle of its left side; motions count on.
void addSquare(std::vector<WireStretch>& way, const Vec2& at, double half) {
  Vec2 from = at + Vec2(-half, 0);
  for (const Vec2& to :
       {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half), Vec2(-half, 0)}) {
    way.push_back(lineWay(from, at + to, kKerf, static_cast<MotionId>(way.size())));
    from = at + to;
  }
}

WireFalls fallsOf(const std::vector<WireStretch>& way, const PlanePolygons& fixtures = {}) {
  std::vector<PlaneBody> last = cutSection(kPlate, way);
  const WireHolding holding(fixtures, kPlate, way, last);
  return findFalls(kPlate, way, std::move(last), holding);
}

TEST(WireFalls, ASlugFallsWhenItsCutIsClosed) {
  std::vector<WireStretch> way;
  addSquare(way, {-8, 0}, 5);
  addSquare(way, {8, 0}, 3);
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 2u);
  EXPECT_EQ(falls.pieces[0].closed + 1, 5u);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, 9.78 * 9.78, 1e-6);
  EXPECT_FALSE(falls.pieces[0].passed_over);
  EXPECT_EQ(falls.pieces[1].closed + 1, 10u);
  EXPECT_NEAR(falls.pieces[1].body.area_mm2, 5.78 * 5.78, 1e-6);
  EXPECT_EQ(falls.bodies.size(), 3u);
}

/// The plate is parted at x = -4: the right part is the larger one and stays, the left one falls. That the
/// right one is then cut in two smaller ones changes nothing about that.
TEST(WireFalls, WhatIsHeldIsToldWhenItParts) {
  std::vector<WireStretch> way{lineWay({-4, -21}, {-4, 21}, kKerf, 0)};
  const WireFalls before = fallsOf(way);
  ASSERT_EQ(before.pieces.size(), 1u);
  EXPECT_LT(before.pieces[0].body.loops.front().edges.front().from.x(), 0.0);
  way.push_back(lineWay({21, 0}, {-10, 0}, kKerf, 1));
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 2u);
  EXPECT_EQ(falls.pieces[0].closed + 1, 1u);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, before.pieces[0].body.area_mm2, 1e-9);
  EXPECT_TRUE(falls.pieces[0].passed_over);
  EXPECT_EQ(falls.pieces[1].closed + 1, 2u);
  EXPECT_EQ(falls.bodies.size(), 3u);
}

TEST(WireFalls, WhatFellIsNotCutAnyMore) {
  std::vector<WireStretch> way;
  addSquare(way, {0, 0}, 5);
  way.push_back(lineWay({-5, 0}, {5, 0}, kKerf, 5));  // in two
  way.push_back(lineWay({5, 0}, {5.5, 0}, kKerf, 6));
  EXPECT_EQ(cutSection(kPlate, way).size(), 3u);
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 1u);
  EXPECT_EQ(falls.pieces[0].closed + 1, 5u);
  EXPECT_TRUE(falls.pieces[0].passed_over);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, 9.78 * 9.78, 5e-6);
  ASSERT_EQ(falls.bodies.size(), 2u);
  // The frame has the cut that left it behind.
  const double hole = 10.22 * 10.22 - (4 - kPi) * kKerf * kKerf;
  EXPECT_LT(falls.bodies[0].area_mm2, 1600 - hole - 2 * kKerf * 0.35);
}

/// The plate in three: the first piece hung on the second one, which falls later.
TEST(WireFalls, APieceThatHungOnOneThatFellLater) {
  const std::vector<WireStretch> way{lineWay({-21, 15}, {-18, 15}, kKerf, 0),
                                     lineWay({-5, -21}, {-5, 21}, kKerf, 1),
                                     lineWay({3, -21}, {3, 21}, kKerf, 2)};
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 2u);
  EXPECT_EQ(falls.pieces[0].closed + 1, 2u);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, 40 * (15 - kKerf) - 4 * kKerf - 0.5 * kPi * kKerf * kKerf, 1e-6);
  EXPECT_EQ(falls.pieces[1].closed + 1, 3u);
  EXPECT_NEAR(falls.pieces[1].body.area_mm2, 40 * (8 - 2 * kKerf), 1e-6);
  EXPECT_EQ(falls.bodies.size(), 3u);
}

TEST(WireFalls, ATrimmedPunchKeepsItsFirstCut) {
  std::vector<WireStretch> way;
  addSquare(way, {0, 0}, 5);
  addSquare(way, {0, 0}, 4.95);
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 1u);
  EXPECT_EQ(falls.pieces[0].closed + 1, 5u);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, 9.78 * 9.78, 1e-6);
}

TEST(WireFalls, AClampHoldsThePunchAndTheFrameFalls) {
  std::vector<WireStretch> way;
  addSquare(way, {0, 0}, 5);
  const SurfaceMesh clamp = solidOf(BoxShape{{-1, -1, 20}, {1, 1, 30}});
  const WireFalls falls = fallsOf(way, footprintOf(clamp, -kHeldWithinMm, 20 + kHeldWithinMm));
  ASSERT_EQ(falls.pieces.size(), 1u);
  EXPECT_NEAR(falls.pieces[0].body.area_mm2, 1600 - 10.22 * 10.22 + (4 - kPi) * kKerf * kKerf, 1e-6);
  // One above it does not.
  const SurfaceMesh above = solidOf(BoxShape{{-1, -1, 20.1}, {1, 1, 30}});
  EXPECT_TRUE(footprintOf(above, -kHeldWithinMm, 20 + kHeldWithinMm).empty());
}

TEST(WireFalls, ClampsAtTheSideAndInCorners) {
  const std::vector<PlaneBody> plate = cutSection(kPlate, {});
  const auto held = [&](const BoxShape& box) {
    return WireHolding(footprintOf(solidOf(box), 0, 20), kPlate, {}, plate).byFixtures();
  };
  EXPECT_TRUE(held({{20, -5, 5}, {25, 5, 15}}));
  EXPECT_TRUE(held({{20.009, -5, 5}, {25, 5, 15}}));
  EXPECT_FALSE(held({{20.02, -5, 5}, {25, 5, 15}}));
  EXPECT_TRUE(held({{20, 20, 5}, {25, 25, 15}}));
  EXPECT_FALSE(held({{20, -5, 21}, {25, 5, 30}}));
  EXPECT_TRUE(held({{-30, -30, 20}, {30, 30, 25}})) << "a plate over all of it";
}

TEST(WireFalls, GoingOnThroughTheSlug) {
  std::vector<WireStretch> way;
  addSquare(way, {0, 0}, 5);
  way.push_back(lineWay({-5, 0}, {-8, 0}, kKerf, 5));
  way.push_back(lineWay({-8, 0}, {0, 0}, kKerf, 6));
  const WireFalls falls = fallsOf(way);
  ASSERT_EQ(falls.pieces.size(), 1u);
  EXPECT_EQ(firstThrough(falls.pieces[0], way, 7), 6u);
  EXPECT_EQ(firstThrough(falls.pieces[0], way, 6), 6u) << "a stop before it";
}

TEST(WireFalls, NothingFallsWhereABridgeIsLeft) {
  std::vector<WireStretch> way;
  addSquare(way, {0, 0}, 5);
  way.back().to = Vec2(-5, 1);
  const WireFalls falls = fallsOf(way);
  EXPECT_TRUE(falls.pieces.empty());
  EXPECT_EQ(falls.bodies.size(), 1u);
}

}  // namespace
}  // namespace proveout
