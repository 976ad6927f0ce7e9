// Live tools and the C axis of lathes by the settings of the job. fan-15-live
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

ControlSettings liveLathe(std::map<std::string, double> parameters = {}) {
  ControlSettings settings = latheAt(50, 5, std::move(parameters));
  AxisSettings c;
  c.name = "C";
  c.number = 4;
  settings.axes.push_back(c);
  return settings;
}

const std::map<std::string, double> kLiveCodes{
    {"live.cw", 13}, {"live.ccw", 14}, {"live.stop", 15}, {"live.c_on", 20}, {"live.c_off", 21}};

std::vector<double> speedsOf(const IsoRun& run) {
  EXPECT_EQ(run.error(), "") << run.message();
  std::vector<double> all;
  for (const Motion& m : run.path.motions) all.push_back(m.spindle);
  return all;
}

/// "2 1500 cw": spindle, speed and direction of the events that name one.
std::vector<std::string> spindlesOf(const IsoRun& run) {
  std::vector<std::string> all;
  for (const Toolpath::EventAt& at : run.path.events) {
    const auto* spindle = at.event.as<event::Spindle>();
    if (spindle == nullptr) continue;
    all.push_back(IsoRun::number(spindle->spindle.value_or(0)) + " " + IsoRun::number(spindle->rpm) + " " +
                  spindle->direction + (spindle->axis.empty() ? "" : " " + spindle->axis));
  }
  return all;
}

TEST(FanucLiveTools, TurnByTheCodesOfTheJob) {
  const IsoRun run = lathe(
      "G21 G97 S800 M3\nG0 X40. Z2.\nM5\nM20\nG0 C90.\nM13 S2000\nG98 G1 Z-5. F100\nG99 G1 Z-6. F.1\nS1000\n"
      "G1 Z-7.\nG0 Z2.\nM15\nM21\nM3\nG1 X30. F.2\nM30\n",
      liveLathe(kLiveCodes));
  // The feed per turn is that of the live tool while it turns; behind it the part has its own speed again.
  EXPECT_EQ(speedsOf(run), (std::vector<double>{800, 0, 2000, 2000, 1000, 1000, 800}));
  EXPECT_NEAR(run.path.motions[3].feed, 200.0, 1e-9);
  EXPECT_NEAR(run.path.motions[6].feed, 160.0, 1e-9);
  EXPECT_TRUE(run.tells("fanuc-live-tool"));
  EXPECT_FALSE(run.tells("fanuc-m-function"));
  EXPECT_EQ(spindlesOf(run),
            (std::vector<std::string>{"1 800 cw", "1 0 stop", "1 0 stop", "1 0 axis C", "2 2000 cw",
                                      "2 1000 cw", "2 0 stop", "1 0 stop", "1 0 stop", "1 800 cw"}));
}

TEST(FanucLiveTools, TurnBackwardsAndGiveWayToTheMainSpindle) {
  const IsoRun run = lathe("G21 G98 M13 S3000\nG1 X10. F100.\nM14 S500\nX5.\nM3 S100\nX3.\nM5\nX1.\nM30\n",
                           liveLathe(kLiveCodes));
  EXPECT_EQ(speedsOf(run), (std::vector<double>{3000, -500, 100, 0}));
}

TEST(FanucLiveTools, TurnForTheMotionOfTheirBlock) {
  const IsoRun run =
      lathe("G21 G97 S500 M3\nG0 X10.\nG0 X20. M13 S3000\nG98 G1 X10. F100.\nM30\n", liveLathe(kLiveCodes));
  EXPECT_EQ(speedsOf(run), (std::vector<double>{500, 3000, 3000}));
}

TEST(FanucLiveTools, WordsOfCNeedTheAxis) {
  EXPECT_EQ(lathe("G0 C30.\nM30\n", liveLathe(kLiveCodes)).error(), "fanuc-spindle-axis");
  EXPECT_EQ(lathe("M20\nG0 C30.\nM21\nC0\nM30\n", liveLathe(kLiveCodes)).error(), "fanuc-spindle-axis");
  EXPECT_EQ(lathe("G0 C30.\nM30\n", liveLathe()).error(), "");
}

TEST(FanucLiveTools, HaasHasItsOwnCodes) {
  const IsoRun run = lathe("G21 M154\nG0 C90.\nM133 P1500\nG98 G1 Z-5. F100.\nM135\nM155\nM30\n",
                           liveLathe({{"flavour", 1}}));
  EXPECT_EQ(speedsOf(run), (std::vector<double>{0, 1500}));
  EXPECT_EQ(
      lathe("G21 M134 S700\nG98 G1 Z-5. F100.\nM30\n", liveLathe({{"flavour", 1}})).path.motions[0].spindle,
      -700.0);
}

TEST(FanucLiveTools, AreTheMakersWithoutSettings) {
  const IsoRun run = lathe("G21 G98 M133 S3000\nG1 X10. F100.\nM30\n", liveLathe());
  EXPECT_EQ(speedsOf(run), (std::vector<double>{0}));
  EXPECT_TRUE(run.tells("fanuc-m-function"));
  // A code of the control cannot be one of theirs.
  EXPECT_EQ(lathe("G0 X1.\nM30\n", liveLathe({{"live.cw", 3}})).error(), "fanuc-settings");
}

}  // namespace
}  // namespace proveout::test
