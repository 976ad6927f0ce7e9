// Loops that change something in every round: which of them are ended, and what is told of them.
#include "core/nc/limits/loop_budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace proveout::nc {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kBlocks = 1'000'000;  // 50,000 motions; 20,000 blocks or 2,000 motions are let be

/// A loop of three blocks, lines 7 to 9, of which the second moves.
class Looping {
 public:
  explicit Looping(std::uint64_t block_limit = kBlocks)
      : budget(block_limit, [this] {
          return std::vector<LoopBudget::Named>{{"#1", count}};
        }) {}

  /// The round in which the loop is ended; nothing: it comes to its own end, or `most` rounds are over.
  std::optional<int> run(const std::function<bool(int round)>& goes_on, int most) {
    for (int round = 0; round < most; ++round) {
      count = round;
      for (std::size_t line = 6; line < 9; ++line) {
        ++done.blocks;
        if (budget.arrives({1, line, line}, done)) return round;
        if (line == 6 && !goes_on(round)) return std::nullopt;
        if (line == 7) ++done.motions;
      }
    }
    return std::nullopt;
  }
  bool asks(double left, bool holds, std::uint64_t place = 1) {
    budget.asked(place, left, holds);
    return holds;
  }

  LoopBudget budget;
  LoopBudget::Work done;
  double count = 0.0;
};

TEST(LoopBudget, EndsALoopWhoseConditionIsAlwaysTheSame) {
  Looping loop;
  const auto ended = loop.run([&](int) { return loop.asks(1.0, true); }, 100'000);
  ASSERT_TRUE(ended.has_value());
  EXPECT_LE(*ended, 2'100);
  EXPECT_THAT(loop.budget.message(), HasSubstr("an endless loop in lines 7 to 9"));
  EXPECT_THAT(loop.budget.message(), HasSubstr("from line 9 to line 7"));
  EXPECT_THAT(loop.budget.message(), HasSubstr("#1 from"));
  EXPECT_THAT(loop.budget.message(), HasSubstr("max_blocks"));
}

TEST(LoopBudget, EndsALoopThatGoesAwayFromItsEnd) {
  Looping loop;
  EXPECT_TRUE(loop.run([&](int round) { return loop.asks(5.0 + round, true); }, 100'000).has_value());
}

TEST(LoopBudget, EndsALoopThatStartsAnewBeforeItsEnd) {
  Looping loop;
  const auto round = [&](int k) { return loop.asks(100.0 - k % 90, true); };
  EXPECT_TRUE(loop.run(round, 100'000).has_value());
}

TEST(LoopBudget, EndsALoopWhoseConditionsTurnWithoutAnEnd) {
  Looping loop;
  const auto round = [&](int k) {
    loop.asks(1.0 / (k + 1.0), k % 2 == 0, 2);  // nearer each time, and both outcomes seen
    return loop.asks(1.0, true);
  };
  EXPECT_TRUE(loop.run(round, 100'000).has_value());
}

TEST(LoopBudget, EndsALoopThatComesNearerForEver) {
  Looping loop;
  const auto ended = loop.run([&](int k) { return loop.asks(std::exp(-1e-4 * k), true); }, 300'000);
  EXPECT_TRUE(ended.has_value());
}

TEST(LoopBudget, LetsACounterComeToItsEnd) {
  for (const int rounds : {1'999, 10'000, 49'000}) {
    Looping loop;
    EXPECT_FALSE(loop.run([&](int k) { return loop.asks(rounds - k, k < rounds); }, 100'000).has_value())
        << rounds << ": " << loop.budget.message();
  }
}

TEST(LoopBudget, TellsEarlyOfACounterThatGoesTooFar) {
  Looping loop;
  const auto ended = loop.run([&](int k) { return loop.asks(1e7 - k, true); }, 100'000);
  ASSERT_TRUE(ended.has_value());
  EXPECT_LE(*ended, 2'100);
  EXPECT_THAT(loop.budget.message(), HasSubstr("too long"));
  EXPECT_THAT(loop.budget.message(), HasSubstr("1e+07 motions"));
}

TEST(LoopBudget, LetsAnInnerLoopStartAnew) {
  // 200 rounds of 100: what the inner one asks is at its end again and again.
  Looping loop;
  const auto round = [&](int k) {
    loop.asks(99 - k % 100, k % 100 != 99, 2);
    return loop.asks(200 - k / 100, k / 100 < 200);
  };
  EXPECT_FALSE(loop.run(round, 100'000).has_value()) << loop.budget.message();
}

/// Repeats a call of one line that moves, within calls that are repeated as well. Whether it was ended.
bool repeats(LoopBudget& budget, LoopBudget::Work& done, std::int64_t times, std::size_t depth,
             std::uint64_t& calls) {
  const std::uint64_t call = ++calls;
  for (std::int64_t k = 0; k < times; ++k) {
    ++done.blocks;
    if (budget.arrives({4 - depth, 0, 0, call, k, times}, done)) return true;
    if (depth == 0) ++done.motions;
    if (depth > 0 && repeats(budget, done, times, depth - 1, calls)) return true;
  }
  return false;
}

TEST(LoopBudget, ForetellsCallsThatAreRepeatedWithinEachOther) {
  for (const int depth : {1, 2, 3}) {
    LoopBudget budget(kBlocks, [] { return std::vector<LoopBudget::Named>{}; });
    LoopBudget::Work done;
    std::uint64_t calls = 0;
    const bool ended = repeats(budget, done, 200, static_cast<std::size_t>(depth), calls);
    EXPECT_EQ(ended, depth > 1) << depth;
    EXPECT_LT(done.motions, 45'000);
    EXPECT_EQ(ended, budget.message().find("of 200") != std::string::npos);
  }
}

TEST(LoopBudget, PlainBlocksAreNoLoop) {
  LoopBudget budget(kBlocks, [] { return std::vector<LoopBudget::Named>{}; });
  for (std::size_t line = 0; line < 200'000; ++line) {
    const auto work = static_cast<double>(line);
    ASSERT_FALSE(budget.arrives({1, line, line}, {work, work}));
  }
}

}  // namespace
}  // namespace proveout::nc
