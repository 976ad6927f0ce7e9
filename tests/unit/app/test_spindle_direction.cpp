#include <gtest/gtest.h>

#include "app/session/findings/spindle_direction.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

Job twoToolsJob() {
  return app_test::blockJob("direction", {40, 30, 20},
                            {app_test::toolOf(1, 6), app_test::toolOf(2, 5, ToolType::kDrill)});
}

std::vector<Finding> told(const Job& job, const std::string& program,
                          FindingKind kind = FindingKind::kSpindleDirection) {
  const Result<RunResult> run = app_test::run(job, {program});
  EXPECT_TRUE(run.ok() && !run->alarm);
  return run.ok() ? app_test::ofKind(run->findings, kind) : std::vector<Finding>{};
}

constexpr const char* kSlot = "G0 X-10 Y15 Z-2\nG1 X50 F500\nG0 Z20\n";

TEST(SpindleDirection, ARightHandCutterWithM4IsAnError) {
  const auto found =
      told(twoToolsJob(), std::string("G21 G90 T1 M6\nN20 S1000 M4\nN30 S1500\n") + kSlot + "M30\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kError);
  EXPECT_EQ(found[0].tool, 1);
  EXPECT_EQ(found[0].source->block, 20);  // the block that started it, not the one that changed its speed
  EXPECT_NE(found[0].message.find("part.nc:5"), std::string::npos) << found[0].message;
}

TEST(SpindleDirection, ALeftHandCutterIsTheOtherWayRound) {
  Job job = twoToolsJob();
  job.tools[0].left_hand = true;
  EXPECT_TRUE(told(job, std::string("G21 G90 T1 M6\nS1000 M4\n") + kSlot + "M30\n").empty());
  EXPECT_EQ(told(job, std::string("G21 G90 T1 M6\nS1000 M3\n") + kSlot + "M30\n").size(), 1u);
}

TEST(SpindleDirection, ItIsToldOnceForEachToolAndStart) {
  const std::string again = "G0 X-10 Y5 Z-2\nG1 X50\nG0 Z20\n";
  EXPECT_EQ(told(twoToolsJob(), std::string("G21 G90 T1 M6\nS1000 M4\n") + kSlot + again + "M30\n").size(),
            1u);
  EXPECT_EQ(
      told(twoToolsJob(), std::string("G21 G90 T1 M6\nS1000 M4\n") + kSlot + "M5\nM4\n" + again + "M30\n")
          .size(),
      2u);
  EXPECT_EQ(told(twoToolsJob(), std::string("G21 G90 T1 M6\nS1000 M4\n") + kSlot +
                                    "T2 M6\nG0 X20 Y5 Z2\nG1 Z-5\nG0 Z20\nM30\n")
                .size(),
            2u);
}

TEST(SpindleDirection, WithoutACutItIsQuiet) {
  EXPECT_TRUE(told(twoToolsJob(), std::string("G21 G90 T1 M6\nS1000 M3\n") + kSlot +
                                      "M4\nG0 X-10 Y15\nG1 Z-2 F500\nX50\nG0 Z20\nM30\n")
                  .empty());  // the same slot again
  EXPECT_TRUE(told(twoToolsJob(), std::string("G21 G90 T1 M6\nS1000 M3\n") + kSlot + "M30\n").empty());
}

TEST(SpindleDirection, TapsAreRight) {
  for (const char* tap : {"G84", "G74", "G84.2", "G84.3"}) {
    const std::string program = std::string("G21 G90 T2 M6\nS500 ") +
                                (std::string(tap) == "G74" ? "M4" : "M3") + "\nG0 X20 Y15 Z5\n" + tap +
                                " X20 Y15 Z-8 R3 F500\nG80\nG0 Z20\nM30\n";
    EXPECT_TRUE(told(twoToolsJob(), program).empty()) << tap;
  }
  Job job = twoToolsJob();
  job.control = "wl4-mill";
  EXPECT_TRUE(told(job,
                   "%TAP\nG54 G17 G90 G94\nT2 M6\nS500 M3\nG0 X20 Y5 Z5\nG84 #2=3 #3=-8 F500\nX20 Y15\nG80\n"
                   "G0 Z20\nM30\n")
                  .empty());
  EXPECT_EQ(
      told(job, "%DRILL\nG54 G17 G90 G94\nT2 M6\nS500 M4\nG0 X20 Y15 Z5\nG1 Z-5 F200\nG0 Z20\nM30\n").size(),
      1u);
}

TEST(SpindleDirection, RigidTapsTurnTheSpindleThemselves) {
  for (const double orients : {0.0, 1.0}) {
    Job job = twoToolsJob();
    job.settings.parameters["N1503.TSC"] = orients;
    for (const std::string tap : {"G84.2", "G84.3"}) {
      const std::string program =
          "G21 G90 T2 M6\nS500 M3\nG0 X20 Y15 Z5\n" + tap + " X20 Y15 Z-8 R3 F500\nX30\nG80\n";
      EXPECT_TRUE(told(job, program + "G0 Z20\nM30\n", FindingKind::kSpindleOff).empty()) << tap << orients;
      // Behind the cycle it stands until M3.
      const std::string drill = "G0 X10\nG1 Z-5 F100\nG0 Z20\nM30\n";
      EXPECT_EQ(told(job, program + drill, FindingKind::kSpindleOff).size(), 1u) << tap << orients;
      EXPECT_TRUE(told(job, program + "M3\n" + drill, FindingKind::kSpindleOff).empty()) << tap << orients;
    }
  }
}

}  // namespace
}  // namespace proveout
