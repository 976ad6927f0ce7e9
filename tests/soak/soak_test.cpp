// A short slice of the soak: the same random jobs in every run, some seconds.
#include <gtest/gtest.h>

#include "tests/soak/laws.h"

namespace proveout::soak {
namespace {

/// Cases a test; ten tests share the slice so that they run side by side.
constexpr std::uint64_t kCases = 3;

class Soak : public testing::TestWithParam<int> {};

TEST_P(Soak, LawsHoldForRandomJobs) {
  int ran = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = 10000 + kCases * static_cast<std::uint64_t>(GetParam()) + i;
    const Judged judged = judge(seed);
    ran += judged.ran ? 1 : 0;
    for (const std::string& broken : judged.broken)
      ADD_FAILURE() << "seed " << seed << " (" << kindName(makeCase(seed).kind) << "): " << broken
                    << "; `soak --seed " << seed << " --print` shows the job";
  }
  EXPECT_GT(ran, static_cast<int>(kCases) / 2) << "most of the jobs are refused";
}

INSTANTIATE_TEST_SUITE_P(Slice, Soak, testing::Range(0, 10));

TEST(Soak, LawsHoldForRandomJobsOfAWire) {
  constexpr int kWireCases = 16;
  int ran = 0;
  for (int i = 0; i < kWireCases; ++i) {
    const Judged judged = judge(kFirstWireSeed + static_cast<std::uint64_t>(i));
    ran += judged.ran ? 1 : 0;
    for (const std::string& broken : judged.broken)
      ADD_FAILURE() << broken << "; `soak --wire --seed " << i << " --print` shows the job";
  }
  EXPECT_GT(ran, kWireCases / 2) << "most of the jobs are refused";
}

/// Cases in which a law was broken once: a thin cylinder heavier than its blank, cuts beside all samples, a
/// vertex inside of a wedge, stocks of several clampings that weighed less than nothing was taken from,
/// grooves of tools of two cells, a vertex off a blank from a mesh, a last clamping that leaves less than
/// nothing.
TEST(Soak, LawsHoldWhereTheyDidNot) {
  for (const std::uint64_t seed : {11, 71, 90, 95, 102, 137, 146, 233, 261, 263, 305, 30011, 34848, 100011,
                                   300453, 300526, 300934, 1000646}) {
    const Judged judged = judge(seed);
    EXPECT_TRUE(judged.ran) << judged.why;
    for (const std::string& broken : judged.broken) ADD_FAILURE() << "seed " << seed << ": " << broken;
  }
}

/// Kerfs as wide as the arc round a corner: a slit to the wire's middle. A surface that one fan of triangles
/// passes twice at an edge.
TEST(Soak, LawsHoldWhereWiresDidNotKeepThem) {
  for (const std::uint64_t seed : {3172, 4433, 5733, 6663, 349}) {
    const Judged judged = judge(kFirstWireSeed + seed);
    EXPECT_TRUE(judged.ran) << judged.why;
    for (const std::string& broken : judged.broken) ADD_FAILURE() << "wire " << seed << ": " << broken;
  }
}

TEST(Soak, ACaseIsTheSameForItsSeed) {
  EXPECT_EQ(makeCase(7).files, makeCase(7).files);
  EXPECT_NE(makeCase(7).files, makeCase(8).files);
  EXPECT_EQ(makeCase(kFirstWireSeed).files, makeCase(kFirstWireSeed).files);
  EXPECT_TRUE(makeCase(kFirstWireSeed).cutsWithWire());
  EXPECT_FALSE(makeCase(kFirstWireSeed - 1).cutsWithWire());
}

}  // namespace
}  // namespace proveout::soak
