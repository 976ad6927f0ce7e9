// Feed, speed and dwell, units and planes of Fanuc-like mills (rows fan-4-*, fan-5-*).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Keys = std::map<std::string, double>;

IsoRun feedRun(const std::string& text, Keys parameters = {}) {
  parameters.emplace("rapid", 1.0);
  return {ControlId::kFanucMill, "O1\nG21 G90 G17\n" + text + "\nM30\n", runAtZero(std::move(parameters))};
}
std::vector<double> dwells(const IsoRun& run) {
  std::vector<double> seconds;
  for (const auto& e : run.path.events) {
    if (const auto* dwell = e.event.as<event::Dwell>()) seconds.push_back(dwell->seconds);
  }
  return seconds;
}
bool tellsOf(const IsoRun& run, const std::string& part) {
  for (const Diagnostic& d : run.path.diagnostics.all()) {
    if (d.severity != Severity::kError && d.message.find(part) != std::string::npos) return true;
  }
  return false;
}

// fan-4-G04 fan-3-G09: acceptance 1
TEST(FanucFeed, Dwells) {
  EXPECT_EQ(dwells(feedRun("G4 X1.5\nG4 U1.5\nG4 P1500\nG04 P[1000+500]")),
            (std::vector<double>{1.5, 1.5, 1.5, 1.5}));
  EXPECT_EQ(dwells(feedRun("G4 X5")), (std::vector<double>{5.0}));
  const IsoRun increment = feedRun("G4 X5", {{"decimal", 1.0}});
  EXPECT_EQ(dwells(increment), (std::vector<double>{0.005}));
  EXPECT_TRUE(increment.tells("fanuc-short-dwell"));
  EXPECT_EQ(dwells(feedRun("G4 X1500", {{"decimal", 1.0}})), (std::vector<double>{1.5}));
  EXPECT_EQ(dwells(feedRun("G20 G4 X1500", {{"decimal", 1.0}})), (std::vector<double>{1.5}));
  EXPECT_TRUE(dwells(feedRun("G4\nG1 X1. F10.")).empty());
  EXPECT_EQ(feedRun("G4 X1.5").motions(), (Lines{}));
  EXPECT_EQ(feedRun("G4 X-1.").error(), "fanuc-006");
  EXPECT_EQ(feedRun("G4 Y1.").error(), "fanuc-009");
  EXPECT_EQ(feedRun("G4 X1. P500").error(), "fanuc-009");
  // Under G95 it is a time all the same.
  EXPECT_EQ(dwells(feedRun("M3 S60\nG95 G4 X2.")), (std::vector<double>{2.0}));
}

// fan-4-G94 fan-4-G95 fan-4-S
TEST(FanucFeed, FeedPerMinuteAndPerTurn) {
  EXPECT_EQ(feedRun("G94 G1 X10. F500.").path.motions[0].feed, 500.0);
  EXPECT_NEAR(feedRun("M3 S1000\nG95 G1 X10. F.2").path.motions[0].feed, 200.0, 1e-9);
  EXPECT_NEAR(feedRun("M3 S500\nG95 G1 X10. F20", {{"decimal", 1.0}}).path.motions[0].feed, 100.0, 1e-9);
  EXPECT_NEAR(feedRun("G20 G1 X1. F1000", {{"decimal", 1.0}}).path.motions[0].feed, 254.0, 1e-9);
  EXPECT_NEAR(feedRun("G20 G1 X1. F10.").path.motions[0].feed, 254.0, 1e-9);
  EXPECT_TRUE(tellsOf(feedRun("G95 G1 X10. F.2"), "spindle stands still"));
  EXPECT_EQ(feedRun("S1234 M4\nG1 X1. F10.").path.motions[0].spindle, -1234.0);
}

// fan-4-G93: a block takes 1/F minutes, whatever its length
TEST(FanucFeed, InverseTime) {
  const IsoRun run = feedRun("G93 G1 X10. F2.\nG3 I5. F4.\nX20. Y0 I5. Z-3. F.5\nG94 G1 X30. F100.");
  EXPECT_EQ(run.error(), "") << run.message();
  ASSERT_EQ(run.path.motions.size(), 4u);
  EXPECT_NEAR(run.path.motions[0].time_s, 30.0, 1e-9);
  EXPECT_NEAR(run.path.motions[1].time_s, 15.0, 1e-9);
  EXPECT_NEAR(run.path.motions[2].time_s, 120.0, 1e-6);
  EXPECT_NEAR(run.path.motions[3].time_s, 6.0, 1e-9);
  EXPECT_EQ(feedRun("G93 G1 X10. F2.\nX20.").error(), "fanuc-011");
  EXPECT_EQ(feedRun("G93 G0 X10.\nG1 X20. F1.").error(), "");
}

// fan-4-F0
TEST(FanucFeed, NoFeed) {
  for (const char* text : {"G1 X5.", "G1 X5. F0", "G2 X5. R2.5", "G31 X5."}) {
    EXPECT_EQ(feedRun(text).error(), "fanuc-011") << text;
  }
  EXPECT_EQ(feedRun("G0 X5.").error(), "");
}

