// Sections without places that a mesh cannot hold.
#include "removal/wire/lean/thin_places.h"

#include <gtest/gtest.h>

#include "removal/wire/section/kerf_outline.h"

namespace proveout {
namespace {

using wire_detail::PathRegion;

LevelLoop loopOf(const std::vector<Vec2>& points) {
  return {points, std::vector<WallName>(points.size(), 0), std::vector<MotionId>(points.size(), 0)};
}

/// A plate of 20 x 10 with a notch from its upper side, down to 2 mm above the lower one.
std::vector<Vec2> notched(double width) {
  const double half = 0.5 * width;
  return {{-10, 0}, {10, 0}, {10, 10}, {half, 10}, {half, 2}, {-half, 2}, {-half, 10}, {-10, 10}};
}

double areaOf(const std::vector<PathRegion>& regions) {
  double sum = 0.0;
  for (const PathRegion& region : regions) {
    for (const ClipperLib::Path& path : region)
      sum += ClipperLib::Area(path) * wire_detail::kUnit * wire_detail::kUnit;
  }
  return sum;
}

TEST(ThinPlaces, GapsAreFound) {
  const double least = wire_detail::leastWidth({loopOf(notched(1.0))});
  EXPECT_GT(least, 1e-5);
  EXPECT_LT(least, 1e-4);
  EXPECT_FALSE(wire_detail::hasThinPlaces({loopOf(notched(1.0))}, least));
  EXPECT_FALSE(wire_detail::hasThinPlaces({loopOf(notched(1.5 * least))}, least));
  EXPECT_TRUE(wire_detail::hasThinPlaces({loopOf(notched(0.5 * least))}, least));
}

TEST(ThinPlaces, LoopsBesideEachOtherAreFound) {
  const LevelLoop one = loopOf({{0, 0}, {5, 0}, {5, 5}, {0, 5}});
  const auto beside = [](double x) { return loopOf({{x, 1}, {x + 3, 0}, {x + 3, 5}}); };
  EXPECT_FALSE(wire_detail::hasThinPlaces({one, beside(5.001)}, 1e-4));
  EXPECT_TRUE(wire_detail::hasThinPlaces({one, beside(5.00005)}, 1e-4));
}

TEST(ThinPlaces, NarrowGapsGoAndOthersStayAsTheyAre) {
  constexpr double kWidth = 5e-5;
  const std::vector<PathRegion> wide{{wire_detail::pathOf(notched(2e-4))}},
      narrow{{wire_detail::pathOf(notched(2e-5))}};
  EXPECT_NEAR(areaOf(wire_detail::withoutThinPlaces(wide, kWidth)), 200.0 - 8.0 * 2e-4, 2e-7);
  const std::vector<PathRegion> closed = wire_detail::withoutThinPlaces(narrow, kWidth);
  EXPECT_NEAR(areaOf(closed), 200.0, 2e-7);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed.front().size(), 1u);
}

TEST(ThinPlaces, NarrowMaterialGoes) {
  // Two posts with a web of 20 nm between them.
  const std::vector<Vec2> posts{{0, 0},  {5, 0}, {5, 2},       {8, 2},       {8, 0}, {12, 0},
                                {12, 5}, {8, 5}, {8, 2.00002}, {5, 2.00002}, {5, 5}, {0, 5}};
  const std::vector<PathRegion> apart = wire_detail::withoutThinPlaces({{wire_detail::pathOf(posts)}}, 5e-5);
  EXPECT_EQ(apart.size(), 2u);
  EXPECT_NEAR(areaOf(apart), 45.0, 1e-7);
}

}  // namespace
}  // namespace proveout
