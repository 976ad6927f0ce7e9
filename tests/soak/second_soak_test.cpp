// A short slice of the second soak: the same random jobs in every run, some seconds.
#include "tests/soak/second/second_soak.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/soak/second/moved.h"

namespace proveout::soak::second {
namespace {

void expectAllHold(std::uint64_t seed) {
  const Verdict verdict = judgePlan(seed);
  EXPECT_TRUE(verdict.ran) << "seed " << seed << " is refused: " << verdict.why;
  for (const Broken& broken : verdict.broken)
    ADD_FAILURE() << "seed " << seed << " (" << broken.process << "): " << broken.relation << ": "
                  << broken.why << "; `soak --second --seed " << seed << " --print` shows the job";
}

/// Jobs of all processes and chains in which every relation holds: wires first, then lathes, mills, chains.
constexpr std::uint64_t kSeeds[] = {102, 119, 124, 129, 134, 103, 104, 113, 115, 108,
                                    133, 127, 106, 118, 109, 114, 126, 111, 123, 101};

class SecondSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SecondSoak, RelationsHoldForARandomJob) { expectAllHold(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Slice, SecondSoak, testing::ValuesIn(kSeeds));

/// Jobs that broke one: pieces that fell at the end of a block, not where they were cut free.
TEST(SecondSoak, RelationsHoldWhereTheyDidNot) {
  for (const std::uint64_t seed : {60, 117, 135}) expectAllHold(seed);
}

bool differ(const Plan& a, const Plan& b) { return filesOf(a) != filesOf(b); }

TEST(SecondSoak, APlanIsTheSameForItsSeed) {
  EXPECT_FALSE(differ(makePlan(7), makePlan(7)));
  EXPECT_TRUE(differ(makePlan(7), makePlan(8)));
}

TEST(SecondSoak, ItHasEveryProcessAndChain) {
  std::set<std::string> processes;
  for (std::uint64_t seed = 0; seed < 300; ++seed) processes.insert(makePlan(seed).process);
  EXPECT_EQ(processes, (std::set<std::string>{"nct mill", "wl4 mill", "wl4 lathe", "flexnc lathe", "wire",
                                              "tapered wire", "mill > mill", "lathe > mill", "lathe > lathe",
                                              "wire > mill", "mill > wire", "lathe > wire"}));
}

/// Four quarters are none, and so are two mirrors; one is none of them.
TEST(SecondSoak, TurnsAndMirrorsOfAPlanCancel) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Plan plan = makePlan(seed);
    if (turns(plan.clampings.front().control)) continue;
    Plan four = plan;
    for (int k = 0; k < 4; ++k) four = moved(four, 0, turnedBy(0, 90));
    EXPECT_FALSE(differ(four, plan)) << seed;
    EXPECT_TRUE(differ(moved(plan, 0, turnedBy(0, 90)), plan)) << seed;
    if (plan.clampings.size() > 1) continue;
    EXPECT_FALSE(differ(mirrored(mirrored(plan)), plan)) << seed;
  }
}

}  // namespace
}  // namespace proveout::soak::second