// fan-4-G96 fan-4-G97 fan-4-G92S: n = 1000 v / (pi d); the limit holds it
TEST(FanucFeed, SurfaceSpeed) {
  const IsoRun run =
      feedRun("G0 X25.\nG92 S1500\nG96 S200 M3\nG1 Y1. F100.\nG0 X20.\nG1 Y2.\nG97\nG1 Y3.\nS700 Y4.");
  EXPECT_EQ(run.error(), "") << run.message();
  std::vector<double> rpm;
  for (const Motion& m : run.path.motions) {
    if (m.kind == MotionKind::kFeed) rpm.push_back(m.spindle);
  }
  ASSERT_EQ(rpm.size(), 4u);
  EXPECT_NEAR(rpm[0], 1273.24, 0.01);
  EXPECT_NEAR(rpm[1], 1500.0, 1e-9);
  EXPECT_NEAR(rpm[2], 1500.0, 1e-9);
  EXPECT_NEAR(rpm[3], 700.0, 1e-9);
  const IsoRun inch = feedRun("G20 G0 X1.\nG96 S300 M3\nG1 Y1. F10.");
  EXPECT_NEAR(inch.path.motions.back().spindle, 12.0 * 300.0 / (M_PI * 2.0), 0.01);
}

// fan-4-override
TEST(FanucFeed, OverrideCodesAreTaken) { EXPECT_EQ(feedRun("M49\nG1 X1. F10.\nM48").error(), ""); }

// fan-5-G17 fan-5-G18 fan-5-G19
TEST(FanucFeed, Planes) {
  EXPECT_EQ(feedRun("G17 G3 X10. Y10. R10. F100.").motions(), (Lines{"A 10 10 0 c 0 10 0 90"}));
  EXPECT_EQ(feedRun("G18 G3 X10. Z10. R10. F100.").motions(), (Lines{"A 10 0 10 c 10 0 0 90"}));
  EXPECT_EQ(feedRun("G19 G3 Y10. Z10. R10. F100.").motions(), (Lines{"A 0 10 10 c 0 0 10 90"}));
  EXPECT_EQ(feedRun("G41 D1 G1 X5. F100.\nG18 X10.").error(), "fanuc-037");
}

// fan-5-parallel: W moves the tool along Z
TEST(FanucFeed, PlanesWithAParallelAxis) {
  ControlSettings settings = runAtZero({{"rapid", 1.0}});
  AxisSettings u;
  u.name = "U";
  u.number = 4;
  u.kind = AxisKind::kLinear;
  u.parallel = "X";
  settings.axes.push_back(u);
  const IsoRun run(ControlId::kFanucMill, "O1\nG21 G90 G17 U0 Y0\nG3 U10. Y10. R10. F100.\nM30\n", settings);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_NEAR((run.end() - Vec3(10.0, 10.0, 0.0)).norm(), 0.0, 1e-9);
  ASSERT_EQ(run.path.motions.size(), 1u);
  EXPECT_NEAR(run.path.motions[0].time_s, 60.0 * 5.0 * M_PI / 100.0, 1e-6);
}

// fan-5-G20 fan-5-G21
TEST(FanucFeed, Units) {
  EXPECT_EQ(feedRun("G20 G1 X1. F10.").motions(), (Lines{"F 25.4 0 0"}));
  const IsoRun change = feedRun("G1 X10. F100.\nG20\nG1 X1. F4.\nG21 X1.");
  EXPECT_EQ(change.motions(), (Lines{"F 10 0 0", "F 25.4 0 0", "F 1 0 0"}));
  EXPECT_TRUE(change.tells("fanuc-units"));
  EXPECT_FALSE(feedRun("G21 G1 X10. F100.").tells("fanuc-units"));
}

// fan-5-G90 fan-5-G91
TEST(FanucFeed, AbsoluteAndIncremental) {
  EXPECT_EQ(feedRun("G91 G1 X1. Y2. F100.\nX1.\nG90 X5.").motions(),
            (Lines{"F 1 2 0", "F 2 2 0", "F 5 2 0"}));
}

// fan-5-G22 fan-5-G23: the room between the corners is forbidden; entry is told and stops the program
TEST(FanucFeed, StoredStrokeCheck) {
  const std::string zone = "G22 X100. Y100. Z100. I50. J-100. K-100.\n";
  EXPECT_EQ(feedRun(zone + "G1 X40. F100.\nG23").error(), "");
  EXPECT_NE(feedRun(zone + "G1 X60. F100.").error(), "");
  EXPECT_EQ(feedRun(zone + "G23\nG1 X60. F100.").error(), "");
}

// fan-1-poweron fan-1-settingnote
TEST(FanucFeed, PowerOnCodesAreSettings) {
  const auto run = [](const std::string& text, Keys keys) {
    keys.emplace("rapid", 1.0);
    return IsoRun(ControlId::kFanucMill, "O1\n" + text + "\nM30\n", runAtZero(std::move(keys)));
  };
  EXPECT_EQ(run("G1 X1. F10.", {{"power_on_units", 1.0}}).motions(), (Lines{"F 25.4 0 0"}));
  EXPECT_EQ(run("G1 X1. F10.\nX1.", {{"power_on_distance", 1.0}}).motions(), (Lines{"F 1 0 0", "F 2 0 0"}));
  EXPECT_EQ(run("F10.\nX1.", {{"power_on_motion", 1.0}}).motions(), (Lines{"F 1 0 0"}));
  EXPECT_EQ(run("G2 X10. Z0 I5. K0 F10.", {{"power_on_plane", 18.0}}).motions(),
            (Lines{"A 10 0 0 c 5 0 0 -180"}));
  const IsoRun notes = run("X1.\nG2 X10. Y0 R6. F10.", {});
  for (const char* key : {"power_on_units", "power_on_distance", "power_on_motion", "power_on_plane"})
    EXPECT_TRUE(tellsOf(notes, std::string("setting ") + key)) << key;
  EXPECT_FALSE(tellsOf(run("G21 G90 G17 G0 X1.", {}), "power_on"));
  EXPECT_FALSE(tellsOf(run("G90 G0 X1.", {{"power_on_units", 0.0}}), "power_on"));
}

}  // namespace
}  // namespace proveout::test
