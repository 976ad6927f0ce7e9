// Numbers: worked examples of the NCT milling manual 4.3 - 4.3.3, and closed forms.
#include "core/nc/services/arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace proveout {
namespace {

ArcRequest request(Vec3 start, Vec3 end, bool ccw) {
  ArcRequest r;
  r.start = start;
  r.end = end;
  r.has_plane_end = (end - start).head<2>().norm() > 0.0;
  r.counter_clockwise = ccw;
  return r;
}

ArcRequest withCenter(ArcRequest r, double i, double j) {
  r.center_u = i;
  r.center_v = j;
  return r;
}

ArcRequest withRadius(ArcRequest r, double radius) {
  r.radius = radius;
  return r;
}

ArcRequest withTurns(ArcRequest r, std::int64_t turns) {
  r.turns = turns;
  return r;
}

void expectArc(const ArcResolution& r, Vec2 center, double sweep_deg, double tolerance = 1e-4) {
  ASSERT_EQ(r.error, ArcError::kNone);
  ASSERT_FALSE(r.no_motion);
  EXPECT_NEAR(r.arc.center.x(), center.x(), tolerance);
  EXPECT_NEAR(r.arc.center.y(), center.y(), tolerance);
  EXPECT_NEAR(radToDeg(r.arc.sweep_rad), sweep_deg, tolerance);
}

/// Point of the arc at parameter t through the tool path's own evaluation.
Vec3 pointOf(const PlaneArc& arc, double t) {
  const ArcGeometry geometry = toArcGeometry(arc, PlaneFrame(Plane::kXY));
  return arcPoint(arcFrame(arc.start, arc.end, geometry), geometry, t);
}

TEST(Arcs, RadiusSignChoosesTheShortOrLongArc) {
  const Vec3 s(0, 0, 0), e(50, 40, 0);
  expectArc(resolveArc(withRadius(request(s, e, false), 40)), {39.9797, 1.2754}, -106.3348);
  expectArc(resolveArc(withRadius(request(s, e, false), -40)), {10.0203, 38.7246}, -253.6652);
  expectArc(resolveArc(withRadius(request(s, e, true), 40)), {10.0203, 38.7246}, 106.3348);
  expectArc(resolveArc(withRadius(request(s, e, true), -40)), {39.9797, 1.2754}, 253.6652);
}

TEST(Arcs, ContourOfTheManualByCenterAndByRadius) {
  const Vec3 a(130, 20, 0), b(60, 90, 0), c(40, 50, 0);
  for (const auto& r : {withRadius(request(a, b, true), 70), withCenter(request(a, b, true), -70, 0)}) {
    const ArcResolution arc = resolveArc(r);
    expectArc(arc, {60, 20}, 90);
    EXPECT_NEAR(planeLength(arc.arc), 109.9557, 1e-4);
  }
  for (const auto& r : {withRadius(request(b, c, false), 50), withCenter(request(b, c, false), -50, 0)}) {
    const ArcResolution arc = resolveArc(r);
    expectArc(arc, {10, 90}, -53.1301);
    EXPECT_NEAR(planeLength(arc.arc), 46.3648, 1e-4);
  }
}

TEST(Arcs, NoEndIsAFullCircleWithACenterAndNothingWithARadius) {
  expectArc(resolveArc(withCenter(request({200, 0, 0}, {200, 0, 0}, true), -100, 0)), {100, 0}, 360);
  expectArc(resolveArc(withCenter(request({200, 0, 0}, {200, 0, 0}, false), -100, 0)), {100, 0}, -360);
  const ArcResolution none = resolveArc(withRadius(request({200, 0, 0}, {200, 0, 0}, true), 100));
  EXPECT_TRUE(none.ok());
  EXPECT_TRUE(none.no_motion);
}

TEST(Arcs, RoundingNoiseNeitherLosesNorAddsATurn) {
  for (const double noise : {-1e-12, 1e-12}) {
    ArcRequest r = withCenter(request({50, 0, 0}, {50, noise, 0}, true), -50, 0);
    r.has_plane_end = true;
    expectArc(resolveArc(r), {0, 0}, 360);
    r.turns = 3;
    expectArc(resolveArc(r), {0, 0}, 1080);
  }
}

TEST(Arcs, RadiusDifferenceIsAnErrorAboveTheTolerance) {
  const ArcRequest by_center = withCenter(request({50, 0, 0}, {-20, 0, 0}, true), -50, 0);
  const ArcRequest by_radius = withRadius(request({0, 0, 0}, {40, 30, 0}, false), 10);
  EXPECT_EQ(resolveArc(by_center).error, ArcError::kRadiusDifference);
  EXPECT_EQ(resolveArc(by_radius).error, ArcError::kRadiusDifference);
  EXPECT_DOUBLE_EQ(resolveArc(by_center).radius_difference, 30.0);
  EXPECT_DOUBLE_EQ(resolveArc(by_radius).radius_difference, 30.0);
  ArcPolicy wide;
  wide.radius_tolerance = 30.0;
  const ArcResolution spiral = resolveArc(by_center, wide);
  expectArc(spiral, {0, 0}, 180);
  EXPECT_NEAR((pointOf(spiral.arc, 0.5) - Vec3(0, 35, 0)).norm(), 0.0, 1e-9);
  const ArcResolution half = resolveArc(by_radius, wide);
  expectArc(half, {8, 6}, -180);
  EXPECT_NEAR((pointOf(half.arc, 0.5) - Vec3(-7, 26, 0)).norm(), 0.0, 1e-9);
}

TEST(Arcs, TurnsMakeSpirals) {
  const ArcResolution r =
      resolveArc(withTurns(withCenter(request({90, 0, 0}, {-30, 0, 0}, true), -90, 0), 3));
  expectArc(r, {0, 0}, 900);
  EXPECT_NEAR(planeLength(r.arc), 944.5726, 1e-4);
  EXPECT_NEAR((pointOf(r.arc, 0.4) - Vec3(66, 0, 0)).norm(), 0.0, 1e-9);
  const ArcResolution one =
      resolveArc(withTurns(withCenter(request({50, 0, 0}, {-20, 0, 0}, true), -50, 0), 1));
  expectArc(one, {0, 0}, 180);
  EXPECT_NEAR(planeLength(one.arc), 114.2233, 1e-4);
}

TEST(Arcs, HelicesAndConesKeepTheHeight) {
  const ArcResolution quarter = resolveArc(withRadius(request({100, 0, 0}, {0, 100, 20}, true), 100));
  expectArc(quarter, {0, 0}, 90);
  EXPECT_NEAR(planeLength(quarter.arc), 157.0796, 1e-4);
  EXPECT_NEAR(pointOf(quarter.arc, 0.25).z(), 5.0, 1e-12);
  ArcRequest helix = withTurns(withCenter(request({-50, 0, 0}, {-50, 0, -20}, false), 50, 0), 4);
  helix.has_other_axis = true;
  expectArc(resolveArc(helix), {0, 0}, -1440);
  const ArcResolution cone =
      resolveArc(withTurns(withCenter(request({-50, 0, 0}, {-20, 0, -20}, false), 50, 0), 4));
  expectArc(cone, {0, 0}, -1440);
  for (int turn = 1; turn <= 4; ++turn) {
    EXPECT_NEAR((pointOf(cone.arc, turn / 4.0) - Vec3(-50 + 7.5 * turn, 0, -5.0 * turn)).norm(), 0.0, 1e-9);
  }
}

TEST(Arcs, RefusesWhatHasNoMeaning) {
  const ArcRequest plain = request({0, 0, 0}, {10, 0, 0}, true);
  EXPECT_EQ(resolveArc(plain).error, ArcError::kNoDefinition);
  ArcRequest outside = withRadius(plain, 10);
  outside.center_word_outside_plane = true;
  EXPECT_EQ(resolveArc(outside).error, ArcError::kCenterOutsidePlane);
  ArcRequest height_only = withRadius(request({0, 0, 0}, {0, 0, 5}, true), 10);
  height_only.has_other_axis = true;
  EXPECT_EQ(resolveArc(height_only).error, ArcError::kRadiusWithoutEnd);
  EXPECT_EQ(resolveArc(withRadius(plain, 0)).error, ArcError::kZeroRadius);
  EXPECT_EQ(resolveArc(withCenter(request({0, 0, 0}, {0, 0, 0}, true), 0, 0)).error, ArcError::kZeroRadius);
  EXPECT_EQ(resolveArc(withTurns(withCenter(plain, 5, 0), 0)).error, ArcError::kBadTurns);
  EXPECT_EQ(resolveArc(withTurns(withCenter(plain, 5, 0), 99999999)).error, ArcError::kBadTurns);
  EXPECT_EQ(resolveArc(withRadius(plain, std::numeric_limits<double>::quiet_NaN())).error,
            ArcError::kNotFinite);
  EXPECT_TRUE(resolveArc(withCenter(withRadius(plain, 10), 5, 0)).center_ignored);
}

TEST(Arcs, LettersFollowThePlane) {
  // G18 G3 X70 Z10 I-20 K-50 of the manual: K with the first axis; start first = 80, second = 40.
  const PlaneFrame frame(Plane::kZX);
  const Vec3 start = frame.toPlane({40, 0, 80}), end = frame.toPlane({70, 0, 10});
  const ArcResolution r = resolveArc(withCenter(request(start, end, true), -50, -20));
  expectArc(r, {30, 20}, 90);
  const ArcGeometry geometry = toArcGeometry(r.arc, frame);
  EXPECT_NEAR((geometry.center - Vec3(20, 0, 30)).norm(), 0.0, 1e-9);
  EXPECT_EQ(geometry.normal, Vec3::UnitY());
}

TEST(Arcs, RandomArcsEndWhereTheyShouldAndRunBackTheSameWay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-50, 50), radius(0.5, 3);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 s(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 e(coordinate(random), coordinate(random), coordinate(random));
    const double r = 0.5 * (e - s).head<2>().norm() * (1.0 + radius(random)) * (n % 2 ? 1 : -1);
    const bool ccw = n % 3 == 0;
    const ArcResolution there = resolveArc(withRadius(request(s, e, ccw), r));
    ASSERT_TRUE(there.ok()) << "n " << n;
    ASSERT_LT((pointOf(there.arc, 1.0) - e).norm(), 1e-9) << "n " << n;
    ASSERT_EQ(std::abs(there.arc.sweep_rad) < kPi, r > 0) << "n " << n;
    const ArcResolution back = resolveArc(withRadius(request(e, s, !ccw), r));
    const PlaneArc turned = reversed(there.arc);
    ASSERT_LT((back.arc.center - turned.center).norm(), 1e-6) << "n " << n;
    ASSERT_NEAR(back.arc.sweep_rad, turned.sweep_rad, 1e-9) << "n " << n;
    ASSERT_LT((pointOf(turned, 0.3) - pointOf(there.arc, 0.7)).norm(), 1e-9) << "n " << n;
  }
}

