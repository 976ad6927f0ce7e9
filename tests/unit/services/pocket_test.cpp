// Layout of pockets against the worked cases of the manual's digest.
#include "core/nc/services/pocket.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace proveout {
namespace {

PocketRequest pocket(std::optional<double> x, std::optional<double> y, double z, std::optional<double> corner,
                     double percent, double cut) {
  return {x, y, z, corner, 5.0, cut, percent};
}

/// Area of the outline that the last ring's path leaves, for a tool of that radius: closed form.
double areaOf(const PocketLayout& l, double tool_radius) {
  const double half = l.core + static_cast<double>(l.rings) * l.ring_step + tool_radius;
  const double across = static_cast<double>(l.rings) * l.ring_step + tool_radius;
  const double corner = l.outer_corner + tool_radius;
  return 4.0 * half * across - (4.0 - std::numbers::pi) * corner * corner;
}

TEST(Pocket, WorkedCases) {
  const auto expect = [](const PocketRequest& request, std::int64_t rings, double step, double core,
                         std::int64_t levels, double volume) {
    const PocketLayout l = layOutPocket(request);
    ASSERT_EQ(l.error, PocketError::kNone) << l.reason;
    EXPECT_EQ(l.rings, rings);
    EXPECT_NEAR(l.ring_step, step, 1e-4);
    EXPECT_NEAR(l.core, core, 1e-9);
    EXPECT_EQ(l.levels, levels);
    EXPECT_NEAR(areaOf(l, 5.0) * l.level_step * static_cast<double>(l.levels), volume, 1e-3);
  };
  expect(pocket(60, 40, 10, 8, 60, 4), 3, 5, 10, 3, 23450.619);
  expect(pocket(60, 40, 10, 8, 83, 4), 2, 7.5, 10, 3, 23450.619);
  expect(pocket({}, {}, 6, 20, 50, 3), 3, 5, 0, 2, 7539.822);
  expect(pocket(50, {}, 5, {}, 83, 5), 0, 0, 20, 1, 2392.699);
  expect(pocket(50, {}, 5, 8, 83, 5), 1, 3, 17, 1, 3725.310);
  expect(pocket({}, {}, 10, {}, 83, 4), 0, 0, 0, 3, 785.398);
  expect(pocket(50, 50, 4, {}, 83, 4), 3, 6.6667, 0, 1, 9914.159);
}

TEST(Pocket, SizesCountByTheirAmountAndTheLongerOneIsTheLength) {
  const PocketLayout l = layOutPocket(pocket(-40, 60, -10, 8, -60, 4));
  ASSERT_EQ(l.error, PocketError::kNone);
  EXPECT_FALSE(l.length_is_first);
  EXPECT_TRUE(l.clockwise);
  EXPECT_NEAR(l.core, 10, 1e-12);
  EXPECT_TRUE(layOutPocket(pocket(50, 50, 4, {}, 83, 4)).length_is_first);
  EXPECT_FALSE(layOutPocket(pocket({}, 50, 4, {}, 83, 4)).length_is_first);
}

/// Steps are equal and never larger than asked for, whatever the sizes.
TEST(Pocket, StepsNeverGrow) {
  for (double width = 10.0; width < 90.0; width += 3.7) {
    for (const double percent : {7.0, 33.3, 50.0, 83.0, 100.0}) {
      for (const double cut : {0.31, 1.0, 2.5, 40.0}) {
        const PocketLayout l = layOutPocket(pocket(100, width, 12.5, {}, percent, cut));
        ASSERT_EQ(l.error, PocketError::kNone);
        EXPECT_LE(l.ring_step, percent / 10.0 + 1e-6);
        EXPECT_NEAR(l.ring_step * static_cast<double>(l.rings), width / 2 - 5, 1e-9);
        EXPECT_LE(l.level_step, cut + 1e-6);
        EXPECT_NEAR(l.level_step * static_cast<double>(l.levels), 12.5, 1e-9);
        if (l.rings > 1) {
          EXPECT_GT(l.ring_step * static_cast<double>(l.rings) / static_cast<double>(l.rings - 1),
                    percent / 10.0);
        }
      }
    }
  }
}

TEST(Pocket, Errors) {
  const auto error = [](PocketRequest request) { return layOutPocket(request).error; };
  PocketRequest good = pocket(60, 40, 10, 8, 60, 4);
  const auto with = [&](auto change) {
    PocketRequest request = good;
    change(request);
    return error(request);
  };
  EXPECT_EQ(with([](auto& r) { r.depth.reset(); }), PocketError::kMissing);
  EXPECT_EQ(with([](auto& r) { r.depth = 0; }), PocketError::kMissing);
  EXPECT_EQ(with([](auto& r) { r.tool_radius.reset(); }), PocketError::kMissing);
  EXPECT_EQ(with([](auto& r) { r.cut.reset(); }), PocketError::kMissing);
  EXPECT_EQ(with([](auto& r) { r.corner = 25; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) {
              r.second = 8;
              r.corner.reset();
            }),
            PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.width_percent = 0; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.cut = 0; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.tool_radius = 0; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.tool_radius = -3; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.cut = 1e-300; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.depth = 1e9; }), PocketError::kWrongSize);
  EXPECT_EQ(with([](auto& r) { r.corner = 3; }), PocketError::kNone)
      << "a corner below the tool's is the tool's";
}

}  // namespace
}  // namespace proveout
