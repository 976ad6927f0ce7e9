// Sections behind a wire against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "removal/wire/section/prism_mesh.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

using test::arcWay;
using test::closedWay;
using test::lineWay;
using test::totalArea;

constexpr double kKerf = 0.1;
const std::vector<PlaneLoop> kPlate = {rectangleLoop({-20, -20}, {20, 20})};
constexpr double kPlateArea = 1600.0;
const std::vector<Vec2> kSquare = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};

TEST(PlaneRegion, PointsAreRoundedAsMeshesHoldThem) {
  const Vec2 p = asFloat({0.1, 26.123456789});
  EXPECT_EQ(p.x(), static_cast<double>(0.1f));
  EXPECT_EQ(p.y(), static_cast<double>(26.123456789f));
}

TEST(KerfSection, WithoutAWireIsTheBlank) {
  const std::vector<PlaneLoop> tube = {circleLoop({3, 4}, 10, false), circleLoop({3, 4}, 6, true)};
  const std::vector<PlaneBody> bodies = cutSection(tube, {});
  ASSERT_EQ(bodies.size(), 1u);
  ASSERT_EQ(bodies[0].loops.size(), 2u);
  EXPECT_NEAR(bodies[0].area_mm2 / (kPi * 64), 1.0, 1e-12);
  EXPECT_EQ(bodies[0].loops[0].edges.size(), 1u);
}

TEST(KerfSection, StraightKerf) {
  const std::vector<PlaneBody> bodies = cutSection(kPlate, {lineWay({-5, 1}, {5, 2}, kKerf, 7)});
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_NEAR(kPlateArea - bodies[0].area_mm2, std::hypot(10, 1) * 2 * kKerf + kPi * kKerf * kKerf, 1e-7);
  ASSERT_EQ(bodies[0].loops.size(), 2u);
  EXPECT_EQ(bodies[0].loops[1].edges.size(), 4u);
  for (const PlaneEdge& edge : bodies[0].loops[1].edges) EXPECT_EQ(edge.motion, 7u);
}

TEST(KerfSection, PunchAndDie) {
  const std::vector<PlaneBody> bodies = cutSection(kPlate, closedWay(kSquare, kKerf));
  ASSERT_EQ(bodies.size(), 2u);
  // Corners of the hole are round, those of the punch sharp.
  EXPECT_NEAR(kPlateArea - bodies[0].area_mm2, 10.2 * 10.2 - (4 - kPi) * kKerf * kKerf, 1e-7);
  EXPECT_NEAR(bodies[1].area_mm2, 9.8 * 9.8, 1e-7);
  ASSERT_EQ(bodies[1].loops[0].edges.size(), 4u);
  std::set<MotionId> makers;
  for (const PlaneEdge& edge : bodies[1].loops[0].edges) {
    makers.insert(edge.motion);
    EXPECT_NEAR(edge.from.cwiseAbs().x(), 4.9, 1e-9);
    EXPECT_NEAR(edge.from.cwiseAbs().y(), 4.9, 1e-9);
  }
  EXPECT_EQ(makers, (std::set<MotionId>{0, 1, 2, 3}));
}

TEST(KerfSection, RoundedCornersKeepTheirRadii) {
  // A square of 10 with corners of radius 2, all the way round.
  std::vector<WireStretch> way;
  const Vec2 corners[] = {{3, -3}, {3, 3}, {-3, 3}, {-3, -3}};
  Vec2 at(-3, -5);
  MotionId motion = 0;
  for (const Vec2& center : corners) {
    const Vec2 to = center + turnedBy({0, -2}, 0.5 * kPi * (motion / 2));
    way.push_back(lineWay(at, to, kKerf, motion));
    way.push_back(arcWay(to, center, 0.5 * kPi, kKerf, motion + 1));
    at = way.back().to;
    motion += 2;
  }
  const auto rounded = [](double side, double radius) { return side * side - (4 - kPi) * radius * radius; };
  const std::vector<PlaneBody> bodies = cutSection(kPlate, way);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NEAR(kPlateArea - bodies[0].area_mm2, rounded(10.2, 2.1), 1e-6);
  EXPECT_NEAR(bodies[1].area_mm2, rounded(9.8, 1.9), 1e-6);
  EXPECT_EQ(bodies[1].loops[0].edges.size(), 8u);
  EXPECT_EQ(bodies[0].loops[1].edges.size(), 8u);
}

TEST(KerfSection, RoundDieAndArcsSmallerThanTheKerf) {
  const std::vector<PlaneBody> ring = cutSection(kPlate, {arcWay({4, 0}, {0, 0}, 2 * kPi, kKerf, 0)});
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_NEAR(kPlateArea - ring[0].area_mm2, kPi * 4.1 * 4.1, 1e-6);
  EXPECT_NEAR(ring[1].area_mm2, kPi * 3.9 * 3.9, 1e-6);
  // A circle of radius 0.06 with a kerf of 0.1 leaves nothing inside.
  const std::vector<PlaneBody> small = cutSection(kPlate, {arcWay({0.06, 0}, {0, 0}, 2 * kPi, kKerf, 0)});
  ASSERT_EQ(small.size(), 1u);
  EXPECT_NEAR(kPlateArea - small[0].area_mm2, kPi * 0.16 * 0.16, 1e-7);
}

