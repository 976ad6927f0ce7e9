#include <gtest/gtest.h>

#include "app/run_report.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/session.h"

namespace proveout {
namespace {

constexpr const char* kRing =
    "G21 G90 G17 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\nG1 Z-2 F200\nX15\nY15\nX5\nY5\nG0 Z5\nM30\n";
// A square of 10 mm with a flat 4, 2 deep: outside 14 x 14 with corners of 2, inside 6 x 6.
constexpr double kRingVolume = 2.0 * (14 * 14 - (4 - kPi) * 2 * 2 - 6 * 6);

Job ringJob() {
  Job job;
  job.name = "ring";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {20, 20, 0}};
  Tool tool;
  tool.number = 1;
  tool.diameter = 4;
  job.tools = {tool};
  job.simulation.resolution_mm = 0.5;
  return job;
}

Result<RunResult> run(const Job& job, const std::string& program, Progress& progress) {
  const MemoryProgramSource memory("ring.nc", program);
  const RecordingSource source(memory, TextEncoding::kAuto);
  return runRecorded(job, {&source}, progress);
}

TEST(Pipeline, RingHasItsVolumeAndNoFindings) {
  Progress progress;
  const Result<RunResult> result = run(ringJob(), kRing, progress);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_FALSE(result->alarm);
  EXPECT_TRUE(result->findings.empty());
  EXPECT_TRUE(result->topology().closedManifold());
  EXPECT_NEAR(4000.0 - result->surface().volume_mm3, kRingVolume, 0.01 * kRingVolume);
  double removed = 0;
  for (const float v : result->setups[0].removal.removed_mm3) removed += static_cast<double>(v);
  EXPECT_NEAR(removed, 4000.0 - result->surface().volume_mm3, 1e-3);
}

TEST(Pipeline, ThePartIsTheBlankLessWhatWasRemoved) {
  Progress progress;
  const Result<RunResult> result = run(ringJob(), kRing, progress);
  ASSERT_TRUE(result.ok()) << result.error().message;
  const SetupRun& setup = result->setups.front();
  ASSERT_EQ(setup.bodies.size(), 1u);
  const double removed = setup.initial_mm3 - setup.surface.volume_mm3;
  EXPECT_NEAR(removed + setup.bodies.front().volume_mm3, 4000.0, 4e-6);
  EXPECT_GT(std::abs(setup.extent.volume_mm3 - setup.bodies.front().volume_mm3), 4e-6);  // its facets
}

TEST(Pipeline, RapidIntoTheStockIsBlamedOnItsBlock) {
  Progress progress;
  const Result<RunResult> result =
      run(ringJob(), "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y10 Z5\nN40 G0 Z-3\nG0 Z5\nM30\n", progress);
  ASSERT_TRUE(result.ok());
  ASSERT_FALSE(result->findings.empty());
  const Finding& finding = result->findings.front();
  EXPECT_EQ(finding.kind, FindingKind::kRapidContact);
  EXPECT_EQ(finding.source->block, 40);
  EXPECT_EQ(finding.source->text, "N40 G0 Z-3");
  EXPECT_EQ(finding.tool, 1);
}

TEST(Pipeline, ProgramAlarmLeavesTheStockAlone) {
  Progress progress;
  const Result<RunResult> result = run(ringJob(), "G21 G90\nG1 X1\nG777\nM30\n", progress);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->alarm);
  EXPECT_FALSE(result->stock.has_value());
  ASSERT_FALSE(result->findings.empty());
  EXPECT_EQ(result->findings.front().kind, FindingKind::kAlarm);
}

TEST(Pipeline, APartCutAwayNeverPassesItsNominal) {
  Progress progress;
  Job job = ringJob();
  job.tools[0].diameter = 60;
  const Result<RunResult> result =
      run(job, "G21 G90 T1 M6\nS1000 M3\nG0 X-50 Y10 Z5\nZ-11\nG1 X70 F500\nM30\n", progress);
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_EQ(result->findings.size(), 1u);
  EXPECT_EQ(result->findings[0].kind, FindingKind::kNoPart);
}

TEST(Pipeline, AGridTooCoarseForTheBlankIsRefused) {
  Progress progress;
  Job job = ringJob();
  job.simulation.resolution_mm = 5.1;  // the blank is 10 mm thin
  const Result<RunResult> coarse = run(job, kRing, progress);
  ASSERT_FALSE(coarse.ok());
  EXPECT_EQ(coarse.error().kind, ErrorKind::kInput);
  job.stock = BoxShape{{0, 0, -0.5}, {400, 20, 0}};
  job.simulation.resolution_mm.reset();
  const Result<RunResult> thin = run(job, kRing, progress);
  ASSERT_TRUE(thin.ok()) << thin.error().message;
  EXPECT_LE(thin->resolution_mm, 0.25);
  EXPECT_GT(thin->surface().volume_mm3, 3000.0);
}

TEST(Pipeline, AnEndlessLoopWithMotionsStopsBeforeItFillsTheMemory) {
  Progress progress;
  Job job = ringJob();
  job.simulation.max_memory_gb = 0.05;
  const Result<RunResult> result =
      run(job, "N10 G21 G91 T1 M6\nS1000 M3\nG1 X0.001 F100\nX0.002\nM99 P10\n", progress);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kResourceLimit);
  EXPECT_EQ(result.error().message.rfind("ring.nc:", 0), 0u) << result.error().message;
}

TEST(Pipeline, CancelIsReported) {
  Progress progress;
  progress.cancel();
  const Result<RunResult> result = run(ringJob(), kRing, progress);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kInterrupted);
}

TEST(Pipeline, UncertaintyFollowsTheSmallestToolUsed) {
  Toolpath path;
  path.motions.resize(1);
  path.motions[0].tool = 1;
  std::vector<Tool> tools(2);
  tools[0].number = 1;
  tools[0].diameter = 10;
  tools[1].number = 2;
  tools[1].diameter = 1;
  EXPECT_DOUBLE_EQ(surfaceUncertainty(path, tools, 0.2), 0.2 * 0.2 / 40);
  path.motions[0].tool = 2;
  EXPECT_DOUBLE_EQ(surfaceUncertainty(path, tools, 0.2), 0.2 * 0.2 / 4);
  EXPECT_DOUBLE_EQ(surfaceUncertainty(path, tools, 20), 10.0);
  EXPECT_DOUBLE_EQ(surfaceUncertainty(Toolpath{}, tools, 0.2), 0.0);
}

}  // namespace
}  // namespace proveout
