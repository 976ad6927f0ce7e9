// Ways of tools whose axis turns: the manual's poses (25.14, 25.16), derivatives and their bounds.
#include "core/path/posed_way.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "tests/support/posed_motions.h"
#include "tests/support/test_machines.h"

namespace proveout {
namespace posed_way_test {
namespace {

using namespace test;  // NOLINT

void expectNear(const Vec3& a, const Vec3& b, double most = 9e-5) {
  EXPECT_LT((a - b).norm(), most) << a.transpose() << " for " << b.transpose();
}

TEST(PosedWay, AxesGoLinearly) {
  // 25.14, N30 without tool centre point control.
  const PosedWay cb = axesMotion(test::machineCB(), axesAt({185, -60, 56.5064}, 0, 30),
                                 axesAt({236.7767, 60, 16.7767}, 0, 45), 100)
                          .way();
  expectNear(cb.at(0.5).tip, {58.6980, 0, -11.6968}, 1e-4);
  expectNear(cb.at(0.0).tip, {60, -60, -10}, 1e-4);
}

TEST(PosedWay, VectorsTurnInOnePlane) {
  // 25.16, the pyramid's N40.
  const PosedWay way = vectorMotion({100, 100, 0}, {0, 100, 0}, {-20, -20, 40}, {20, -20, 40}).way();
  expectNear(way.at(0.25).axis, {-0.2087, -0.4374, 0.8747});
  expectNear(way.at(0.5).axis, {0, -0.4472, 0.8944});
  expectNear(way.at(0.5).tip, {50, 100, 0});
}

TEST(PosedWay, ConesFollowTheArc) {
  // 25.16, the cone's N50; the same thrice round.
  for (const int turns : {0, 2}) {
    PosedMotion c = vectorMotion({100, 0, 0}, {0, 100, 0}, {-20, 0, 40}, {0, -20, 40});
    c.is_arc = true;
    c.arc.sweep_rad = (0.5 + 2.0 * turns) * kPi;
    c.axis.law = PoseLaw::kCone;
    const double share = 0.125 * kPi / std::abs(c.arc.sweep_rad);
    const PosedWay way = c.way();
    expectNear(way.at(share).tip, {92.3880, 38.2683, 0});
    expectNear(way.at(share).axis, {-0.4132, -0.1711, 0.8944});
    expectNear(way.at(1.0).axis, Vec3(0, -20, 40).normalized());
  }
}

TEST(PosedWay, AToolTakenForLongerThanItIsStaysBack) {
  PosedMotion c = vectorMotion({0, 0, 10}, {10, 0, 10}, {0, 0, 1}, {1, 0, 0});
  auto pose = std::make_shared<PoseSweep>();
  pose->beyond = 2.0;
  c.axis.pose = pose;
  c.motion.from += 2.0 * c.axis.from;
  c.motion.to += 2.0 * c.axis.to;
  const ToolPose middle = c.way().at(0.5);
  expectNear(middle.tip, Vec3(5, 0, 10) + 2.0 * Vec3(1, 0, 1).normalized(), 1e-12);
  EXPECT_TRUE(c.axis.tipLeaves());
}

/// Motions of every law.
std::vector<PosedMotion> cases() {
  std::vector<PosedMotion> out;
  std::mt19937_64 engine{20261129};
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto point = [&](double most) {
    return Vec3(random(-most, most), random(-most, most), random(-most, most));
  };
  const auto direction = [&] { return Vec3(random(-1, 1), random(-1, 1), random(0.3, 1)); };
  for (int i = 0; i < 60; ++i) {
    const MachineModel machine = i % 3 == 0   ? test::headHead('B', {10, 0, 150}, {0, 25, 60})
                                 : i % 3 == 1 ? test::trunnion('A')
                                              : test::headTable();
    PosedMotion axes = axesMotion(machine, axesAt(point(100), random(-90, 90), random(-200, 200)),
                                  axesAt(point(100), random(-90, 90), random(-1500, 1500)), random(0, 150));
    PosedMotion tip = axes;
    tip.axis.law = PoseLaw::kTip;
    PosedMotion vector = vectorMotion(point(50), point(50), direction(), direction());
    PosedMotion cone = vector;
    cone.is_arc = true;
    cone.arc = {point(20), Vec3::UnitZ(), random(-9, 9)};
    cone.axis.law = PoseLaw::kCone;
    PosedMotion spiral = tip;
    spiral.is_arc = true;
    spiral.arc = {tip.motion.from + point(20), direction().normalized(), random(-9, 9)};
    auto pose = std::make_shared<PoseSweep>(*tip.axis.pose);
    pose->beyond = random(-3, 3);
    spiral.axis.pose = pose;
    out.insert(out.end(), {axes, tip, vector, cone, spiral});
  }
  return out;
}

TEST(PosedWay, EndsAreThoseOfTheMotion) {
  for (const PosedMotion& c : cases()) {
    const PosedWay way = c.way();
    expectNear(way.at(0.0).tip, c.motion.from, 1e-9);
    expectNear(way.at(0.0).axis, c.axis.from, 1e-9);
    expectNear(way.at(1.0).axis, c.axis.to, 1e-9);
    if (!c.is_arc) expectNear(way.at(1.0).tip, c.motion.to, 1e-9);
  }
}

TEST(PosedWay, DerivativesAreThoseOfDifferencesAndKeepTheirBounds) {
  constexpr double kStep = 1e-5;
  for (const PosedMotion& c : cases()) {
    const PosedWay way = c.way();
    for (int k = 0; k < 10; ++k) {
      const double low = 0.1 * k, high = low + 0.1, t = low + 0.063;
      const PosedWay::Moving m = way.movingAt(t);
      const ToolPose a = way.at(t - kStep), b = way.at(t + kStep);
      const PosedWay::Bounds bounds = way.boundsOn(low, high);
      const double scale = 1.0 + bounds.tip.acceleration;
      EXPECT_LT((m.rates.tip - (b.tip - a.tip) / (2 * kStep)).norm(), 1e-7 * scale * 10);
      EXPECT_LT((m.rates.axis - (b.axis - a.axis) / (2 * kStep)).norm(),
                1e-6 * (1 + bounds.axis.acceleration));
      EXPECT_LE(m.rates.tip.norm(), bounds.tip.velocity * (1 + 1e-12));
      EXPECT_LE(m.rates.axis.norm(), bounds.axis.velocity * (1 + 1e-12));
      const Vec3 tip2 = (way.movingAt(t + kStep).rates.tip - way.movingAt(t - kStep).rates.tip) / (2 * kStep);
      const Vec3 axis2 =
          (way.movingAt(t + kStep).rates.axis - way.movingAt(t - kStep).rates.axis) / (2 * kStep);
      EXPECT_LE(tip2.norm(), bounds.tip.acceleration * (1 + 1e-5) + 1e-4);
      EXPECT_LE(axis2.norm(), bounds.axis.acceleration * (1 + 1e-5) + 1e-4);
      const Box3 box = way.tipBounds(low, high).inflated(1e-9);
      EXPECT_TRUE((box.min.array() <= m.pose.tip.array()).all() &&
                  (box.max.array() >= m.pose.tip.array()).all());
    }
  }
}

TEST(PosedWay, LengthIsThatOfManyChords) {
  for (const PosedMotion& c : cases()) {
    const PosedWay way = c.way();
    constexpr int kChords = 20000;
    double sum = 0.0;
    Vec3 last = way.at(0.0).tip;
    for (int k = 1; k <= kChords; ++k) {
      const Vec3 p = way.at(static_cast<double>(k) / kChords).tip;
      sum += (p - last).norm();
      last = p;
    }
    EXPECT_NEAR(way.length(), sum, 4e-6 * sum + 1e-5);
  }
}

TEST(PosedWay, ThePathKnowsTipsThatLeaveTheirLine) {
  const PosedMotion c = axesMotion(test::machineCB(), axesAt({185, -60, 56.5064}, 0, 30),
                                   axesAt({236.7767, 60, 16.7767}, 0, 45), 100);
  Toolpath path;
  ToolpathBuilder(path).motion(c.motion, nullptr, &c.axis);
  const Motion& m = path.motions[0];
  expectNear(path.pointAt(m, 0.5), {58.6980, 0, -11.6968}, 1e-4);
  EXPECT_LT(path.bounds(m).min.x(), 58.6981);
  EXPECT_GT(path.length(m), (m.to - m.from).norm() + 0.01);
}

}  // namespace
}  // namespace posed_way_test
}  // namespace proveout
