// Long sections: what a change costs and leaves, meshes of many short lines, and the axis.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "removal/exact/swept_part.h"
#include "removal/turning/section/revolve.h"
#include "removal/turning/section/section_area.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

SectionPath box(double r0, double r1, double z0, double z1) {
  return {{r0, z0}, {r1, z0}, {r1, z1}, {r0, z1}};
}

SectionLoop barLoop(double radius, double length) {
  SectionLoop loop;
  loop.points = {{0, -length}, {radius, -length}, {radius, 0}, {0, 0}};
  loop.motion.assign(4, kNoMotion);
  return loop;
}

/// A bar with `count` steps of 10 micrometres in radius and z.
SectionArea stairs(int count) {
  SectionArea area({barLoop(30, 100)});
  for (int i = 0; i < count; ++i)
    area.subtract({box(20 + 0.001 * i, 40, -0.01 * (i + 1), 1)}, static_cast<MotionId>(i));
  return area;
}

TEST(LongSection, StepsKeepVolumeAndMotions) {
  constexpr int kCount = 2000;
  const SectionArea area = stairs(kCount);
  double volume = kPi * 900 * (100 - 0.01 * kCount);
  for (int i = 0; i < kCount; ++i) volume += kPi * std::pow(20 + 0.001 * i, 2) * 0.01;
  EXPECT_NEAR(area.volume() / volume, 1.0, 1e-12);
  const std::vector<SectionBody> bodies = area.bodies();
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_NEAR(bodies[0].volume_mm3 / volume, 1.0, 1e-12);
  std::size_t treads = 0;
  const SectionLoop& loop = bodies[0].loops[0];
  for (std::size_t k = 0; k < loop.points.size(); ++k) {
    const Vec2 &a = loop.points[k], &b = loop.points[(k + 1) % loop.points.size()];
    if (a.x() != b.x() || a.x() == 0.0 || a.x() == 30.0) continue;
    EXPECT_EQ(loop.motion[k], static_cast<MotionId>(std::lround((a.x() - 20) / 0.001)));
    ++treads;
  }
  EXPECT_EQ(treads, static_cast<std::size_t>(kCount));
}

/// Sweeps far from all edges, through long ones, and such that fall apart, against closed forms.
TEST(LongSection, SweepsDeepInsideAndAcross) {
  SectionArea area = stairs(1000);
  const double before = area.volume();
  EXPECT_NEAR(area.subtract({box(5, 6, -60, -50)}, 2000), kPi * 11 * 10, 1e-6);  // a hollow
  EXPECT_FALSE(area.apart());
  EXPECT_NEAR(area.subtract({box(4, 7, -58, -52)}, 2001), kPi * (49 - 16 - 11) * 6, 1e-6);  // beyond it
  EXPECT_EQ(area.subtract({box(40, 50, -60, -50)}, 2002), 0.0);
  EXPECT_EQ(area.subtract({box(5.2, 5.8, -59, -51)}, 2003), 0.0);  // in the hollow
  EXPECT_NEAR(area.volume(), before - kPi * (110 + 132), 1e-6);
  area.subtract({box(-1, 50, -30, -29)}, 2004);
  EXPECT_TRUE(area.apart());
  EXPECT_EQ(area.bodies().size(), 2u);
}

/// A long section in pieces and the same section cut whole must agree.
TEST(LongSection, RandomCutsAgreeWithOneCut) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> z(-98, 0), r(12, 31), size(0.02, 6);
  SectionArea steps({barLoop(30, 100)}), whole({barLoop(30, 100)});
  std::vector<SectionPath> all;
  for (int i = 0; i < 400; ++i) {
    const double a = r(random), b = z(random), w = size(random), h = size(random);
    SectionPath path{{a, b}, {a + 0.7 * w, b - 0.3 * h}, {a + w + 4, b + 0.4 * h}, {a + 0.3 * w, b + h}};
    steps.subtract({path}, static_cast<MotionId>(i));
    all.push_back(std::move(path));
  }
  whole.subtract(all, 1);
  EXPECT_NEAR(steps.volume() / whole.volume(), 1.0, 1e-6);
  EXPECT_NEAR(steps.max().x(), whole.max().x(), 1e-5);
}

TEST(LongSection, MeshHasNoRingsWhereNothingChanges) {
  // A cylinder in 4,000 lines of 5 micrometres behind one of 40 mm.
  SectionArea area({barLoop(30, 100)});
  area.subtract({box(20, 40, -40, 1)}, 0);
  for (int i = 0; i < 4000; ++i)
    area.subtract({box(20, 40, -40 - 0.005 * (i + 1), -39)}, static_cast<MotionId>(i + 1));
  const std::vector<SectionBody> bodies = area.bodies();
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_GT(bodies[0].loops[0].points.size(), 4000u);
  const SectionLoop loop = simplified(bodies[0].loops[0], 1e-3);
  EXPECT_LE(loop.points.size(), 8u);
  const TriMesh mesh = revolved(bodies, 1e-3);
  EXPECT_LT(mesh.triangles.size(), 10000u);
  EXPECT_NEAR(meshVolume(mesh) / bodies[0].volume_mm3, 1.0, 2e-4);
}

TEST(LongSection, LongMotionsKeepTheirBordersInTheMesh) {
  SectionArea area({barLoop(30, 100)});
  area.subtract({box(20, 40, -40, 1)}, 3);
  area.subtract({box(20, 40, -70, -39)}, 4);
  const SectionLoop loop = simplified(area.bodies()[0].loops[0], 1e-3);
  bool border = false;
  for (std::size_t k = 0; k < loop.points.size(); ++k)
    border |= (loop.points[k] - Vec2(20, -40)).norm() < 1e-6;
  EXPECT_TRUE(border);
}

/// On the axis there is material where the section has some, and the way out is exact.
TEST(TurnedPart, TheAxisIsNoSurface) {
  auto shape = std::make_shared<TurnedShape>();
  SectionArea area({barLoop(10, 20)});
  area.subtract({box(0.05, 20, -0.4, 1)}, 1);  // a pip of 0.1 x 0.4 on the face
  shape->bodies = area.bodies();
  const auto part = makeTurnedPart(shape);
  ASSERT_TRUE(part);
  EXPECT_NEAR((*part)->at({0, 0, -0.3}, 1.0).value, -0.05, 1e-9);
  EXPECT_NEAR((*part)->at({0, 0, -10}, 20.0).value, -9.6, 0.05);
  EXPECT_NEAR((*part)->at({0, 0, 0.2}, 1.0).value, 0.2, 1e-9);
  const ExactPart::Sample beside = (*part)->at({3, 4, 0.0}, 1.0);
  EXPECT_NEAR(beside.value, 0.4, 1e-9);
  EXPECT_NEAR(beside.normal.z(), 1.0, 1e-9);
  // Nearest to a corner: the way there, and no face's normal.
  const ExactPart::Sample corner = (*part)->at({0.35, 0, 0.4}, 1.0);
  EXPECT_NEAR(corner.value, 0.5, 1e-9);
  EXPECT_NEAR((corner.normal - Vec3(0.6, 0, 0.8)).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace proveout
