// Threads of the FlexNC control: G76 and the worm G30 (digest flexnc, 10.8 and 10.9).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "flexnc_call.h"

namespace proveout {
namespace {

using nc::CycleAnswer;
using nc::CycleMove;
using Role = CycleMove::Role;

/// The data block, and then the cut block from `start` (X a diameter, Z).
CycleAnswer threaded(const std::string& data, const std::string& cut, double x, double z) {
  nc::CycleCall call = test::flexncCall(cut, Vec2(z, x / 2.0));
  call.thread = test::flexncAnswer(data).thread;
  return performCycle(call);
}

std::vector<CycleMove> passesOf(const CycleAnswer& answer) {
  std::vector<CycleMove> passes;
  for (const CycleMove& move : answer.moves) {
    if (move.kind == CycleMove::Kind::kThread) passes.push_back(move);
  }
  return passes;
}

// Row: fnc-3.6-G76a
TEST(FlexncThread, ReadsItsData) {
  const CycleAnswer example = test::flexncAnswer("G76P010060Q0.1R0");
  ASSERT_TRUE(example.thread);
  EXPECT_TRUE(example.moves.empty());
  EXPECT_EQ(example.thread->spring_passes, 1);
  EXPECT_EQ(example.thread->run_out, 0.0);
  EXPECT_EQ(example.thread->angle_deg, 60.0);
  EXPECT_EQ(example.thread->second_depth, 0.1);
  const CycleAnswer other = test::flexncAnswer("G76P120555Q0.2R0.05");
  EXPECT_EQ(other.thread->spring_passes, 12);
  EXPECT_EQ(other.thread->run_out, 0.5);
  EXPECT_EQ(other.thread->angle_deg, 55.0);
  EXPECT_EQ(other.warnings.size(), 1U);
}

// The manual's thread: 34 passes to depth 1 and one at the same depth, root diameter 18, to Z-10. Row:
// fnc-3.6-G76b
TEST(FlexncThread, CutsTheExample) {
  const CycleAnswer answer = threaded("G76P010060Q0.1R0", "G76X20Z-10P1Q0.1R0F1.5", 50, 16);
  ASSERT_FALSE(answer.alarm);
  const std::vector<CycleMove> passes = passesOf(answer);
  ASSERT_EQ(passes.size(), 35U);
  EXPECT_EQ(answer.passes, 35);
  const double depths[] = {0.1, 0.2, 0.2646, 0.3162};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(10.0 - passes[k].element.to.y(), depths[k], 5e-5);
  for (const CycleMove& pass : passes) {
    const double depth = 10.0 - pass.element.to.y();
    EXPECT_EQ(pass.element.to.x(), -10.0);
    EXPECT_EQ(pass.element.from.y(), pass.element.to.y());
    EXPECT_EQ(pass.lead, 1.5);
    EXPECT_NEAR(pass.element.from.x(), 16.0 + (1.0 - depth) * std::tan(degToRad(30.0)), 1e-12);
  }
  EXPECT_EQ(passes[33].element.to.y(), 9.0);
  EXPECT_EQ(passes[34].element.to.y(), 9.0);
  EXPECT_EQ(answer.moves.back().element.to, Vec2(16, 25));
}

// Each pass takes less than the one before, the first takes Q and the second the stock of the data block.
TEST(FlexncThread, TakesLessWithEachPass) {
  const std::vector<CycleMove> passes =
      passesOf(threaded("G76P020000Q0.15R0", "G76X30Z-20P1.2Q0.3R0F2", 34, 4));
  double before = 15.0, taken = 1.0;
  for (std::size_t k = 0; k + 2 < passes.size(); ++k) {
    const double step = before - passes[k].element.to.y();
    EXPECT_LT(step, taken + 1e-12);
    if (k == 0) {
      EXPECT_NEAR(step, 0.3, 1e-12);
    } else if (k == 1) {
      EXPECT_NEAR(step, 0.15, 1e-12);
    }
    taken = step;
    before = passes[k].element.to.y();
    EXPECT_EQ(passes[k].element.from.x(), 4.0);  // H00: radial infeed
  }
  EXPECT_NEAR(before, 13.8, 1e-12);
}

TEST(FlexncThread, RunsOutAtTheEnd) {
  const CycleAnswer answer = threaded("G76P001200Q0.1R0", "G76X20Z-10P1Q1R0F1.5", 24, 6);
  const std::vector<CycleMove> passes = passesOf(answer);
  ASSERT_EQ(passes.size(), 2U);  // one pass where Q is P, and its run-out of 1.2 * 1.5 mm
  EXPECT_LT((passes[0].element.to - Vec2(-8.2, 9.0)).norm(), 1e-12);
  EXPECT_LT((passes[1].element.to - Vec2(-10.0, 10.8)).norm(), 1e-12);
  EXPECT_NEAR(passes[1].turn, 14.2 / 1.5 - 9.0, 1e-9);  // the spindle has gone on
}

TEST(FlexncThread, RunsOutInside) {
  const std::vector<CycleMove> passes = passesOf(threaded("G76P001000Q0.1R0", "G76X30Z-20P1Q1R0F2", 24, 5));
  ASSERT_EQ(passes.size(), 2U);
  EXPECT_LT((passes[0].element.to - Vec2(-18.0, 15.0)).norm(), 1e-12);
  EXPECT_LT((passes[1].element.to - Vec2(-20.0, 13.0)).norm(), 1e-12);
}

TEST(FlexncThread, TapersAndCutsInside) {
  const std::vector<CycleMove> taper = passesOf(threaded("G76P000000Q0.1R0", "G76X30Z-20P1Q1R2F2", 40, 5));
  EXPECT_EQ(taper.front().element.from, Vec2(5, 12));
  EXPECT_EQ(taper.front().element.to, Vec2(-20, 14));
  const CycleAnswer inside = threaded("G76P000000Q0.1R0", "G76X30Z-20P1Q0.5R0F2", 24, 5);
  EXPECT_EQ(inside.warnings.size(), 1U);
  const std::vector<CycleMove> passes = passesOf(inside);
  EXPECT_EQ(passes.front().element.to, Vec2(-20, 14.5));
  EXPECT_EQ(passes.back().element.to, Vec2(-20, 15));
  EXPECT_EQ(inside.moves.back().element.to, Vec2(5, 12));
}

TEST(FlexncThread, CutsFromLeftToRight) {
  const std::vector<CycleMove> passes =
      passesOf(threaded("G76P000060Q0.1R0", "G76X30Z10P1Q0.5R0F2", 40, -20));
  EXPECT_NEAR(passes.front().element.from.x(), -20.0 - 0.5 * std::tan(degToRad(30.0)), 1e-12);
  EXPECT_EQ(passes.back().element.to, Vec2(10, 14));
}

constexpr const char* kWorm = "G30A30X50Z60R10Q3F24H0.5P1U56L8K3";

/// A pass of the worm: which start it is of, how far its groove lies along Z from the start's middle, and the
/// radius of its bottom.
struct WormPass {
  std::size_t start;
  double across, bottom;
};

/// The starts have as many passes each, a third of a turn apart. All have the way from Z15, where the widest
/// scan of 7 mm begins at Z8, to Z-60.
std::vector<WormPass> wormPasses(const CycleAnswer& answer) {
  const std::vector<CycleMove> moves = passesOf(answer);
  std::vector<WormPass> passes;
  for (const CycleMove& move : moves) {
    const std::size_t start = passes.size() * 3 / moves.size();
    EXPECT_EQ(move.lead, 24.0);
    EXPECT_NEAR(move.turn, static_cast<double>(start) / 3.0, 1e-15);
    EXPECT_GE(move.element.from.x(), 8.0 - 1e-12);
    EXPECT_LT((move.element.to - move.element.from - Vec2(-75.0, 0.0)).norm(), 1e-12);
    passes.push_back({start, move.element.to.x() + 60.0, move.element.to.y()});
  }
  return passes;
}

// Row: fnc-3.6-G30
TEST(FlexncWorm, KeepsTheToolInTheGroove) {
  const CycleAnswer answer = test::flexncAnswer(kWorm);
  ASSERT_FALSE(answer.alarm);
  EXPECT_TRUE(answer.warnings.empty());
  const Vec2 groove(0.0, 15.0 + 10.0);
  double deepest = 100.0, widest = 0.0;
  for (const WormPass& pass : wormPasses(answer)) {
    // What of the tool's circle lies below the crest is within the groove's circle.
    for (int k = 0; k < 90; ++k) {
      const double angle = kPi / 45.0 * k;
      const Vec2 edge = Vec2(pass.across, pass.bottom + 3.0) + 3.0 * Vec2(std::cos(angle), std::sin(angle));
      if (edge.y() >= 25.0) continue;
      EXPECT_LT((edge - groove).norm(), 10.0 + 1e-9);
      widest = std::max(widest, std::abs(edge.x()));
    }
    deepest = std::min(deepest, pass.bottom);
  }
  EXPECT_EQ(deepest, 15.0);
  EXPECT_GT(widest, 9.9);
  EXPECT_EQ(answer.moves.back().element.to, Vec2(8, 28));
}

// Starts one after the other, a third of a turn apart, each from the crest down and across. Row: fnc-3.6-G30
TEST(FlexncWorm, CutsAllStartsInOrder) {
  const std::vector<WormPass> passes = wormPasses(test::flexncAnswer(kWorm));
  std::size_t wanted = 0;
  for (int layer = 1; layer <= 10; ++layer) {
    const double below = std::min(3.0 - layer, 0.0);  // of the tool's middle from the crest
    wanted += 1 + static_cast<std::size_t>(std::ceil(2.0 * std::sqrt(49.0 - below * below) / 0.5 - 1e-9));
  }
  ASSERT_EQ(passes.size(), 3 * wanted);
  for (std::size_t k = 1; k < passes.size(); ++k) {
    const WormPass &before = passes[k - 1], &pass = passes[k];
    if (pass.start != before.start) {
      EXPECT_EQ(before.bottom, 15.0);
      EXPECT_EQ(pass.bottom, 24.0);
    } else if (pass.bottom != before.bottom) {
      EXPECT_NEAR(pass.bottom, before.bottom - 1.0, 1e-12);
    } else {
      EXPECT_GT(pass.across, before.across);
      EXPECT_LT(pass.across, before.across + 0.5 + 1e-9);
    }
  }
  for (std::size_t k = 0; k < wanted; ++k) {
    EXPECT_NEAR(passes[k].across, passes[wanted + k].across, 1e-9);
    EXPECT_EQ(passes[k].bottom, passes[2 * wanted + k].bottom);
  }
}

TEST(FlexncWorm, TellsOddSizes) {
  const CycleAnswer odd = test::flexncAnswer("G30A32X50Z60R10Q3F24H0.5P1U56L8K3");
  ASSERT_EQ(odd.warnings.size(), 1U);
  EXPECT_EQ(odd.warnings.front().id, "fnc-worm");
}

}  // namespace
}  // namespace proveout