TEST(Arcs, PlanesGiveTheSameArcAfterThePermutation) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-50, 50);
  for (int n = 0; n < 200; ++n) {
    const Vec3 s(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 e(coordinate(random), coordinate(random), coordinate(random));
    const bool ccw = n % 2 == 0;
    ArcRequest r =
        withTurns(withCenter(request(s, e, ccw), coordinate(random), coordinate(random)), 1 + n % 3);
    const ArcResolution arc = resolveArc(r);
    ASSERT_TRUE(arc.ok());
    for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
      const PlaneFrame frame(plane);
      const ArcGeometry geometry = toArcGeometry(arc.arc, frame);
      const ArcFrame path = arcFrame(frame.fromPlane(s), frame.fromPlane(e), geometry);
      for (const double t : {0.0, 0.3, 1.0}) {
        const Vec3 in_plane = frame.toPlane(arcPoint(path, geometry, t));
        ASSERT_LT((in_plane - pointOf(arc.arc, t)).norm(), 1e-9);
        // By the definition itself: angle, radius and height go linearly.
        const Vec2 a = s.head<2>() - arc.arc.center;
        const double angle = std::atan2(a.y(), a.x()) + t * arc.arc.sweep_rad;
        const double radius = arc.arc.startRadius() + t * (arc.arc.endRadius() - arc.arc.startRadius());
        const Vec2 expected = arc.arc.center + radius * Vec2(std::cos(angle), std::sin(angle));
        ASSERT_LT((in_plane.head<2>() - expected).norm(), 1e-8);
        ASSERT_NEAR(in_plane.z(), s.z() + t * (e.z() - s.z()), 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace proveout
