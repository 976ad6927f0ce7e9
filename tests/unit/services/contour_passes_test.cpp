// Passes over contours against the contour itself, on random contours.
#include "core/nc/services/contour/contour_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/nc/services/contour/contour_offset.h"
#include "core/nc/services/contour/contour_profile.h"

namespace proveout {
namespace {

ContourElement lineTo(const Vec2& from, const Vec2& to) {
  ContourElement e;
  e.from = from;
  e.to = to;
  return e;
}

/// An arc whose middle is `bow` off the chord, to the left of the way where it is above 0.
ContourElement arcTo(const Vec2& from, const Vec2& to, double bow) {
  ContourElement e = lineTo(from, to);
  const Vec2 half = 0.5 * (to - from), left(-half.y(), half.x());
  const double c = half.norm(), radius = (c * c + bow * bow) / (2.0 * std::abs(bow));
  const double side = bow > 0.0 ? 1.0 : -1.0;
  e.arc = true;
  e.center = from + half - side * (radius - std::abs(bow)) / c * left;
  e.sweep = -side * 2.0 * std::asin(std::min(1.0, c / radius));
  return e;
}

Vec2 pointOf(const ContourElement& e, double t) {
  if (!e.arc) return e.from + t * (e.to - e.from);
  const Vec2 arm = e.from - e.center;
  const double a = t * e.sweep, c = std::cos(a), s = std::sin(a);
  return e.center + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
}

/// Height of the contour over u, where it goes to smaller u only: the lowest and the highest of steps.
void heightsAt(const PlaneContour& contour, double u, double& low, double& high) {
  low = 1e300;
  high = -1e300;
  for (const ContourElement& e : contour) {
    if (u > e.from.x() + 1e-9 || u < e.to.x() - 1e-9) continue;
    double a = 0.0, b = 1.0;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (a + b);
      (pointOf(e, middle).x() > u ? a : b) = middle;
    }
    const bool wall = e.from.x() - e.to.x() < 1e-9;
    for (const double v :
         {pointOf(e, a).y(), wall ? e.from.y() : pointOf(e, b).y(), wall ? e.to.y() : pointOf(e, a).y()}) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
}

double distanceTo(const ContourElement& e, const Vec2& p) {
  double least = std::min((p - e.from).norm(), (p - e.to).norm());
  if (!e.arc) {
    const Vec2 way = e.to - e.from;
    const double t = std::clamp((p - e.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return std::min(least, (p - e.from - t * way).norm());
  }
  const Vec2 arm = p - e.center, start = e.from - e.center;
  double turn = std::atan2(start.x() * arm.y() - start.y() * arm.x(), start.dot(arm));
  if (turn * e.sweep < 0.0) turn += e.sweep > 0.0 ? 2.0 * kPi : -2.0 * kPi;
  if (std::abs(turn) <= std::abs(e.sweep)) least = std::min(least, std::abs(arm.norm() - start.norm()));
  return least;
}

/// From (0, v) towards smaller u: lines, level stretches, walls and arcs.
PlaneContour randomContour(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlaneContour contour;
  Vec2 at(0.0, 5.0 + 10.0 * unit(random));
  for (int k = 0; k < 8; ++k) {
    const double choice = unit(random);
    Vec2 to(at.x() - 1.0 - 8.0 * unit(random), 3.0 + 15.0 * unit(random));
    if (choice < 0.15) to.y() = at.y();
    if (choice > 0.85) to.x() = at.x();
    if (choice > 0.4 && choice < 0.7) {
      // Flat enough not to turn back.
      const double c = 0.5 * (to - at).norm(), steep = std::abs((to - at).y()) / (2.0 * c);
      const double bow = (unit(random) < 0.5 ? -1.0 : 1.0) * c * 0.4 * (1.0 - steep);
      if (std::abs(bow) > 1e-3) {
        contour.push_back(arcTo(at, to, bow));
        at = to;
        continue;
      }
    }
    if ((to - at).norm() < 1e-6) continue;
    contour.push_back(lineTo(at, to));
    at = to;
  }
  return contour;
}

/// Roughing never cuts into the contour, and cuts all of it: no steps stay (digest wl4, 10.3).
TEST(ContourPasses, KeepsOffTheContourAndFollowsAllOfIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const PlaneContour contour = randomContour(random);
    ASSERT_TRUE(goesOneWay(contour, 0)) << trial;
    const RoughingRules rules{1, Vec2(2.0, 20.0 + 5.0 * unit(random)), 0.5 + 4.0 * unit(random)};
    const std::vector<ContourMove> passes = roughingPasses(contour, rules);
    Vec2 at = rules.from;
    for (const ContourMove& pass : passes) {
      ASSERT_LT((pass.element.from - at).norm(), 1e-6) << trial;  // no gaps
      at = pass.element.to;
      for (double t = 0.0; t <= 1.0; t += 0.05) {
        const Vec2 p = pointOf(pass.element, t);
        double low, high;
        heightsAt(contour, p.x(), low, high);
        ASSERT_TRUE(low > 1e299 || p.y() > low - 1e-6) << trial << " u " << p.x();
      }
    }
    EXPECT_LT((at - rules.from).norm(), 1e-9);
    for (const ContourElement& e : contour) {
      for (double t = 0.02; t < 1.0; t += 0.05) {
        const Vec2 p = pointOf(e, t);
        double least = 1e300;
        for (const ContourMove& pass : passes) {
          if (pass.speed != ContourMove::Speed::kRapid) least = std::min(least, distanceTo(pass.element, p));
        }
        ASSERT_LT(least, 1e-6) << trial << " at " << p.transpose();
      }
    }
  }
}

/// No pass is deeper than E below what was cut before.
TEST(ContourPasses, CutsNoDeeperThanAPass) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const PlaneContour contour = randomContour(random);
    const RoughingRules rules{1, Vec2(2.0, 21.0), 1.5};
    constexpr int kColumns = 400;
    const double first = contour.front().from.x(), last = contour.back().to.x();
    std::vector<double> top(kColumns, rules.from.y());
    for (const ContourMove& pass : roughingPasses(contour, rules)) {
      std::vector<double> now = top;
      for (int k = 0; k <= 2000; ++k) {
        const Vec2 p = pointOf(pass.element, k / 2000.0);
        const int column = static_cast<int>((first - p.x()) / (first - last) * kColumns);
        if (column < 0 || column >= kColumns) continue;
        const auto c = static_cast<std::size_t>(column);
        if (pass.speed == ContourMove::Speed::kRapid) {
          ASSERT_GT(p.y(), top[c] - 0.2) << trial;  // a column is as wide as a wall's step
        } else {
          ASSERT_GT(p.y(), top[c] - rules.depth - 0.2) << trial;
        }
        now[c] = std::min(now[c], p.y());
      }
      top = now;
    }
  }
}

TEST(ContourOffset, KeepsItsDistance) {
  std::mt19937 random(3);
  int made = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const PlaneContour contour = randomContour(random);
    const double offset = -0.4;  // towards larger v on the way to smaller u
    bool fits = true;
    const auto moved = offsetContour(contour, offset, fits);
    if (!moved || !fits) continue;  // the tool does not fit: told by the control
    ++made;
    for (const ContourElement& e : *moved) {
      for (double t = 0.0; t <= 1.0; t += 0.1) {
        double least = 1e300;
        for (const ContourElement& c : contour) least = std::min(least, distanceTo(c, pointOf(e, t)));
        ASSERT_GT(least, std::abs(offset) - 1e-6) << trial;
        ASSERT_LT(least, std::abs(offset) * 3.0) << trial;
      }
    }
  }
  EXPECT_GT(made, 60);
}

