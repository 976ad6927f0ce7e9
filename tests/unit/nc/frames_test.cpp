#include "core/nc/kinematics/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace proveout::nc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << " instead of " << b.transpose();
}

// Digest nct-2, 6.4: p = (100,50,20), no offsets.
TEST(Frames, BasicRotationTurnsAboutXThenYThenZ) {
  const Vec3 p(100, 50, 20);
  expectNear(basicRotation({0, 0, 30}) * p, {61.602540, 93.301270, 20}, 1e-6);
  expectNear(basicRotation({0, 30, 0}) * p, {96.602540, 50, -32.679492}, 1e-6);
  expectNear(basicRotation({30, 0, 0}) * p, {100, 33.301270, 42.320508}, 1e-6);
  expectNear(basicRotation({90, 90, 0}) * p, {50, -20, -100}, 1e-6);
  expectNear(basicRotation({10, 20, 30}) * p, {66.901734, 91.473403, -7.534887}, 1e-6);
}

TEST(Frames, ChainAndInverseAgree) {
  WorkFrames frames;
  frames.common.offset = {1, 2, 3};
  frames.basic[2] = {{300, 800, -50}, {10, 20, 30}};
  frames.shift52 = {5, 6, 7};
  frames.shift92 = {-8, 9, 10};
  const CoordinateChain chain = frames.chain({}, 3, {0, 0, 120});
  const Vec3 p(12.5, -7.25, 3.125);
  const Vec3 machine = chain.toMachine(p);
  expectNear(machine, basicRotation({10, 20, 30}) * (p + Vec3(-3, 15, 17)) + Vec3(301, 802, 73), 1e-12);
  expectNear(chain.toProgram(machine), p, 1e-12);
}

TEST(Frames, PureShiftsStayExact) {
  WorkFrames frames;
  frames.basic[0].offset = {0.1, 0.2, 0.3};
  const CoordinateChain chain = frames.chain({}, 1, Vec3::Zero());
  EXPECT_EQ(chain.toMachine({1, 2, 3}), Vec3(1.1, 2.2, 3.3));
}

// Rotation in a plane of any two axes, mirrored and scaled, against the formulas of the manual's chapter 16.
TEST(Frames, PlanesOfFurtherAxesRotateAndComeBack) {
  ControlSettings settings;
  AxisSettings u, v;
  u.name = "U";
  v.name = "V";
  u.number = 4;
  v.number = 5;
  u.kind = v.kind = AxisKind::kLinear;
  u.parallel = "X";
  v.parallel = "Y";
  settings.axes = {u, v};
  const AxisTable axes(settings);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(-50, 50), degrees(-400, 400);
  for (int round = 0; round < 200; ++round) {
    Transforms t;
    t.rotates = true;
    t.rotation_u = static_cast<std::int8_t>(round % 2 == 0 ? 0 : 3);
    t.rotation_v = 4;
    t.pivot = {length(random), length(random)};
    t.angle_deg = degrees(random);
    t.scales = round % 3 != 0;
    t.scales_further = true;
    t.factors = Vec3::Constant(0.5 + 0.01 * (round % 100));
    t.rotation_inside = round % 5 == 0;
    if (round % 4 == 0) t.mirrored.set(4);
    t.mirror[4] = length(random);
    AxisPoint p(length(random), length(random), length(random));
    for (int axis = 0; axis < 5; ++axis) {
      p[axis] = length(random);
      t.scale_center[axis] = length(random);
    }
    WorkFrames frames;
    frames.more_axes = 2;
    frames.basic[0].offset = AxisPoint(3, 4, 5);
    frames.shift92[4] = length(random);
    frames.shift52[0] = length(random);
    const ProgramMap map = programMap(t, axes);
    const CoordinateChain chain = frames.chain(map, 1, AxisPoint());
    EXPECT_TRUE(chain.turns());

    AxisPoint expected = p;
    const auto scale = [&] {
      for (int axis = 0; axis < 5 && t.scales; ++axis)
        expected[axis] = t.scale_center[axis] + t.factors.x() * (expected[axis] - t.scale_center[axis]);
    };
    if (!t.rotation_inside) scale();
    const double du = expected[t.rotation_u] - t.pivot.x(), dv = expected[t.rotation_v] - t.pivot.y();
    const double c = std::cos(degToRad(t.angle_deg)), s = std::sin(degToRad(t.angle_deg));
    expected[t.rotation_u] = t.pivot.x() + du * c - dv * s;
    expected[t.rotation_v] = t.pivot.y() + du * s + dv * c;
    if (t.rotation_inside) scale();
    if (t.mirrored[4]) expected[4] = 2.0 * t.mirror[4] - expected[4];
    for (int axis = 0; axis < 5; ++axis) {
      EXPECT_NEAR(map.image(p)[axis], expected[axis], 1e-10) << round << " axis " << axis;
      expected[axis] += frames.shift92[axis] + frames.shift52[axis] + frames.basic[0].offset[axis];
      EXPECT_NEAR(chain.machineOf(p)[axis], expected[axis], 1e-10) << round << " axis " << axis;
    }
    const AxisPoint back = chain.programOf(chain.machineOf(p));
    for (int axis = 0; axis < 5; ++axis) EXPECT_NEAR(back[axis], p[axis], 1e-9) << round << " axis " << axis;
  }
}

TEST(Frames, UnknownExtendedSystemIsZero) {
  const WorkFrames frames;
  EXPECT_EQ(frames.system(kFirstExtended + 41).offset, Vec3::Zero());
}

}  // namespace
}  // namespace proveout::nc