TEST(KerfSection, WaysGoneTwiceCountOnceForTheFirst) {
  std::vector<WireStretch> way = {lineWay({-5, 0}, {5, 0}, kKerf, 0), lineWay({5, 0}, {-5, 0}, kKerf, 1),
                                  lineWay({-2, 0}, {3, 0}, kKerf, 2)};
  const std::vector<PlaneBody> bodies = cutSection(kPlate, way);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_NEAR(kPlateArea - totalArea(bodies), 10 * 2 * kKerf + kPi * kKerf * kKerf, 1e-7);
  for (const PlaneEdge& edge : bodies[0].loops[1].edges) EXPECT_EQ(edge.motion, 0u);
}

/// A circle that is closed with an overlap, whose chords are others, and a finishing cut the other way round.
TEST(KerfSection, OverlapOfACircleLeavesTwoCircles) {
  const Vec2 start(4, 0);
  std::vector<WireStretch> way = {arcWay(start, {0, 0}, 2 * kPi, kKerf, 0),
                                  arcWay(start, {0, 0}, 0.3, kKerf, 1)};
  way.push_back(arcWay(way.back().to, {0, 0}, -2 * kPi, kKerf, 2));
  const std::vector<PlaneBody> bodies = cutSection(kPlate, way);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NEAR(bodies[1].area_mm2, kPi * 3.9 * 3.9, 1e-6);
  ASSERT_EQ(bodies[1].loops.size(), 1u);
  ASSERT_EQ(bodies[1].loops[0].edges.size(), 1u);
  EXPECT_EQ(bodies[1].loops[0].edges[0].motion, 0u);
  EXPECT_EQ(bodies[0].loops[1].edges.size(), 1u);
}

TEST(KerfSection, BridgesKeepThePiecesOne) {
  std::vector<WireStretch> way = closedWay(kSquare, kKerf);
  way.back().to = {-5, -4.5};  // 0.3 mm are left
  EXPECT_EQ(cutSection(kPlate, way).size(), 1u);
  way.back().to = {-5, -4.7};  // 0.1 mm are left
  EXPECT_EQ(cutSection(kPlate, way).size(), 1u);
  way.back().to = {-5, -4.81};
  EXPECT_EQ(cutSection(kPlate, way).size(), 2u);
}

TEST(KerfSection, ThroughThePlateAndStartHoles) {
  std::vector<PlaneLoop> plate = kPlate;
  plate.push_back(circleLoop({0, 0}, 1, true));
  const std::vector<PlaneBody> bodies = cutSection(plate, {lineWay({-25, 5}, {25, 5}, kKerf, 0)});
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NEAR(bodies[0].area_mm2, 40 * 24.9 - kPi, 1e-6);
  EXPECT_NEAR(bodies[1].area_mm2, 40 * 14.9, 1e-6);
}

TEST(KerfSection, FinishingCutLeavesWhatItIsSet) {
  std::vector<WireStretch> way = closedWay(kSquare, 0.15);
  for (const WireStretch& pass : closedWay({{-5.02, -5.02}, {5.02, -5.02}, {5.02, 5.02}, {-5.02, 5.02}}, 0.1))
    way.push_back(pass);
  for (MotionId i = 0; i < way.size(); ++i) way[i].motion = i;
  const std::vector<PlaneBody> bodies = cutSection(kPlate, way);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NEAR(bodies[1].area_mm2, 9.7 * 9.7, 1e-7);
}

TEST(KerfSection, ChangingRadiusIsFollowedWithinATenthOfAMicrometre) {
  WireTrack track;
  track.from = {5, 0};
  track.to = {0, 5.01};
  track.sweep_rad = 0.5 * kPi;
  std::vector<WireStretch> way;
  addStretches(track, kKerf, 0, way);
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0;
    const Vec2 exact = turnedBy({5 + 0.01 * t, 0}, t * track.sweep_rad);
    double off = 1.0;
    for (const WireStretch& s : way) off = std::min(off, distanceTo(s, exact).mm);
    EXPECT_LT(off, 1e-4);
  }
}

/// Corners that the control rounds with an offset of about the kerf: the strips meet at the center of the
/// arc, and rounding must leave no slit there.
TEST(KerfSection, ArcsAsLargeAsTheKerf) {
  constexpr double kHalfKerf = 0.132005;
  const std::vector<PlaneLoop> plate = {rectangleLoop({-15, -15}, {15, 15})};
  for (const double less : {-1e-3, -2.5e-5, -5e-6, 0.0, 5e-6, 2.5e-5, 1e-4, 1e-3, 0.05}) {
    for (const double degrees : {1.0, 9.227, 30.0, 90.0, 170.0, 250.0}) {
      const double radius = kHalfKerf - less, sweep = -degrees * kPi / 180.0;
      for (int turn = 0; turn < 12; ++turn) {
        const auto at = [&](const Vec2& p) {
          return Vec2(turnedBy(p, 0.517 * turn) + Vec2(0.7183, -1.3141));
        };
        const Vec2 start = at({0, 0}), center = at({0, -radius});
        std::vector<WireStretch> way = {lineWay(at({-10, 0}), start, kHalfKerf, 0),
                                        arcWay(start, center, sweep, kHalfKerf, 1)};
        way.push_back(lineWay(way[1].to, way[1].to + 9.0 * way[1].directionAtEnd(), kHalfKerf, 2));
        for (const PlaneBody& body : cutSection(plate, way)) {
          for (const PlaneLoop& loop : body.loops) {
            for (const Vec2& p : chordsOf(loop, 1e-4).points) {
              for (const WireStretch& s : way)
                ASSERT_GE(distanceTo(s, p).mm, kHalfKerf - 3e-4)
                    << less << " " << degrees << " turn " << turn;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace proveout
