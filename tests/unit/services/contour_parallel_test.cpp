// The true parallel of contours: where it must lie, and on random contours.
#include "core/nc/services/contour/contour_parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace proveout {
namespace {

double distanceOf(const PlaneContour& contour, const Vec2& p) {
  double least = 1e300;
  for (const ContourElement& e : contour) least = std::min(least, distanceFrom(e, p));
  return least;
}

PlaneContour polyline(const std::vector<Vec2>& points) {
  PlaneContour out;
  for (std::size_t k = 1; k < points.size(); ++k) out.push_back(lineElement(points[k - 1], points[k]));
  return out;
}

TEST(ContourParallel, GoesAboutOutsideCornersAndMeetsInInsideOnes) {
  const PlaneContour out = parallelContour(polyline({{0, 0}, {10, 0}, {10, 5}, {20, 5}}), 1.0);
  ASSERT_EQ(out.size(), 4u);
  EXPECT_NEAR((out[0].to - Vec2(9, 1)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((out[1].to - Vec2(9, 5)).norm(), 0.0, 1e-9);
  EXPECT_TRUE(out[2].arc);
  EXPECT_NEAR((out[2].to - Vec2(10, 6)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((out[3].to - Vec2(20, 6)).norm(), 0.0, 1e-9);
}

TEST(ContourParallel, PassesOverWhatIsTooNarrow) {
  // A groove of 1 mm at a distance of 2: its edges alone count.
  const PlaneContour out =
      parallelContour(polyline({{0, 0}, {10, 0}, {10, -5}, {11, -5}, {11, 0}, {20, 0}}), 2.0);
  ASSERT_EQ(out.size(), 4u);
  EXPECT_TRUE(out[1].arc && out[2].arc);
  EXPECT_NEAR((out[1].to - Vec2(10.5, std::sqrt(3.75))).norm(), 0.0, 1e-9);
  // A valley of radius 1 is used up, so that its flanks meet.
  PlaneContour valley = {lineElement({0, 5}, {0, 0}), arcElement({1, 0}, {0, 0}, {2, 0}, kPi),
                         lineElement({2, 0}, {2, 5})};
  EXPECT_TRUE(parallelContour(valley, 1.5).empty());
  valley.insert(valley.begin(), lineElement({-5, 5}, {0, 5}));
  valley.push_back(lineElement({2, 5}, {7, 5}));
  const PlaneContour over = parallelContour(valley, 1.5);
  ASSERT_FALSE(over.empty());
  EXPECT_GT(over[1].to.y(), 5.0);
}

TEST(ContourParallel, BearsTheRoundingOfPrograms) {
  // Arcs with three decimals end beside their circles and beside the tangents of what follows.
  const PlaneContour contour = {
      lineElement({9.841, -25.031}, {13.169, -23.0395}),
      arcElement({13.169, -21.6165}, {13.169, -23.0395}, {14.591, -21.6175}, 1.570093),
      lineElement({14.591, -21.6175}, {14.591, -15.604}), lineElement({14.591, -15.604}, {18.291, -14.2725})};
  for (const double distance : {0.299, 25.0 * 0.299}) {
    const PlaneContour out = parallelContour(contour, distance);
    ASSERT_FALSE(out.empty()) << distance;
    for (const ContourElement& e : out) EXPECT_GT((e.to - e.from).norm(), 1e-5);
  }
  // Two thousandths of a degree: no arc, and no gap.
  const PlaneContour straight =
      parallelContour(polyline({{0, 0}, {300, 0}, {600, -0.01}, {900, -0.01}}), 10.0);
  ASSERT_EQ(straight.size(), 3u);
  for (const ContourElement& e : straight) EXPECT_FALSE(e.arc);
}

TEST(ContourParallel, KeepsTheDistanceOnRandomContours) {
  std::mt19937 random(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  int cut = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Vec2> points = {{0, 0}};
    for (int k = 0; k < 12; ++k) {
      const double du = round % 3 == 0 && k % 2 == 0 ? 0.0 : between(0.3, 4.0);
      points.push_back(points.back() + Vec2(du, between(-4.0, 4.0)));
    }
    points.front() = points[1] - Vec2(30, 0);
    points.push_back(points.back() + Vec2(30, 0));
    const PlaneContour contour = polyline(points);
    const double distance = between(0.2, 3.0);
    const PlaneContour out = parallelContour(contour, distance);
    ASSERT_FALSE(out.empty()) << round;
    EXPECT_NEAR((out.front().from - contour.front().from - Vec2(0, distance)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((out.back().to - contour.back().to - Vec2(0, distance)).norm(), 0.0, 1e-9);
    for (const ContourElement& e : out) {
      for (int k = 0; k <= 20; ++k) {
        const double is = distanceOf(contour, pointOn(e, k / 20.0));
        EXPECT_GT(is, distance - 2e-6) << round;
        EXPECT_LT(is, distance + 1e-3) << round;  // corners without an arc
      }
    }
    cut += out.size() < 2 * contour.size() - 4 ? 1 : 0;
  }
  EXPECT_GT(cut, 100);
}

}  // namespace
}  // namespace proveout