TEST(ContourOffset, LayersEndWithTheFinish) {
  const ContourAllowance finish{0.5, Vec2(0.1, 0.2)};
  const auto thick = contourLayers({3.0, finish.shift}, finish, 1.0);
  ASSERT_EQ(thick.size(), 3u);
  EXPECT_DOUBLE_EQ(thick[0].offset, 2.0);
  EXPECT_DOUBLE_EQ(thick[2].offset, finish.offset);
  EXPECT_EQ(thick[0].shift, finish.shift);
  const auto shifted = contourLayers({0.5, Vec2(0.1, 4.2)}, finish, 3.0);
  ASSERT_EQ(shifted.size(), 2u);
  EXPECT_LT((shifted[0].shift - Vec2(0.1, 1.2)).norm(), 1e-12);
  EXPECT_LT((shifted[1].shift - finish.shift).norm(), 1e-12);
  // A whole number of cuts, but for rounding, and nothing to cut.
  EXPECT_EQ(contourLayers({0.3 + 0.1 + 0.2, Vec2::Zero()}, {0.0, Vec2::Zero()}, 0.1).size(), 6u);
  EXPECT_EQ(contourLayers(finish, finish, 1.0).size(), 1u);
  EXPECT_EQ(contourLayers({0.2, finish.shift}, finish, 1.0).size(), 1u);
}

/// A bore's step and cone, the tool inside: larger diameters are deeper.
TEST(ContourProfile, TellsWhereALevelMeetsTheContour) {
  const PlaneContour contour = {lineTo({0, 20}, {-5, 20}), lineTo({-5, 20}, {-20, 5})};
  const ContourProfile profile(contour, 1, -1.0);
  const auto zones = profile.zonesBelow({0.0, profile.length()}, -12.5);
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_EQ(zones[0].a, 0.0);
  EXPECT_LT((profile.at(zones[0].b) - Vec2(-12.5, 12.5)).norm(), 1e-9);
  EXPECT_EQ(profile.lowest({0.0, profile.length()}), -20.0);
  const PlaneContour below = profile.between(zones[0].a, zones[0].b);
  ASSERT_EQ(below.size(), 2u);
  EXPECT_LT((below[1].to - Vec2(-12.5, 12.5)).norm(), 1e-9);
  EXPECT_TRUE(profile.zonesBelow({0.0, profile.length()}, -20.0).empty());
}

}  // namespace
}  // namespace proveout
