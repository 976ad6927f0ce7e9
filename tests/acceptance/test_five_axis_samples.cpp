// The samples for four and five axes: what is right passes against a nominal that no simulation made, and a
// planted fault fails at its block. Rows: nct-25.14-G43.4 nct-25.14-G43.5 nct-25.16-G43.5P1 nct-25.16-ARC
// nct-25.1-N3213
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

struct Ran {
  int exit_code = -1;
  std::string said;
  json report;

  /// Whether an error of that kind stands at one of these lines, and none of that kind elsewhere.
  bool failsAt(const std::string& kind, const std::set<int>& lines) const {
    int found = 0;
    for (const json& finding : report["findings"]) {
      if (finding["kind"] != kind || finding["severity"] != "error") continue;
      if (!finding.contains("source") || !lines.contains(finding["source"]["line"].get<int>())) return false;
      ++found;
    }
    return found > 0;
  }
};

Ran ran(const std::string& job, const std::string& more = {}) {
  const Workbench bench;
  const fs::path file = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / job;
  const Outcome outcome = bench.run("run '" + file.string() + "' --no-render --out out" + more);
  Ran out{outcome.exit_code, outcome.err, {}};
  if (bench.exists("out/report.json")) out.report = json::parse(readFile(bench.path("out/report.json")));
  return out;
}

struct Sample {
  const char* name;
  const char* job;
  double part_mm3;  ///< by the closed form or by exact booleans, see the makers under parts/
  double share;     ///< of it that the volume may be off: chords of the nominal
};

class FiveAxisSamples : public testing::TestWithParam<Sample> {};

TEST_P(FiveAxisSamples, PassAgainstTheirNominals) {
  const Ran run = ran(GetParam().job);
  ASSERT_EQ(run.exit_code, 0) << run.said;
  EXPECT_EQ(run.report["verdict"], "pass");
  for (const json& finding : run.report["findings"]) {
    EXPECT_TRUE(finding["severity"] == "note" || finding["kind"] == "thin_feature") << finding;
  }
  EXPECT_LE(run.report["comparison"]["max_gouge_mm"].get<double>(), 0.008);
  EXPECT_LE(run.report["comparison"]["max_excess_mm"].get<double>(), 0.003);
  EXPECT_NEAR(run.report["stock"]["final_mm3"].get<double>(), GetParam().part_mm3,
              GetParam().share * GetParam().part_mm3);
}

INSTANTIATE_TEST_SUITE_P(Jobs, FiveAxisSamples,
                         testing::Values(Sample{"cone", "cone_frustum/job.toml", 56973.453, 1e-5},
                                         Sample{"cone_tilted", "cone_frustum/tilted.toml", 56973.453, 1e-5},
                                         Sample{"relief", "relief_cylinder/job.toml", 48420.701, 1e-5},
                                         Sample{"wall", "ruled_wall/job.toml", 38562.190, 1e-4},
                                         Sample{"impeller", "impeller/job.toml", 18916.205, 5e-4}),
                         [](const auto& test) { return std::string(test.param.name); });

/// A leaning and turning tool leaves the same bytes whatever the machine's vectors and threads.
TEST(FiveAxisSampleBytes, DoNotDependOnVectorsAndThreads) {
  const Workbench bench;
  const fs::path file = fs::path(PROVEOUT_SOURCE_DIR) / "parts/ruled_wall/job.toml";
  const std::string run = "run '" + file.string() + "' --no-render --resolution 1 --format stl --out ";
  ASSERT_LE(bench.run(run + "plain --threads 1", "timeout 100 env PROVEOUT_SIMD=baseline").exit_code, 1);
  ASSERT_LE(bench.run(run + "wide --threads 2").exit_code, 1);
  std::set<std::string> meshes;
  for (const char* folder : {"plain", "wide"}) {
    for (const auto& entry : fs::directory_iterator(bench.path(folder))) {
      if (entry.path().extension() == ".stl") meshes.insert(readFile(entry.path().string()));
    }
  }
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_GT(meshes.begin()->size(), 1000u);
}

/// The edge of the top goes almost along the lines of the grid: what they lose there is a corner, and no
/// film.
TEST(FiveAxisSamples, ACornerOfALeaningPartIsNoThinFeature) {
  const Ran run = ran("cone_frustum/tilted.toml", " --resolution 0.8");
  EXPECT_FALSE(has(run.said, "thinner than the grid")) << run.said;
}

/// The control takes the table for 0.2 mm beside where it is: every arc of the flank is off.
TEST(FiveAxisSampleFaults, AWrongParameterOfTheTable) {
  const Ran run = ran("cone_frustum/wrong-parameter.toml");
  ASSERT_EQ(run.exit_code, 1) << run.said;
  EXPECT_TRUE(run.failsAt("gouge", {10, 13})) << run.said;
  EXPECT_TRUE(run.failsAt("excess", {11, 12})) << run.said;
  EXPECT_NEAR(run.report["comparison"]["max_gouge_mm"].get<double>(), 0.2, 0.002);
  EXPECT_TRUE(has(run.said, "N3213 = 400.2, but the machine has 400:")) << run.said;
}

/// Each gouge is told at a figure of its own, with what the operator has entered.
TEST(FiveAxisSampleFaults, AWrongZeroBesideTheAxis) {
  const Ran run = ran("relief_cylinder/wrong-zero.toml");
  ASSERT_EQ(run.exit_code, 1) << run.said;
  int gouges = 0;
  for (const json& finding : run.report["findings"]) {
    if (finding["kind"] != "gouge") continue;
    ++gouges;
    EXPECT_TRUE(finding["source"]["text"].get<std::string>().ends_with("F400")) << finding;
    EXPECT_NEAR(finding["depth_mm"].get<double>(), 0.2, 0.002);
  }
  EXPECT_EQ(gouges, 8);
  EXPECT_TRUE(
      has(run.said, "cause: offsets.work.G54.y = 200.2; with offsets.work.G54.y = 200 nothing of it is left"))
      << run.said;
}

/// The foot of the wall is too deep all along; the flank does not mind where along the tool it cuts.
TEST(FiveAxisSampleFaults, AWrongLength) {
  const Ran run = ran("ruled_wall/wrong-length.toml");
  ASSERT_EQ(run.exit_code, 1) << run.said;
  std::set<int> cuts;
  for (int line = 9; line <= 34; ++line) cuts.insert(line);
  EXPECT_TRUE(run.failsAt("gouge", cuts)) << run.said;
  EXPECT_TRUE(run.failsAt("tool_data", {9})) << run.said;
  EXPECT_NEAR(run.report["comparison"]["max_gouge_mm"].get<double>(), 0.3, 0.005);
  EXPECT_TRUE(has(run.said, "cause: offsets.length.1 = 79.7")) << run.said;
}

/// A12 C142.6 and A-12 C322.6 are one direction; on the way from the one to the other the tool swings through
/// a blade.
TEST(FiveAxisSampleFaults, AFlippedPair) {
  const Ran run = ran("impeller/flipped.toml");
  ASSERT_EQ(run.exit_code, 1) << run.said;
  const auto flipped = [](const json& finding) {
    return finding["kind"] == "gouge" &&
           finding.value("/source/text"_json_pointer, std::string()).find(" A-12 ") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(run.report["findings"], flipped)) << run.said;
  for (const json& finding : run.report["findings"]) {
    EXPECT_TRUE(finding["severity"] != "error" || flipped(finding) || finding["kind"] == "excess") << finding;
  }
  EXPECT_GT(run.report["comparison"]["max_gouge_mm"].get<double>(), 1.0);
}

}  // namespace
}  // namespace proveout::test
