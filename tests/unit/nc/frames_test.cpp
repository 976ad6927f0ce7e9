#include "core/nc/frames.h"

#include <gtest/gtest.h>

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

TEST(Frames, UnknownExtendedSystemIsZero) {
  const WorkFrames frames;
  EXPECT_EQ(frames.system(kFirstExtended + 41).offset, Vec3::Zero());
}

}  // namespace
}  // namespace proveout::nc
