// Bodies that answer one column after the other, against the kernels: a line asked in that way has the same
// columns.
#include "removal/sweep/kinds/scalar_body.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

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

struct CountedPiece {
  using Spans = std::array<ColumnSpan, 2>;
  Spans columnSpans(double x, double y) const {
    ++asked;
    return {ColumnSpan{x, y}, ColumnSpan{offset + x, offset + y}};
  }
  double offset;
  mutable int asked = 0;
};

TEST(KeptSpans, ColumnsOfALeafAreFoundOnceForAllNumbers) {
  const CountedPiece one{10.0}, two{20.0};
  for (const CountedPiece* piece : {&one, &two}) {
    const std::uint64_t id = nextPieceId();
    for (int number = 0; number < 2; ++number) {
      for (int c = 0; c < 64; ++c) {
        const double x = c / 8, y = c % 8;
        const ColumnSpan span = keptSpans(*piece, id, x, y)[static_cast<std::size_t>(number)];
        ASSERT_EQ(span.lo, number * piece->offset + x);
        ASSERT_EQ(span.hi, number * piece->offset + y);
      }
    }
    EXPECT_EQ(piece->asked, 64);
  }
}

}  // namespace
}  // namespace proveout
