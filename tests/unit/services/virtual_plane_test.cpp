// Planes with a rotary axis and turns of one, against slow references.
#include "core/nc/services/virtual_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/nc/services/rollover.h"

namespace proveout {
namespace {

TEST(VirtualPlane, ArcsTurnAsTheirPointsDo) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-20, 20), angle(-15, 15);
  int seen = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec2 from(coordinate(random), coordinate(random)), center(coordinate(random), coordinate(random));
    const double sweep = angle(random);
    const double r = (from - center).norm();
    if (std::abs(r - center.norm()) < 0.5) continue;  // passes near the origin: the sum below is coarse
    const double a = std::atan2(from.y() - center.y(), from.x() - center.x());
    const auto at = [&](double t) {
      return Vec2(center.x() + r * std::cos(a + sweep * t), center.y() + r * std::sin(a + sweep * t));
    };
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const Vec2 p = at(static_cast<double>(i) / kSteps), q = at(static_cast<double>(i + 1) / kSteps);
      sum += std::remainder(std::atan2(q.y(), q.x()) - std::atan2(p.y(), p.x()), 2 * kPi);
    }
    EXPECT_NEAR(turnOfArc(from, at(1.0), center, sweep), sum, 1e-9) << k;
    ++seen;
  }
  EXPECT_GT(seen, 150);
  EXPECT_DOUBLE_EQ(turnOfLine({1, 0}, {0, 5}), kPi / 2);
  EXPECT_DOUBLE_EQ(turnOfLine({1, 0}, {-1, 0}), kPi);
}

TEST(VirtualPlane, FeedDropsNearTheCentreAsIntegrated) {
  const Vec2 from(-8, 0.3), to(12, 0.5);
  for (const double rate : {5.0, 60.0, 1e4}) {
    double minutes = 0;
    constexpr int kSteps = 400000;
    const Vec2 step = (to - from) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const Vec2 p = from + (i + 0.5) * step;
      const double turn = std::abs(p.x() * step.y() - p.y() * step.x()) / p.squaredNorm();
      minutes += std::max(step.norm() / 500.0, turn / rate);
    }
    EXPECT_NEAR(polarLineMinutes(from, to, 500.0, rate), minutes, 1e-7 * minutes) << rate;
  }
  EXPECT_DOUBLE_EQ(polarLineMinutes({1, 0}, {3, 0}, 500.0, 1.0), 2.0 / 500.0);
  EXPECT_NEAR(polarLineMinutes({-1, 0}, {3, 0}, 500.0, 2.0), 4.0 / 500.0 + kPi / 2.0, 1e-12);
  EXPECT_NEAR(polarLineMinutes({-1, 1e-13}, {3, 1e-13}, 500.0, 2.0), 4.0 / 500.0 + kPi / 2.0, 1e-6);
  EXPECT_DOUBLE_EQ(polarLineMinutes({1, 0}, {1, 0}, 500.0, 1.0), 0.0);
}

TEST(VirtualPlane, ChordsKeepTheirTolerance) {
  const auto at = [](double t) { return Vec3(50 * std::cos(9 * t), 30 * std::sin(9 * t), 4 * t); };
  double last = 0, worst = 0;
  int count = 0;
  divideCurve(at, 64, 1e-3, [&](double t) {
    for (int i = 1; i < 10; ++i) {
      const double s = last + (t - last) * i / 10;
      const Vec3 a = at(last), b = at(t), p = at(s);
      const Vec3 d = (b - a).normalized();
      worst = std::max(worst, ((p - a) - d * d.dot(p - a)).norm());
    }
    last = t;
    ++count;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_LT(worst, 1.05e-3);
  EXPECT_GT(worst, 1e-4);
  EXPECT_LT(count, 2000);
}

TEST(Rollover, TravelsOfTheManual) {
  const RolloverRule basic{true, false, false, 360}, shortest{true, true, false, 360},
      sign{true, false, true, 360};
  EXPECT_EQ(rolloverTravel(0, 930, basic), 210);
  EXPECT_EQ(rolloverTravel(0, -930, basic), -210);
  EXPECT_EQ(rolloverTravel(0, 570, shortest), -150);
  EXPECT_EQ(rolloverTravel(0, -570, shortest), 150);
  EXPECT_EQ(rolloverTravel(0, 180, shortest), 180);
  EXPECT_EQ(rolloverTravel(0, -180, shortest), 180);
  EXPECT_EQ(rolloverTravel(0, 750, sign), 30);
  EXPECT_EQ(rolloverTravel(0, -750, sign), -330);
  EXPECT_EQ(rolloverTravel(30, 0, sign), 330);
  EXPECT_EQ(rolloverTravel(30, -0.0, sign), 330);
  EXPECT_EQ(rolloverTravel(30, -360, sign), -30);
  EXPECT_EQ(rolloverTravel(-690, 0, basic), -30);  // that is 30 as shown
  EXPECT_EQ(rolloverTravel(10, 750, RolloverRule{}), 740);
  EXPECT_EQ(rolloverStep(-750, basic), -30);
  EXPECT_EQ(rolloverStep(-750, RolloverRule{}), -750);
}

}  // namespace
}  // namespace proveout
