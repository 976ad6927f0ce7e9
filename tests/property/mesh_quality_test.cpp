// The mesh that the program writes, judged by a library that knows nothing of it; and the same mesh for any
// number of threads and any SIMD level.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "io/mesh_io.h"
#include "tests/acceptance/program_runner.h"
#include "tests/property/mesh_judge.h"
#include "tests/support/mesh_distance.h"

namespace proveout::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

struct Sample {
  std::string name, input;       ///< job or program
  std::string options;           ///< of `proveout run`
  std::vector<double> grids_mm;  ///< on which CGAL judges the mesh
};

constexpr double kCoarseMm = 0.8;  ///< where many runs are compared

/// Names of tests must not hold addresses.
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

std::vector<Sample> samples() {
  const std::string shared = PROVEOUT_SHARED_PROGRAMS "/", parts = PROVEOUT_SOURCE_DIR "/parts/";
  return {
      {"bear",
       shared + "bear.nc",
       "--control nct --stock box:0,0,-20:80,80,0 --tool 1=ball:3.175",
       {0.25, 0.33, 0.5}},
      {"flower_mold",
       shared + "flower_mold.nc",
       "--control nct --stock box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0 --tool 1=flat:1",
       {0.25, 0.5}},
      {"circle_diamond",
       shared + "circle_diamond_square.gcode",
       "--control nct --stock box:-60,-60,-10:60,60,0 --tool 1=flat:3",
       {0.5}},
      {"bracket", parts + "bracket/job.toml", "", {0.5}},
      {"circle_diamond_square", parts + "circle_diamond_square/job.toml", "", {0.25, 0.6}},
      {"freeform_patch", parts + "freeform_patch/job.toml", "", {0.5}},
      {"gouged_plate", parts + "gouged_plate/job.toml", "", {0.5}},
      {"macro_plate", parts + "macro_plate/job.toml", "", {0.5}},
      {"polar_boss", parts + "polar_boss/job.toml", "", {0.5}},
      {"two_sides", parts + "two_sides/job.toml", "", {0.5}},
  };
}

class MeshQuality : public testing::TestWithParam<Sample> {
 protected:
  void SetUp() override {
    if (!fs::exists(GetParam().input)) GTEST_SKIP() << GetParam().input << " is not here";
  }
  /// Runs the sample and returns its report; null where the run failed.
  json run(double grid_mm, const std::string& more, const std::string& environment = {}) const {
    const Sample& sample = GetParam();
    const Outcome outcome =
        bench_.run("run '" + sample.input + "' " + sample.options +
                       " --no-render --quiet --out out --resolution " + std::to_string(grid_mm) + " " + more,
                   "env " + environment + " timeout 100");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << more << "\n" << outcome.err;
    return json::parse(readFile(bench_.path("out/report.json")), nullptr, false);
  }
  std::string path(const std::string& file) const { return bench_.path("out/" + file); }

 private:
  Workbench bench_;
};

TEST_P(MeshQuality, ClosedManifoldWithoutSelfIntersections) {
  for (const double grid_mm : GetParam().grids_mm) {
    SCOPED_TRACE(grid_mm);
    const json report = run(grid_mm, {});
    ASSERT_TRUE(report.is_object());
    EXPECT_TRUE(report["stock"]["closed"].get<bool>());
    for (const json& output : report["outputs"]["meshes"]) {
      const Result<TriMesh> mesh = loadMesh(path(output["path"].get<std::string>()));
      ASSERT_TRUE(mesh.ok()) << mesh.error().message;
      const MeshVerdict verdict = judgeMesh(*mesh);
      EXPECT_TRUE(verdict.manifold && verdict.closed);
      EXPECT_EQ(verdict.meetings, 0u) << "of " << mesh->triangles.size() << " triangles" << verdict.places;
    }
  }
}

TEST_P(MeshQuality, LeanMeshIsWithinTheTolerance) {
  // The finer tolerance is below the height of the facets that curved walls have on this grid.
  constexpr double kToleranceMm = 0.05, kFineMm = 0.001;
  const auto meshWith = [&](double simplify_mm) {
    const json report = run(kCoarseMm, "--simplify " + std::to_string(simplify_mm));
    return loadMesh(path(report.at("outputs").at("meshes").at(0).at("path").get<std::string>()));
  };
  const Result<TriMesh> all = meshWith(0.0);
  ASSERT_TRUE(all.ok());
  for (const double tolerance_mm : {kToleranceMm, kFineMm}) {
    SCOPED_TRACE(tolerance_mm);
    const Result<TriMesh> lean = meshWith(tolerance_mm);
    ASSERT_TRUE(lean.ok());
    expectNear(*all, *lean, tolerance_mm);
    if (tolerance_mm == kToleranceMm) {
      EXPECT_LT(lean->triangles.size(), all->triangles.size() / 2);
    }
  }
}

TEST_P(MeshQuality, SameForAnyNumberOfThreads) {
  std::string first;
  for (const char* threads : {"1", "2", "3", "8"}) {
    const json report = run(kCoarseMm, std::string("--threads ") + threads);
    ASSERT_TRUE(report.is_object()) << threads;
    const std::string hash = report["hashes"]["part_sha256"];
    if (first.empty()) first = hash;
    EXPECT_EQ(hash, first) << threads << " threads";
  }
  EXPECT_EQ(first.size(), 64u);
}

/// Names of the SIMD levels that this machine has, for PROVEOUT_SIMD.
std::vector<std::string> simdLevels() {
  std::ifstream info("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(info), {}};
  std::vector<std::string> levels = {"baseline"};
  if (has(text, " avx2 ")) levels.push_back("avx2");
  if (has(text, " avx512f ") && has(text, " avx512dq ") && has(text, " avx512vl ") && has(text, " avx512bw "))
    levels.push_back("avx512");
  return levels;
}

TEST_P(MeshQuality, SameForEverySimdLevel) {
  std::string first;
  for (const std::string& level : simdLevels()) {
    const json report = run(kCoarseMm, {}, "PROVEOUT_SIMD=" + level);
    ASSERT_TRUE(report.is_object()) << level;
    const std::string hash = report["hashes"]["part_sha256"];
    if (first.empty()) first = hash;
    EXPECT_EQ(hash, first) << level;
  }
  EXPECT_EQ(first.size(), 64u);
}

INSTANTIATE_TEST_SUITE_P(Samples, MeshQuality, testing::ValuesIn(samples()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace proveout::test
