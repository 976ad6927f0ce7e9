// Several channels cut one stock.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/run_report.h"
#include "app/session/findings/accounting.h"
#include "app/session/session.h"

namespace proveout {
namespace {

Job blockJob(int channels) {
  Job job;
  job.name = "block";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {60, 40, 0}};
  for (const int number : {1, 2}) {
    Tool tool;
    tool.number = number;
    tool.diameter = number == 1 ? 6 : 10;
    job.tools.push_back(tool);
  }
  job.simulation.resolution_mm = 0.5;
  for (int k = 1; k <= channels; ++k) {
    ChannelSpec channel;
    channel.settings.channel = k;
    channel.settings.tool = k;
    channel.settings.parameters = {{"N2201", 500}, {"N2202", 599}};
    job.channels.push_back(channel);
  }
  return job;
}

Result<RunResult> run(const Job& job, const std::vector<std::string>& programs) {
  std::vector<std::unique_ptr<MemoryProgramSource>> memory;
  for (const std::string& program : programs) {
    memory.push_back(
        std::make_unique<MemoryProgramSource>(fmt::format("channel{}.nc", memory.size() + 1), program));
  }
  RecordingSource source(*memory.front(), TextEncoding::kAuto);
  for (std::size_t k = 1; k < memory.size(); ++k) source.addChannel(*memory[k]);
  Progress progress;
  return runRecorded(job, {&source}, progress);
}

const char* const kLeft = "M3 S1000\nG0 X10 Y-10\nZ-4\nG1 Y50 F600\nG0 Z20\nM30\n";
const char* const kRight = "M3 S1000\nG0 X10 Y20\nZ2\nG1 Z-6 F300\nX40\nG0 Z20\nM30\n";

TEST(ChannelRun, BothToolsCutTheOneStock) {
  const Result<RunResult> both = run(blockJob(2), {kLeft, kRight});
  ASSERT_TRUE(both.ok());
  EXPECT_FALSE(both->alarm);
  // Slot of 6 x 40 x 4, slot of 30 x 10 and two half discs of 10, 6 deep; they share 3 + 5 wide ends 4 deep.
  Job alone = blockJob(0);
  const Result<RunResult> one_by_one =
      run(alone, {"T1 M6\nM3 S1000\nG0 X10 Y-10\nZ-4\nG1 Y50 F600\nG0 Z20\nT2 M6\nM3 S1000\nG0 X10 Y20\nZ2\n"
                  "G1 Z-6 F300\nX40\nG0 Z20\nM30\n"});
  ASSERT_TRUE(one_by_one.ok());
  EXPECT_NEAR(both->surface().volume_mm3, one_by_one->surface().volume_mm3, 1e-3);
  EXPECT_LT(both->surface().volume_mm3, 60 * 40 * 10 - 30 * 10 * 6 - 6 * 25 * 4);
}

TEST(ChannelRun, ReportKnowsEachChannelsTimeAndTool) {
  const Result<RunResult> both = run(blockJob(2), {kLeft, kRight});
  ASSERT_TRUE(both.ok());
  const SetupRun& setup = both->setups.front();
  double end_s = 0.0;
  for (const int number : {1, 2}) {
    double time_s = 0.0;
    for (const Motion& motion : setup.interpreted.path.motions) {
      if (motion.channel != number) continue;
      EXPECT_EQ(motion.tool, number);
      time_s += motion.time_s;
    }
    EXPECT_GT(time_s, 1.0);
    end_s = std::max(end_s, time_s);
  }
  EXPECT_NEAR(setup.interpreted.summary.cycle_s, end_s, 1e-9);
  const std::vector<CutPath> paths{{"", &setup.interpreted.path, &setup.removal.removed_mm3}};
  const ReportAccounting accounting = accountFor(paths);
  ASSERT_FALSE(accounting.rate.spans.empty());
  EXPECT_EQ(accounting.rate.spans.size(), 2u) << "one tool in each channel";
  double last_s = 0.0;
  for (const auto& span : accounting.rate.spans) last_s = std::max(last_s, span.to_s);
  EXPECT_NEAR(last_s, end_s, 1e-9);
}

TEST(ChannelRun, AnAlarmOfOneChannelIsTheRuns) {
  const Result<RunResult> stuck = run(blockJob(2), {"M501 P12\nM30\n", "M30\n"});
  ASSERT_TRUE(stuck.ok());
  EXPECT_TRUE(stuck->alarm);
  ASSERT_FALSE(stuck->findings.empty());
  EXPECT_NE(stuck->findings.front().message.find("deadlock"), std::string::npos);
}

}  // namespace
}  // namespace proveout
