#include <gtest/gtest.h>

#include "app/session/process/fixtures.h"
#include "app/session/session.h"

namespace proveout {
namespace {

/// A block of 20 x 20 x 10 with a clamp of 4 x 20 x 6 beside it, its top 1 mm below the block's.
Job clampedJob() {
  Job job;
  job.name = "clamped";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {20, 20, 0}};
  job.fixtures = {{"clamp", BoxShape{{20, 0, -7}, {24, 20, -1}}}};
  Tool tool;
  tool.number = 1;
  tool.diameter = 4;
  tool.flute_length = 10;
  tool.overall_length = 30;
  tool.holder = {{0, 10}, {20, 10}};
  job.tools = {tool};
  job.simulation.resolution_mm = 0.25;
  return job;
}

Result<RunResult> run(const Job& job, const std::string& program) {
  const MemoryProgramSource memory("part.nc", "G21 G90 T1 M6\nS1000 M3\n" + program + "M30\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  return runRecorded(job, {&source}, progress);
}

std::vector<Finding> contacts(const RunResult& result) {
  std::vector<Finding> found;
  for (const Finding& f : result.findings) {
    if (f.kind == FindingKind::kFixtureContact) found.push_back(f);
  }
  return found;
}

TEST(Fixtures, FeedIntoAClampIsFoundWithItsBlockDepthAndVolume) {
  const Result<RunResult> result =
      run(clampedJob(), "G0 X10 Y-10 Z5\nG0 Z-3\nG1 Y-5 F200\nN40 G1 Y10\nN50 X22\nG0 Z5\n");
  ASSERT_TRUE(result.ok()) << result.error().message;
  const std::vector<Finding> found = contacts(*result);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_EQ(found[0].source->block, 50);
  EXPECT_EQ(found[0].tool, 1);
  EXPECT_NE(found[0].message.find("the tool runs into fixture 'clamp'"), std::string::npos);
  // 2 mm deep into the top; a strip of 4 x 2 with half a disc at its end.
  EXPECT_NEAR(*found[0].depth_mm, 2.0, 0.3);
  EXPECT_NEAR(*found[0].volume_mm3, 2 * (4 * 2 + kPi * 2), 1.5);
  EXPECT_GE(found[0].where->x(), 20 - 0.25);
}

TEST(Fixtures, RapidAndHolderCountToo) {
  const Result<RunResult> rapid = run(clampedJob(), "G0 X22 Y10 Z5\nN40 G0 Z-3\nG0 Z5\n");
  ASSERT_TRUE(rapid.ok());
  ASSERT_EQ(contacts(*rapid).size(), 1u);
  EXPECT_EQ(contacts(*rapid)[0].source->block, 40);
  // Tip at Z-33 beside the clamp: the holder begins 30 mm above, at Z-3, and reaches 10 mm far.
  const Result<RunResult> holder = run(clampedJob(), "G0 X30 Y10 Z5\nN40 G1 Z-33 F200\nG0 Z5\n");
  ASSERT_TRUE(holder.ok());
  const std::vector<Finding> found = contacts(*holder);
  ASSERT_EQ(found.size(), 1u);  // down and up again
  EXPECT_EQ(found[0].source->block, 40);
  EXPECT_EQ(found[0].last_source->text, "G0 Z5");
  EXPECT_NE(found[0].message.find("the tool holder runs into fixture 'clamp'"), std::string::npos);
}

TEST(Fixtures, KeepingClearFindsNothing) {
  const Result<RunResult> result = run(clampedJob(), "G0 X10 Y10 Z5\nN40 G1 Z-1 F200\nX17\nG0 Z5\n");
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->findings.empty()) << result->findings[0].message;
}

TEST(Fixtures, TooThinForTheGridIsRefused) {
  Job job = clampedJob();
  job.fixtures[0].shape = BoxShape{{20, 0, -7}, {20.3, 20, -1}};
  const Result<RunResult> result = run(job, "G0 X10 Y10 Z5\n");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kInput);
  EXPECT_EQ(result.error().message.rfind("fixture 'clamp': ", 0), 0u) << result.error().message;
}

}  // namespace
}  // namespace proveout
