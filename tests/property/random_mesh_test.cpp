// Meshes of random programs whose faces meet below the size of a cell, and of random jobs of a wire, judged
// by CGAL. PROVEOUT_RANDOM_MESHES=N judges those of N programs, PROVEOUT_RANDOM_FIRST=SEED from this one on
// (from 100000 on they have all kinds of cutters, blanks and arcs, from 200000 on all kinds of curves).
// PROVEOUT_RANDOM_WIRES=N judges N jobs of a wire, PROVEOUT_RANDOM_WIRE=SEED from this one on.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/property/mesh_judge.h"
#include "tests/soak/case_runner.h"

namespace proveout::test {
namespace {

using soak::CaseRunner;
using soak::kFirstCrowdedSeed;
using soak::kFirstCurvedSeed;
using soak::kFirstWideSeed;
using soak::SoakCase;

constexpr int kPrograms = 120, kWires = 40, kShares = 8;  // programs of each of three kinds

int fromEnvironment(const char* variable, int usual) {
  const char* const text = getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

void expectSound(const StockSurface& surface) {
  EXPECT_EQ(surface.self_intersections, 0u) << "by the engine's own count";
  if (surface.mesh.triangles.empty()) return;
  const MeshVerdict verdict = judgeMesh(surface.mesh);
  EXPECT_TRUE(verdict.manifold && verdict.closed);
  EXPECT_EQ(verdict.meetings, 0u) << verdict.places;
}

/// Judges the mesh of the job of a seed. False: it is refused, as too narrow tools are.
bool judge(int seed, bool simplified) {
  SCOPED_TRACE("`soak --crowded --seed " + std::to_string(seed) + " --print` shows the job");
  SoakCase made = soak::makeCase(kFirstCrowdedSeed + static_cast<std::uint64_t>(seed));
  if (!simplified) {
    const std::string table = "[simulation]\n", key = "simplify = 0\n";
    std::string& job = made.files["job.toml"];
    const std::size_t at = job.find(table);
    at == std::string::npos ? job += table + key : job.insert(at + table.size(), key);
  }
  const Result<RunResult> run = CaseRunner(made).run("job.toml");
  if (!run.ok()) return false;
  expectSound(run->surface());
  return true;
}

class RandomMesh : public testing::TestWithParam<int> {};

TEST_P(RandomMesh, ClosedManifoldWithoutSelfIntersections) {
  const int count = fromEnvironment("PROVEOUT_RANDOM_MESHES", kPrograms);
  int judged = 0, asked = 0;
  const int given = fromEnvironment("PROVEOUT_RANDOM_FIRST", 0);
  for (const int first : given > 0 ? std::vector{given} : std::vector{1, kFirstWideSeed, kFirstCurvedSeed}) {
    for (int i = GetParam(); i < count; i += kShares, ++asked) judged += judge(first + i, true) ? 1 : 0;
  }
  EXPECT_GE(judged, asked * 8 / 10) << "most of the jobs are refused";
}

INSTANTIATE_TEST_SUITE_P(Programs, RandomMesh, testing::Range(0, kShares));

/// Upright and leaning: closed contours, cut once or twice, over each other and the plate's border.
class RandomWire : public testing::TestWithParam<int> {};

TEST_P(RandomWire, ClosedManifoldWithoutSelfIntersections) {
  const int count = fromEnvironment("PROVEOUT_RANDOM_WIRES", kWires);
  const int first = fromEnvironment("PROVEOUT_RANDOM_WIRE", 0);
  int judged = 0, asked = 0;
  for (int i = GetParam(); i < count; i += kShares, ++asked) {
    SCOPED_TRACE("`soak --wire --seed " + std::to_string(first + i) + " --print` shows the job");
    const SoakCase made = soak::makeCase(soak::kFirstWireSeed + static_cast<std::uint64_t>(first + i));
    const Result<RunResult> run = CaseRunner(made).run("job.toml");
    if (!run.ok()) continue;
    ++judged;
    expectSound(run->surface());
  }
  EXPECT_GE(judged, asked * 6 / 10) << "most of the jobs are refused";
}

INSTANTIATE_TEST_SUITE_P(Jobs, RandomWire, testing::Range(0, kShares));

/// Jobs of a wire that had pairs: corners that were one as floats, curved rungs, walls that meet, tips that
/// later motions cut off a piece that had fallen, folds of nanometres, walls that come within steps of the
/// floats of each other, parts of walls beside rungs that others bend. 266 and 496: it was told of pairs that
/// only rounding had.
class FoldedWire : public testing::TestWithParam<int> {};

TEST_P(FoldedWire, IsSound) {
  const Result<RunResult> run =
      CaseRunner(soak::makeCase(soak::kFirstWireSeed + static_cast<std::uint64_t>(GetParam())))
          .run("job.toml");
  ASSERT_TRUE(run.ok());
  expectSound(run->surface());
}

INSTANTIATE_TEST_SUITE_P(Jobs, FoldedWire,
                         testing::Values(47, 54, 70, 206, 246, 256, 266, 350, 412, 422, 429, 496, 1090));

/// Programs that had pairs of triangles that met and were not found, or not parted: walls thinner than a cell
/// that are folded flat, and four crossings on a face between cells of one sheet each.
class FoldedMesh : public testing::TestWithParam<int> {};

TEST_P(FoldedMesh, IsParted) { EXPECT_TRUE(judge(GetParam(), true)); }
TEST_P(FoldedMesh, IsPartedWithoutSimplifying) { EXPECT_TRUE(judge(GetParam(), false)); }

INSTANTIATE_TEST_SUITE_P(Programs, FoldedMesh,
                         testing::Values(379, 896, 1127, 1398, 1449, 100193, 100220, 100366, 100394, 100485));

}  // namespace
}  // namespace proveout::test
