// Which loops of two heights are one wall.
#include "removal/wire/lean/level_match.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

LevelLoop loopOf(const std::vector<Vec2>& points, const std::vector<WallName>& names) {
  return {points, names, std::vector<MotionId>(points.size(), 0)};
}

/// A slug and what is around it, both with some of a start hole's border (name 9), the other with many bits
/// of it: it is the length under common names that counts.
TEST(LevelMatch, LoopsThatShareABorderInManyPlaces) {
  LevelSection section;
  std::vector<Vec2> comb;
  std::vector<WallName> names;
  for (int k = 0; k < 5; ++k) {
    comb.emplace_back(0.1 * k, 0.0);
    names.push_back(9);
    comb.emplace_back(0.1 * k + 0.05, 0.0);
    names.push_back(20 + static_cast<WallName>(k));
  }
  comb.emplace_back(0.5, 3.0);
  names.push_back(1);
  section.loops.push_back(loopOf(comb, names));
  section.loops.push_back(loopOf({{2, 0}, {3, 0}, {3, 4}}, {9, 338, 338}));
  const LoopPairs pairs = pairLoops(section, section);
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{{0, 0}, {1, 1}};
  EXPECT_EQ(pairs.pairs, expected);
  EXPECT_TRUE(pairs.lower_alone.empty() && pairs.upper_alone.empty());
}

}  // namespace
}  // namespace proveout
