// Chamfers and roundings between two elements.
#include "core/nc/services/contour/contour_corner.h"

#include <gtest/gtest.h>

#include <limits>

namespace proveout {
namespace {

constexpr double kNotSet = std::numeric_limits<double>::quiet_NaN();

/// A line; what belongs to arcs is not set.
ContourElement line(const Vec2& from, const Vec2& to) {
  return {false, from, to, Vec2::Constant(kNotSet), kNotSet};
}

TEST(ContourCorner, LinesNeedNoCentre) {
  const ContourElement first = line({0, 0}, {10, 0}), second = line({10, 0}, {10, 10});
  CornerJoin join;
  ASSERT_EQ(chamferCorner(first, second, 2.0, join), CornerError::kNone);
  EXPECT_LT((join.leave - Vec2(8, 0)).norm(), 1e-12);
  EXPECT_LT((join.enter - Vec2(10, 2)).norm(), 1e-12);
  ASSERT_EQ(roundCorner(first, second, 3.0, join), CornerError::kNone);
  EXPECT_LT((join.leave - Vec2(7, 0)).norm(), 1e-12);
  EXPECT_LT((join.enter - Vec2(10, 3)).norm(), 1e-12);
  EXPECT_LT((join.center - Vec2(7, 3)).norm(), 1e-12);
  EXPECT_NEAR(join.sweep, kPi / 2, 1e-12);
}

TEST(ContourCorner, WhatIsNotFiniteHasNoDirection) {
  CornerJoin join;
  EXPECT_NE(chamferCorner(line({0, 0}, {kNotSet, 0}), line({10, 0}, {10, 10}), 2.0, join),
            CornerError::kNone);
  ContourElement arc = line({10, 0}, {20, 10});
  arc.arc = true;
  EXPECT_NE(roundCorner(line({0, 0}, {10, 0}), arc, 2.0, join), CornerError::kNone);
}

}  // namespace
}  // namespace proveout
