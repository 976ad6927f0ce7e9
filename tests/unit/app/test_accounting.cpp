#include <gtest/gtest.h>

#include <numeric>

#include "app/run_report.h"
#include "app/session/findings/accounting.h"
#include "app/session/session.h"

namespace proveout {
namespace {

Motion line(double length, double time_s, MotionKind kind, std::uint32_t source_line, int tool) {
  Motion motion;
  motion.to = {length, 0, 0};
  motion.time_s = time_s;
  motion.kind = kind;
  motion.tool = tool;
  motion.source = {0, source_line, static_cast<std::int64_t>(10 * source_line), 0};
  return motion;
}

Toolpath::EventAt event(MotionId before, double time_s, std::uint32_t source_line) {
  PathEvent event;
  event.what = event::Dwell{time_s};
  event.time_s = time_s;
  event.source = {0, source_line, -1, 0};
  return {before, event};
}

/// Tool change 5 s, rapid 1 s, cut 10 s with 200 mm3 over 50 mm, cut in air 2 s, dwell 3 s; then tool 2 cuts
/// 4 s with 20 mm3 over 10 mm.
struct Accounting : testing::Test {
  Accounting() {
    path.files = {"a,b.nc"};
    path.motions = {line(30, 1, MotionKind::kRapid, 2, 1), line(50, 10, MotionKind::kFeed, 3, 1),
                    line(20, 2, MotionKind::kFeed, 3, 1), line(10, 4, MotionKind::kFeed, 5, 2)};
    path.events = {event(0, 5, 1), event(3, 3, 4), event(4, 0, 6)};
    removed = {0, 200, 0, 20};
  }
  Toolpath path;
  std::vector<float> removed;
};

/// Of a turned part the engagement is the section of the chip: depth times feed a turn.
TEST(TurnedAccounting, EngagementIsTheSectionOfTheChip) {
  const auto chip = [](const Vec3& from, const Vec3& to, double feed, double volume) {
    Toolpath path;
    path.files = {"a.nc"};
    Motion motion;
    motion.from = from;
    motion.to = to;
    motion.kind = MotionKind::kFeed;
    motion.spindle = -800.0;
    motion.time_s = (to - from).norm() / feed / 800.0 * 60.0;
    path.motions = {motion};
    const std::vector<float> removed{static_cast<float>(volume)};
    return *accountFor({{"", &path, &removed, true}}).total.engagement_mm2();
  };
  // Along the axis from 25 to 20, 0.3 a turn: 5 x 0.3.
  EXPECT_NEAR(chip({20, 0, 0}, {20, 0, -50}, 0.3, kPi * (625 - 400) * 50), 1.5, 1e-4);
  // A face of 2 mm, 0.2 a turn.
  EXPECT_NEAR(chip({25, 0, -2}, {5, 0, -2}, 0.2, kPi * (625 - 25) * 2), 0.4, 1e-4);
  // Parting, 3 wide, to the axis.
  EXPECT_NEAR(chip({20, 0, -2}, {0, 0, -2}, 0.05, kPi * 400 * 3), 0.15, 1e-4);
  // The spindle stands: the way itself.
  Motion still;
  still.to = Vec3(3, 0, 4);
  still.time_s = 1.0;
  EXPECT_DOUBLE_EQ(lengthOfCut(Toolpath(), still, 10.0), 5.0);
}

TEST_F(Accounting, TotalsAndTools) {
  const ReportAccounting all = accountFor({{"", &path, &removed}});
  EXPECT_DOUBLE_EQ(all.total.time_s(), 25.0);
  EXPECT_DOUBLE_EQ(all.total.feed_s, 16.0);
  EXPECT_DOUBLE_EQ(all.total.rapid_s, 1.0);
  EXPECT_DOUBLE_EQ(all.total.other_s, 8.0);
  EXPECT_DOUBLE_EQ(all.total.air_s, 2.0);
  EXPECT_DOUBLE_EQ(all.total.length_mm, 110.0);
  EXPECT_DOUBLE_EQ(all.total.removed_mm3, 220.0);
  EXPECT_DOUBLE_EQ(*all.total.engagement_mm2(), 220.0 / 60.0);
  EXPECT_DOUBLE_EQ(*all.total.rate_mm3_min(), 60 * 220.0 / 14.0);
  ASSERT_EQ(all.per_tool.size(), 2u);
  EXPECT_EQ(all.per_tool[0].tool, 1);
  EXPECT_DOUBLE_EQ(all.per_tool[0].figures.time_s(), 18.0);  // the dwell belongs to the motion behind it
  EXPECT_DOUBLE_EQ(*all.per_tool[0].figures.engagement_mm2(), 4.0);
  EXPECT_DOUBLE_EQ(*all.per_tool[1].figures.rate_mm3_min(), 300.0);
}

TEST_F(Accounting, RateSeriesKeepsTheVolumeAndTheLargestRate) {
  const RateSeries rate = accountFor({{"", &path, &removed}}).rate;
  ASSERT_FALSE(rate.mean.empty());
  const double mean = std::accumulate(rate.mean.begin(), rate.mean.end(), 0.0);
  EXPECT_NEAR(mean * rate.step_s / 60.0, 220.0, 1e-9);
  EXPECT_DOUBLE_EQ(*std::max_element(rate.max.begin(), rate.max.end()), 1200.0);
  const auto at = [&](double s) { return static_cast<std::size_t>(s / rate.step_s); };
  EXPECT_DOUBLE_EQ(rate.max[at(3)], 0.0);
  EXPECT_NEAR(rate.mean[at(10)], 1200.0, 1e-9);
  EXPECT_NEAR(rate.mean[at(23)], 300.0, 1e-9);
  ASSERT_EQ(rate.spans.size(), 2u);
  EXPECT_EQ(rate.spans[1].label, "T2");
  EXPECT_DOUBLE_EQ(rate.spans[1].from_s, 18.0);
}

/// The motions that removed something are 60 mm of way in 14 s.
TEST_F(Accounting, WiresHaveARateByArea) {
  const ReportAccounting milled = accountFor({{"", &path, &removed}});
  EXPECT_FALSE(milled.total.area_mm2_min());
  EXPECT_FALSE(milled.rate.by_area);
  const ReportAccounting cut = accountFor({{"", &path, &removed, false, 20.0}});
  ASSERT_TRUE(cut.total.area_mm2_min());
  EXPECT_DOUBLE_EQ(*cut.total.area_mm2_min(), 60 * 20.0 * 60.0 / 14.0);
  EXPECT_TRUE(cut.rate.by_area);
  const double mean = std::accumulate(cut.rate.mean.begin(), cut.rate.mean.end(), 0.0);
  EXPECT_NEAR(mean * cut.rate.step_s / 60.0, 20.0 * 60.0, 1e-9);
}

TEST_F(Accounting, BlocksAreRowsInTheOrderOfTime) {
  std::vector<BlockFigures> rows;
  forEachBlock({"", &path, &removed}, 100.0, [&](const BlockFigures& row) { rows.push_back(row); });
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].kind, "event");
  EXPECT_EQ(rows[0].tool, 1);
  EXPECT_DOUBLE_EQ(rows[1].start_s, 105.0);
  EXPECT_EQ(rows[2].line, 3u);
  EXPECT_EQ(rows[2].kind, "feed");
  EXPECT_DOUBLE_EQ(rows[2].figures.time_s(), 12.0);
  EXPECT_DOUBLE_EQ(rows[2].figures.air_s, 2.0);
  EXPECT_DOUBLE_EQ(rows[4].start_s, 121.0);
  std::string text;
  appendBlockCsv(rows[2], text);
  EXPECT_EQ(text, ",\"a,b.nc\",3,N30,0,1,feed,106,12,70,200,4,1200,2\n");
  text.clear();
  appendBlockCsv(rows[0], text);
  EXPECT_EQ(text, ",\"a,b.nc\",1,,0,1,event,100,5,0,0,,,0\n");
}

