// Faces where walls of a leaning wire's cut meet.
#include "removal/wire/lean/level_step.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

LevelSection sectionOf(double z, const std::vector<Vec2>& points) {
  LevelSection section;
  section.z = z;
  section.loops.push_back(
      {points, std::vector<WallName>(points.size(), 0), std::vector<MotionId>(points.size(), 0)});
  section.regions.push_back({{0}});
  return section;
}

/// A needle whose tip the section below lacks: its corner there lies on both sides of the one above, by less
/// than the floats tell apart. Beyond it both walls would be one.
TEST(LevelStep, TheTipOfANeedleEndsWhereBothItsSidesMeet) {
  const LevelSection lower = sectionOf(0.0, {{0, 0}, {5, 0.0000005}, {0, 1}}),
                     upper = sectionOf(0.0005, {{0, 0}, {5.0001, 0}, {5, 0.000001}, {0, 1}});
  const auto step = levelStep(lower, {0}, upper, {0});
  ASSERT_TRUE(step.has_value());
  for (const LevelStep::Chains& chains : {step->lower.front(), step->upper.front()}) {
    for (std::size_t k = 0; k < chains.size(); ++k) {
      const auto &to = chains[k], &from = chains[(k + 1) % chains.size()];
      EXPECT_EQ(to.back(), from.front());
      if (to.size() < 2 || from.size() < 2) continue;
      EXPECT_NE(to[to.size() - 2], from[1]);
    }
  }
}

}  // namespace
}  // namespace proveout
