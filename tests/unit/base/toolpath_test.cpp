#include "core/path/toolpath.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace proveout {
namespace {

/// A path of one motion on an arc whose ends follow from the frame, so that they are consistent.
struct ArcCase {
  Toolpath path;
  ArcCase(const Vec3& axis_point, const Vec3& normal, const Vec3& u, double r0, double r1, double rise,
          double sweep) {
    const Vec3 v = normal.cross(u);
    Motion m;
    m.kind = MotionKind::kFeed;
    m.from = axis_point + r0 * u;
    m.to = axis_point + r1 * (std::cos(sweep) * u + std::sin(sweep) * v) + rise * normal;
    const ArcGeometry arc{axis_point, normal, sweep};
    ToolpathBuilder(path).motion(m, &arc);
  }
  const Motion& motion() const { return path.motions[0]; }
};

Box3 sampledBounds(const ArcCase& c, int samples) {
  Box3 box;
  for (int i = 0; i <= samples; ++i) box.extend(c.path.pointAt(c.motion(), static_cast<double>(i) / samples));
  return box;
}

double sampledLength(const ArcCase& c, int samples) {
  double sum = 0.0;
  Vec3 last = c.path.pointAt(c.motion(), 0.0);
  for (int i = 1; i <= samples; ++i) {
    const Vec3 p = c.path.pointAt(c.motion(), static_cast<double>(i) / samples);
    sum += (p - last).norm();
    last = p;
  }
  return sum;
}

TEST(Toolpath, ArcMeetsItsEndsAndTurnsByTheRightHand) {
  const ArcCase quarter({10, 20, 5}, Vec3::UnitZ(), Vec3::UnitX(), 4, 4, 0, kPi / 2);
  EXPECT_LT((quarter.motion().to - Vec3(10, 24, 5)).norm(), 1e-12);
  EXPECT_LT((quarter.path.pointAt(quarter.motion(), 0.0) - Vec3(14, 20, 5)).norm(), 1e-12);
  EXPECT_LT((quarter.path.pointAt(quarter.motion(), 1.0) - Vec3(10, 24, 5)).norm(), 1e-12);
  const double h = 4 * std::sqrt(0.5);
  EXPECT_LT((quarter.path.pointAt(quarter.motion(), 0.5) - Vec3(10 + h, 20 + h, 5)).norm(), 1e-12);
  EXPECT_NEAR(quarter.path.length(quarter.motion()), 2 * kPi, 1e-12);
}

TEST(Toolpath, SpiralFromItsAxisTakesDirectionFromItsEnd) {
  for (const double r0 : {0.0, 1e-13}) {
    const ArcCase c({1, 2, 3}, Vec3::UnitZ(), Vec3(0.6, 0.8, 0), 0.0, 5, 0, 7.5);
    Toolpath path = c.path;
    path.motions[0].from += Vec3(0, -r0, 0);  // rounding noise in another direction
    EXPECT_LT((path.pointAt(path.motions[0], 1.0) - c.motion().to).norm(), 1e-9);
    EXPECT_LT((path.pointAt(path.motions[0], 0.5) - c.path.pointAt(c.motion(), 0.5)).norm(), 1e-9);
  }
}

TEST(Toolpath, BoundsAreTightAgainstDenseSampling) {
  std::mt19937 random(20240611);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const bool tilted = i % 2, spiral = i % 3 == 1, helix = i % 5 > 1;
    const Vec3 n = tilted ? Vec3(unit(random), unit(random), unit(random)).normalized() : Vec3(Vec3::UnitZ());
    const Vec3 u = Eigen::AngleAxisd(unit(random) * kPi, n) * n.unitOrthogonal();
    const double r0 = i % 7 == 0 ? 0.0 : 6 + 5 * unit(random);
    const double r1 = spiral ? 6 + 5 * unit(random) : r0;
    const ArcCase c({unit(random), unit(random), unit(random)}, n, u, r0, r1, helix ? 8 * unit(random) : 0.0,
                    unit(random) * (i % 4 ? 7 : 40));
    const Box3 exact = c.path.bounds(c.motion());
    const Box3 sampled = sampledBounds(c, 20000);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(exact.max[axis], sampled.max[axis] - 1e-9) << "case " << i;
      EXPECT_LE(exact.min[axis], sampled.min[axis] + 1e-9) << "case " << i;
      EXPECT_LE(exact.max[axis], sampled.max[axis] + 2e-4) << "case " << i;
      EXPECT_GE(exact.min[axis], sampled.min[axis] - 2e-4) << "case " << i;
    }
  }
}

TEST(Toolpath, BoundsOfAMillionTurnsComeAtOnce) {
  const ArcCase c({0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX(), 3, 5, -2, 2 * kPi * 1e6);
  const Box3 box = c.path.bounds(c.motion());
  EXPECT_NEAR(box.max.y(), 5, 1e-5);
  EXPECT_NEAR(box.min.x(), -5, 1e-5);
  EXPECT_NEAR(box.min.z(), -2, 1e-9);
}

TEST(Toolpath, LengthsAgreeWithChords) {
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ(), o = Vec3::Zero();
  for (const double sweep : {0.3, -5.0, 40.0}) {
    for (const double r1 : {5.0, 5.001, 5.2, 9.0, 0.0}) {
      for (const double rise : {0.0, 3.0}) {
        const ArcCase c(o, z, x, 5, r1, rise, sweep);
        const double chords = sampledLength(c, 400000);
        EXPECT_NEAR(c.path.length(c.motion()) / chords, 1.0, 2e-9) << sweep << " " << r1 << " " << rise;
      }
    }
  }
  // Archimedean spiral from its axis, r = a * angle: closed form a/2 (t sqrt(1+t^2) + asinh t).
  const double t = 20 * kPi, a = 5 / t;
  const ArcCase c(o, z, x, 0, 5, 0, t);
  EXPECT_NEAR(c.path.length(c.motion()), a / 2 * (t * std::sqrt(1 + t * t) + std::asinh(t)), 1e-9);
}

TEST(Toolpath, LinesAreStraight) {
  Toolpath path;
  Motion m;
  m.from = {1, 2, 3};
  m.to = {4, -2, 3};
  m.arc = 12;  // the builder trusts its second argument only
  ToolpathBuilder builder(path);
  builder.file(1, "sub");
  builder.file(0, "main");
  builder.event({event::Dwell{2.0}, 2.0, {}});
  builder.motion(m, nullptr);
  EXPECT_EQ(path.motions[0].shape(), MotionShape::kLine);
  EXPECT_DOUBLE_EQ(path.length(path.motions[0]), 5.0);
  EXPECT_EQ(path.pointAt(path.motions[0], 0.5), Vec3(2.5, 0, 3));
  EXPECT_EQ(path.bounds(path.motions[0]).min, Vec3(1, -2, 3));
  EXPECT_EQ(path.files, (std::vector<std::string>{"main", "sub"}));
  EXPECT_EQ(path.events[0].before, 0u);
}

}  // namespace
}  // namespace proveout