TEST_F(Accounting, PathsFollowEachOtherInTime) {
  const ReportAccounting all = accountFor({{"top", &path, &removed}, {"bottom", &path, &removed}});
  EXPECT_DOUBLE_EQ(all.total.time_s(), 50.0);
  EXPECT_DOUBLE_EQ(all.total.removed_mm3, 440.0);
  ASSERT_EQ(all.rate.spans.size(), 4u);
  EXPECT_DOUBLE_EQ(all.rate.spans[2].from_s, 25.0);
  EXPECT_EQ(all.rate.spans[2].label, "bottom T1");
}

TEST_F(Accounting, AnEmptyPathHasNoRate) {
  const ReportAccounting none = accountFor({});
  EXPECT_FALSE(none.total.engagement_mm2().has_value());
  EXPECT_FALSE(none.total.rate_mm3_min().has_value());
  EXPECT_TRUE(none.rate.mean.empty());
  EXPECT_EQ(rateSvgFile(none.rate), "");
}

/// A flat 10 goes 2 mm deep through a bar of 80 mm at 500 mm/min: 20 mm2 of chip, 10,000 mm3/min while it is
/// whole in the bar.
TEST(AccountingOfASlot, HasTheRateOfItsClosedForm) {
  Job job;
  job.name = "slot";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {80, 30, 0}};
  Tool tool;
  tool.number = 1;
  tool.diameter = 10;
  job.tools = {tool};
  job.simulation.resolution_mm = 0.5;
  const MemoryProgramSource memory("slot.nc",
                                   "G21 G90 G17 T1 M6\nS1000 M3\nG0 X-10 Y15 Z5\nZ-2\nN50 G1 X20 F500\n"
                                   "N60 X60\nN70 X90\nN80 X10\nG0 Z5\nM30\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  const Result<RunResult> run = runRecorded(job, {&source}, progress);
  ASSERT_TRUE(run.ok()) << run.error().message;
  const CutPath cut = cutPaths(*run).front();
  std::vector<BlockFigures> rows;
  double rows_s = 0, rows_mm3 = 0;
  forEachBlock(cut, 0.0, [&](const BlockFigures& row) {
    rows.push_back(row);
    rows_s += row.figures.time_s();
    rows_mm3 += row.figures.removed_mm3;
  });
  const auto row = [&](std::int64_t block) {
    return *std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.block == block; });
  };
  EXPECT_NEAR(*row(60).figures.engagement_mm2(), 20.0, 0.1);
  EXPECT_NEAR(*row(60).figures.rate_mm3_min(), 10000.0, 50.0);
  EXPECT_DOUBLE_EQ(row(80).figures.air_s, row(80).figures.feed_s);  // back through the slot
  const Result<Report> report = makeReport(job, *run, {&source});
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->accounting.has_value());
  const CutFigures& total = report->accounting->total;
  EXPECT_NEAR(total.removed_mm3, report->stock->removed_mm3, 1e-6 * report->stock->removed_mm3);
  EXPECT_NEAR(total.removed_mm3, 1600.0, 2.0);
  EXPECT_NEAR(total.time_s(), report->time.cycle_s, 1e-9 * report->time.cycle_s);
  EXPECT_NEAR(rows_s, report->time.cycle_s, 1e-9 * report->time.cycle_s);
  EXPECT_NEAR(rows_mm3, report->stock->removed_mm3, 1e-6 * report->stock->removed_mm3);
  EXPECT_NEAR(*std::max_element(report->accounting->rate.max.begin(), report->accounting->rate.max.end()),
              10000.0, 50.0);
}

}  // namespace
}  // namespace proveout
