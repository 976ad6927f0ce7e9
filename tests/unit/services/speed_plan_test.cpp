// Look-ahead of speeds against closed forms and against a slow reference on a fine grid.
#include "core/nc/services/speed_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace proveout::nc {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

double totalTime(const std::vector<SpeedElement>& path) {
  std::vector<double> speeds;
  planSpeeds(path, 0.0, speeds);
  double sum = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) sum += elementTime(path[i], speeds[i], speeds[i + 1]);
  return sum;
}

TEST(SpeedPlan, OneLongLineIsATrapezoid) {
  // 100 mm at 50 mm/s with 500 mm/s^2: two ramps of 0.1 s and 2.5 mm, 95 mm between them.
  EXPECT_NEAR(totalTime({{100, 50, 500, 0}}), 0.2 + 95.0 / 50.0, 1e-12);
}

TEST(SpeedPlan, AShortLineIsATriangle) {
  EXPECT_NEAR(totalTime({{1, 50, 500, 0}}), 2 * std::sqrt(1.0 / 500), 1e-12);
}

TEST(SpeedPlan, WithoutAccelerationItIsLengthBySpeed) {
  EXPECT_DOUBLE_EQ(totalTime({{100, 50, kAny, 0}, {30, 10, kAny, 0}}), 2.0 + 3.0);
}

TEST(SpeedPlan, AStraightPathInPiecesTakesNoLonger) {
  std::vector<SpeedElement> pieces(1000, SpeedElement{0.1, 50, 500, kAny});
  EXPECT_NEAR(totalTime(pieces), totalTime({{100, 50, 500, 0}}), 1e-9);
}

TEST(SpeedPlan, PassesACornerAtItsSpeed) {
  // Down from 50 to 20 mm/s: 2.1 mm and 0.06 s, and up again; 2.5 mm and 0.1 s at the ends.
  const double expected = 2 * (0.1 + 0.06 + (100 - 2.5 - 2.1) / 50.0);
  EXPECT_NEAR(totalTime({{100, 50, 500, 0}, {100, 50, 500, 20}}), expected, 1e-12);
}

TEST(SpeedPlan, BrakesInEarlierElementsForALowerFeed) {
  // The second begins at its own 10 mm/s (manual chapter 7); the slow-down lies in the first.
  std::vector<double> speeds;
  const std::vector<SpeedElement> path{{100, 50, 500, 0}, {10, 10, 500, kAny}};
  planSpeeds(path, 0.0, speeds);
  EXPECT_DOUBLE_EQ(speeds[1], 10.0);
}

/// The fastest speed over a fine grid of the path: bound from both ends, cell by cell.
double referenceTime(const std::vector<SpeedElement>& path, double step) {
  struct Cell {
    double length, speed, acceleration, entry;
  };
  std::vector<Cell> cells;
  for (const SpeedElement& e : path) {
    const int n = std::max(1, static_cast<int>(e.length / step));
    for (int k = 0; k < n; ++k)
      cells.push_back({e.length / n, e.speed, e.acceleration, k == 0 ? e.entry : kAny});
  }
  std::vector<double> v(cells.size() + 1, 0.0);
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const double cap = std::min({cells[i].entry, cells[i].speed, cells[i - 1].speed});
    v[i] =
        std::min(cap, std::sqrt(v[i - 1] * v[i - 1] + 2 * cells[i - 1].acceleration * cells[i - 1].length));
  }
  double sum = 0.0;
  for (std::size_t i = cells.size(); i-- > 0;) {
    v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2 * cells[i].acceleration * cells[i].length));
    sum += 2 * cells[i].length / (v[i] + v[i + 1]);
  }
  return sum;
}

TEST(SpeedPlan, AgreesWithASlowReference) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(0.05, 5.0), speed(5.0, 100.0), acceleration(100.0, 2000.0);
  for (int run = 0; run < 20; ++run) {
    std::vector<SpeedElement> path;
    for (int k = 0; k < 60; ++k) {
      path.push_back({length(random), speed(random), acceleration(random), run % 2 ? kAny : speed(random)});
    }
    path.front().entry = 0.0;
    const double expected = referenceTime(path, 2e-4);
    EXPECT_NEAR(totalTime(path), expected, 2e-3 * expected);
  }
}

}  // namespace
}  // namespace proveout::nc
