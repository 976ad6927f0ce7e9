// A short slice of the second soak: the same random jobs in every run, some seconds.
#include "tests/soak/second/second_soak.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "tests/soak/second/moved.h"

namespace proveout::soak::second {
namespace {

constexpr int kSlices = 10, kJobs = 4;

class SecondSoak : public testing::TestWithParam<int> {};

TEST_P(SecondSoak, RelationsHoldForRandomJobs) {
  int ran = 0;
  for (int i = 0; i < kJobs; ++i) {
    const auto seed = static_cast<std::uint64_t>(kJobs * GetParam() + i);
    const Verdict verdict = judgePlan(seed);
    ran += verdict.ran ? 1 : 0;
    for (const Broken& broken : verdict.broken)
      ADD_FAILURE() << "seed " << seed << " (" << broken.process << "): " << broken.relation << ": "
                    << broken.why << "; `soak --second --seed " << seed << " --print` shows the job";
  }
  EXPECT_GT(ran, kJobs / 2) << "most of the jobs are refused";
}

INSTANTIATE_TEST_SUITE_P(Slice, SecondSoak, testing::Range(0, kSlices));

TEST(SecondSoak, APlanIsTheSameForItsSeed) {
  EXPECT_EQ(filesOf(makePlan(7)), filesOf(makePlan(7)));
  EXPECT_NE(filesOf(makePlan(7)), filesOf(makePlan(8)));
}

TEST(SecondSoak, ItHasEveryProcessAndChain) {
  std::set<std::string> processes;
  for (std::uint64_t seed = 0; seed < 300; ++seed) processes.insert(makePlan(seed).process);
  EXPECT_EQ(processes, (std::set<std::string>{"nct mill", "wl4 mill", "wl4 lathe", "flexnc lathe", "wire",
                                              "tapered wire", "mill > mill", "lathe > mill", "lathe > lathe",
                                              "wire > mill", "mill > wire", "lathe > wire"}));
}

/// Four quarters are none, and two mirrors.
TEST(SecondSoak, TurnsAndMirrorsOfAPlanCancel) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Plan plan = makePlan(seed);
    if (turns(plan.clampings.front().control)) continue;
    Plan four = plan;
    for (int k = 0; k < 4; ++k) four = moved(four, 0, turnedBy(0, 90));
    EXPECT_EQ(filesOf(four), filesOf(plan)) << seed;
    if (plan.clampings.size() == 1) EXPECT_EQ(filesOf(mirrored(mirrored(plan))), filesOf(plan)) << seed;
  }
}

}  // namespace
}  // namespace proveout::soak::second
