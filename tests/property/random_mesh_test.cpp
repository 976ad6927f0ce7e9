// Meshes of random programs whose faces meet below the size of a cell, judged by CGAL.
// PROVEOUT_RANDOM_MESHES=N judges those of N programs, PROVEOUT_RANDOM_FIRST=SEED from this one on.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "tests/property/mesh_judge.h"
#include "tests/soak/case_runner.h"

namespace proveout::test {
namespace {

using soak::CaseRunner;
using soak::kFirstCrowdedSeed;
using soak::SoakCase;

constexpr int kPrograms = 40, kShares = 4;

int fromEnvironment(const char* variable, int usual) {
  const char* const text = getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

class RandomMesh : public testing::TestWithParam<int> {};

TEST_P(RandomMesh, ClosedManifoldWithoutSelfIntersections) {
  const int first = fromEnvironment("PROVEOUT_RANDOM_FIRST", 1),
            count = fromEnvironment("PROVEOUT_RANDOM_MESHES", kPrograms);
  int judged = 0;
  for (int i = GetParam(); i < count; i += kShares) {
    const int seed = first + i;
    SCOPED_TRACE("`soak --crowded --seed " + std::to_string(seed) + " --print` shows the job");
    const SoakCase made = soak::makeCase(kFirstCrowdedSeed + static_cast<std::uint64_t>(seed));
    const Result<RunResult> run = CaseRunner(made).run("job.toml");
    if (!run.ok()) continue;  // too narrow tools are refused
    ++judged;
    EXPECT_EQ(run->surface().self_intersections, 0u) << "by the engine's own count";
    if (run->surface().mesh.triangles.empty()) continue;
    const MeshVerdict verdict = judgeMesh(run->surface().mesh);
    EXPECT_TRUE(verdict.manifold && verdict.closed);
    EXPECT_EQ(verdict.meetings, 0u) << verdict.places;
  }
  EXPECT_GE(judged, count / kShares * 9 / 10) << "most of the jobs are refused";
}

INSTANTIATE_TEST_SUITE_P(Programs, RandomMesh, testing::Range(0, kShares));

}  // namespace
}  // namespace proveout::test
