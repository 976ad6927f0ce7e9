// Bodies that answer one column after the other, against the kernels: a line asked in that way has the same
// columns, and its reach holds them.
#include "removal/sweep/kinds/scalar_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/sweep/kinds/line_body.h"
#include "tests/property/random_moves.h"

namespace proveout {
namespace {

struct SlowLine : ScalarBody<SlowLine> {
  explicit SlowLine(const LineBody& of) : line(of) {}

  ColumnSpan column(double x, double y) const {
    double xs[8] = {x}, ys[8] = {y}, lo[8], hi[8];
    line.columns(xs, ys, 1, lo, hi);
    return {lo[0], hi[0]};
  }
  ColumnSpan around(double x, double y, double half_width) const {
    const LineSweep& way = line.way;
    const double reach = half_width + way.solid->radius + kCullSlackMm;
    const double low_x = std::min(way.x, way.x + way.ux * way.length) - reach,
                 high_x = std::max(way.x, way.x + way.ux * way.length) + reach;
    const double low_y = std::min(way.y, way.y + way.uy * way.length) - reach,
                 high_y = std::max(way.y, way.y + way.uy * way.length) + reach;
    if (x < low_x || x > high_x || y < low_y || y > high_y) return {};
    return {way.z + std::min(way.rise, 0.0) + way.solid->z_min - kCullSlackMm, line.highestReach()};
  }
  double highestReach() const { return line.highestReach(); }

  LineBody line;
};

class ScalarBodies : public ::testing::Test {
 protected:
  ScalarBodies() {
    Tool tool = parseToolOption("1=bull:6:1").value();
    tool.flute_length = 15.0;
    profile_ = makeToolSolid(tool).cutter.front();
    solid_ = columnSolid(profile_);
  }
  double random(double low, double high) { return moves_.number(low, high); }
  SlowLine line(int style) {
    const auto [from, to] = moves_.line(style);
    return SlowLine(LineBody(columnLine(solid_, from, to)));
  }

  ConvexProfile profile_;
  ColumnSolid solid_;
  test::RandomMoves moves_{3};
};

TEST_F(ScalarBodies, ColumnsOfALeafAreThoseOfTheKernels) {
  int covered = 0;
  const auto fast = std::make_unique<LeafColumns>(), slow = std::make_unique<LeafColumns>();
  for (int i = 0; i < 400; ++i) {
    const SlowLine body = line(i % 8);
    for (int c = 0; c < 64; ++c) {
      fast->x[c] = slow->x[c] = random(-9, 9), fast->y[c] = slow->y[c] = random(-9, 9);
      fast->lo[c] = slow->lo[c] = fast->hi[c] = slow->hi[c] = 0.0;
    }
    const unsigned quarters = static_cast<unsigned>(i) % 16;
    body.line.leafColumns(*fast, quarters);
    body.leafColumns(*slow, quarters);
    for (int c = 0; c < 64; ++c) {
      ASSERT_EQ(slow->lo[c], fast->lo[c]) << i << ' ' << c;
      ASSERT_EQ(slow->hi[c], fast->hi[c]) << i << ' ' << c;
      covered += slow->lo[c] < slow->hi[c] ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 1000);
}

TEST_F(ScalarBodies, TheReachHoldsTheColumns) {
  int held = 0;
  for (int i = 0; i < 2000; ++i) {
    const SlowLine body = line(i % 8);
    FourBlocks blocks{};
    blocks.half_width = random(0.1, 3.0);
    for (int k = 0; k < 4; ++k) {
      blocks.x[k] = random(-9, 9), blocks.y[k] = random(-9, 9);
      blocks.z_low[k] = random(-20, 20), blocks.z_high[k] = blocks.z_low[k] + 5.0;
    }
    double low[4], high[4];
    body.reach(blocks, low, high);
    for (int k = 0; k < 4; ++k) {
      const ColumnSpan span = body.column(blocks.x[k] + random(-1, 1) * blocks.half_width,
                                          blocks.y[k] + random(-1, 1) * blocks.half_width);
      if (span.lo >= blocks.z_high[k] || span.hi <= blocks.z_low[k]) continue;
      ++held;
      ASSERT_LE(low[k], span.lo) << i;
      ASSERT_GE(high[k], span.hi) << i;
    }
  }
  EXPECT_GT(held, 200);
}

}  // namespace
}  // namespace proveout
