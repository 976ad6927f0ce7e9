#include "core/nc/services/zone_check.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace proveout::nc {
namespace {

Zone box(const Vec3& low, const Vec3& high, bool outside) {
  Zone zone;
  zone.axes = AxisSet(7);
  zone.low = low;
  zone.high = high;
  zone.outside = outside;
  return zone;
}

ZonePath line(const Vec3& from, const Vec3& to) { return {from, to, 3}; }

ZonePath arc(const Vec3& from, const Vec3& to, const ArcGeometry& geometry) {
  ZonePath path(from, to, 3);
  path.setArc(0, 1, 2, geometry);
  return path;
}

TEST(ZoneCheck, LinesAgainstABox) {
  const Zone inside = box({-10, -10, -10}, {10, 10, 10}, false);
  EXPECT_NEAR(firstForbidden(inside, line({150, 0, 0}, {-150, 0, 0}))->t, 140.0 / 300.0, 1e-10);
  EXPECT_FALSE(firstForbidden(inside, line({150, 10.00001, 0}, {-150, 10.00001, 0})).has_value());
  EXPECT_TRUE(firstForbidden(inside, line({150, 10, 0}, {-150, 10, 0})).has_value());  // touches
  EXPECT_FALSE(firstForbidden(inside, line({20.1, 0, 0}, {0, 20.1, 0})).has_value());  // past the edge
  EXPECT_NEAR(firstForbidden(inside, line({20, 0, 0}, {0, 20, 0}))->t, 0.5, 1e-9);     // on the edge
  EXPECT_EQ(firstForbidden(inside, line({1, 2, 3}, {50, 0, 0}))->t, 0.0);
  const Zone outside = box({-10, -10, -10}, {10, 10, 10}, true);
  const auto hit = firstForbidden(outside, line({0, 0, 0}, {5, -40, 0}));
  EXPECT_NEAR(hit->t, 0.25, 1e-10);
  EXPECT_EQ(hit->axis, 1);
  EXPECT_FALSE(hit->above);
  EXPECT_FALSE(firstForbidden(outside, line({10, 10, 0}, {10, -10, 10})).has_value());
}

TEST(ZoneCheck, ArcsByTheirTruePath) {
  const ArcGeometry circle{{0, 0, 0}, Vec3::UnitZ(), -kPi};
  // From (90, 0) clockwise to (-90, 0): Y-80 is passed where sin = 80 / 90.
  const auto hit =
      firstForbidden(box({-100, -80, -1}, {100, 80, 1}, true), arc({90, 0, 0}, {-90, 0, 0}, circle));
  EXPECT_NEAR(hit->t, std::asin(80.0 / 90.0) / kPi, 1e-9);
  EXPECT_EQ(hit->axis, 1);
  EXPECT_FALSE(hit->above);
  // It just touches the limit.
  EXPECT_FALSE(firstForbidden(box({-90, -90, -1}, {90, 90, 1}, true), arc({90, 0, 0}, {-90, 0, 0}, circle))
                   .has_value());
  EXPECT_TRUE(
      firstForbidden(box({-90, -89.9999, -1}, {90, 90, 1}, true), arc({90, 0, 0}, {-90, 0, 0}, circle))
          .has_value());
  // Around a box whose middle the chord goes through.
  EXPECT_FALSE(firstForbidden(box({-10, -10, -1}, {10, 10, 1}, false), arc({90, 0, 0}, {-90, 0, 0}, circle))
                   .has_value());
  // Touches the corner of a box from outside: radius 90 and corner at 90 / sqrt 2.
  const double corner = -90 / std::sqrt(2.0);
  EXPECT_NEAR(firstForbidden(box({-50, -200, -1}, {corner + 200, corner, 1}, false),
                             arc({90, 0, 0}, {-90, 0, 0}, circle))
                  ->t,
              0.25, 1e-6);
}

/// Slow reference: a dense walk along the path.
TEST(ZoneCheck, RandomPathsAgreeWithSmallSteps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-30, 30);
  int hits = 0;
  for (int k = 0; k < 400; ++k) {
    const auto point = [&] {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = number(random);
      return p;
    };
    const Vec3 from = point(), a = point(), b = point(), aside = point(), normal = point().normalized();
    const Vec3 center = aside + normal * normal.dot(from - aside);  // at the height of the start
    const double sweep = 0.4 * number(random), rise = number(random);
    // An arc ends where its sweep and rise take it.
    const Vec3 turned = center + Eigen::AngleAxisd(sweep, normal) * (from - center) + rise * normal;
    ZonePath path = line(from, k % 2 == 0 ? turned : point());
    if (k % 2 == 0) path.setArc(0, 1, 2, {center, normal, sweep});
    const Zone zone = box(a.cwiseMin(b), a.cwiseMax(b), k % 3 == 0);
    const auto found = firstForbidden(zone, path);
    constexpr int kSteps = 20000;
    std::optional<double> walked;
    for (int i = 0; i <= kSteps && !walked; ++i) {
      if (forbidden(zone, path.at(static_cast<double>(i) / kSteps), 3))
        walked = static_cast<double>(i) / kSteps;
    }
    if (!walked) continue;  // a hit between the steps is possible
    ++hits;
    ASSERT_TRUE(found.has_value()) << k;
    EXPECT_LE(found->t, *walked + 1e-12) << k;
    // What lies before the hit is free, and at it the border is near.
    for (int i = 0; i / static_cast<double>(kSteps) < found->t; ++i) {
      EXPECT_FALSE(forbidden(zone, path.at(static_cast<double>(i) / kSteps), 3).has_value()) << k;
    }
    const double behind = std::min(1.0, found->t + 1e-9);
    Zone wider = zone;
    for (int axis = 0; axis < 3; ++axis) {
      wider.low[axis] -= zone.outside ? -1e-5 : 1e-5;
      wider.high[axis] += zone.outside ? -1e-5 : 1e-5;
    }
    EXPECT_TRUE(forbidden(wider, path.at(behind), 3).has_value()) << k;
  }
  EXPECT_GT(hits, 100);
}

TEST(ZoneCheck, AxesThatTakeNoPartCountForNothing) {
  Zone zone = box({-1, -1, -1}, {1, 1, 1}, false);
  zone.axes = AxisSet(1);
  EXPECT_TRUE(firstForbidden(zone, line({5, 70, 70}, {-5, 70, 70})).has_value());
  zone.axes.reset();
  EXPECT_FALSE(firstForbidden(zone, line({5, 0, 0}, {-5, 0, 0})).has_value());
  zone.outside = true;
  EXPECT_FALSE(firstForbidden(zone, line({5, 0, 0}, {-5, 0, 0})).has_value());
}

}  // namespace
}  // namespace proveout::nc
