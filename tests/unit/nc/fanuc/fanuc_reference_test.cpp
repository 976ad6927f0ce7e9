// Reference points, machine coordinates and the length offset there (rows fan-5-*, acceptance 11, 56, 58).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

/// The machine's reference point 1 at (300, 200, 100), 2 at (0, 0, 50), seen from the workpiece's zero.
ControlSettings withReference() {
  ControlSettings settings = runAtZero({{"rapid", 1.0}});
  settings.reference_points[0] = Vec3(300.0, 200.0, 100.0);
  settings.reference_points[1] = Vec3(0.0, 0.0, 50.0);
  return settings;
}
IsoRun machine(const std::string& text, const ControlSettings& settings = withReference()) {
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n", settings};
}
/// The job says nothing of the machine; the tool starts at (0, 0, 80).
IsoRun nothing(const std::string& text, std::map<std::string, double> keys = {}) {
  keys.emplace("rapid", 1.0);
  ControlSettings settings = runAtZero(std::move(keys));
  settings.start = Vec3(0.0, 0.0, 80.0);
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n", settings};
}
bool tellsPart(const IsoRun& run, const std::string& part) {
  for (const Diagnostic& d : run.path.diagnostics.all()) {
    if (d.severity != Severity::kError && d.message.find(part) != std::string::npos) return true;
  }
  return false;
}

// fan-5-G28: acceptance 11
TEST(FanucReference, G28GoesByThePointWithTheNamedAxes) {
  EXPECT_EQ(machine("G0 X5. Y6. Z7.\nG91 G28 Z0").motions(), (Lines{"R 5 6 7", "R 5 6 100"}));
  EXPECT_EQ(machine("G28 X10. Y20.").motions(), (Lines{"R 10 20 0", "R 300 200 0"}));
  EXPECT_EQ(machine("G91 G28 X10.").motions(), (Lines{"R 10 0 0", "R 300 0 0"}));
  EXPECT_EQ(machine("G28 G91 Z0.\nG90 G0 X1.").motions(), (Lines{"R 0 0 100", "R 1 0 100"}));
  EXPECT_EQ(machine("G28 U0 W0").motions(), (Lines{"R 300 0 100"}));
}

// fan-5-G28none
TEST(FanucReference, G28AloneDoesNotMove) {
  const IsoRun run = machine("G28\nG0 X1.");
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(run.tells("fanuc-no-axis"));
}

// fan-5-G30
TEST(FanucReference, G30GoesToTheNumberedPoint) {
  EXPECT_EQ(machine("G91 G30 Z0").motions(), (Lines{"R 0 0 50"}));
  EXPECT_EQ(machine("G91 G30 P2 Z5.").motions(), (Lines{"R 0 0 5", "R 0 0 50"}));
  EXPECT_EQ(machine("G30 P5 Z0").error(), "fanuc-003");
}

// fan-5-G29
TEST(FanucReference, G29ComesBackByThePoint) {
  EXPECT_EQ(machine("G28 X10. Y20.\nG29 X30. Y5.").motions(),
            (Lines{"R 10 20 0", "R 300 200 0", "R 10 20 0", "R 30 5 0"}));
  EXPECT_EQ(machine("G29 X30.").error(), "fanuc-046");
}

// fan-5-G27
TEST(FanucReference, G27ChecksWhereItArrives) {
  EXPECT_EQ(machine("G27 X300. Y200.").error(), "");
  EXPECT_EQ(machine("G27 X299. Y200.").error(), "fanuc-092");
  EXPECT_EQ(machine("G27 X299. Y200.").motions(), (Lines{"R 299 200 0"}));
}

// fan-5-G53
TEST(FanucReference, G53MovesInMachineCoordinates) {
  ControlSettings settings = withReference();
  settings.work_offsets[0] = Vec3(100.0, 50.0, -300.0);
  settings.work_given[0] = true;
  settings.start = Vec3::Zero();
  const auto run = [&](const std::string& text) { return machine(text, settings); };
  EXPECT_EQ(run("G53 X0 Y0").motions(), (Lines{"R -100 -50 0"}));
  EXPECT_EQ(run("G0 G53 Z0\nX1.").motions(), (Lines{"R 0 0 300", "R 1 0 300"}));
  EXPECT_EQ(run("G1 G53 Z-200. F50.").motions(), (Lines{"F 0 0 100"}));
  EXPECT_EQ(run("G90 G53 G49 G0 Z0 M5").motions(), (Lines{"R 0 0 300"}));
  EXPECT_EQ(run("G52 X7.\nG53 X0").motions(), (Lines{"R -100 0 0"}));
  const IsoRun steps = run("G91\nG53 X0\nX1.");
  EXPECT_EQ(steps.motions(), (Lines{"R 1 0 0"}));
  EXPECT_TRUE(steps.tells("fanuc-g53-incremental"));
  EXPECT_EQ(run("G53").motions(), (Lines{}));
}

// fan-5-lengthsuspend: acceptance 58
TEST(FanucReference, TheLengthOffsetEndsThereAndComesBack) {
  ControlSettings settings = runAtZero({{"rapid", 1.0}});
  settings.work_offsets[0] = Vec3(0.0, 0.0, -300.0);
  settings.work_given[0] = true;
  settings.length_offsets[1].geometry = 50.0;
  settings.gauge_lengths[1] = 50.0;
  settings.tool = 1;
  const auto run = [&](const std::string& text) { return machine(text, settings); };
  const IsoRun lost = run("G43 H1 G0 Z20.\nG90 G0 G53 Z0\nZ10.\nZ5.");
  EXPECT_EQ(lost.motions(), (Lines{"R 0 0 20", "R 0 0 250", "R 0 0 10", "R 0 0 5"}));
  EXPECT_TRUE(lost.tells("fanuc-length-ended"));
  EXPECT_FALSE(run("G43 H1 G0 Z20.\nG0 G53 Z0\nG43 H1 Z10.").tells("fanuc-length-ended"));
  EXPECT_FALSE(run("G43 H1 G0 Z20.\nG0 G53 X0\nZ10.").tells("fanuc-length-ended"));
  EXPECT_FALSE(run("G43 H1 G0 Z20.\nG0 G53 Z0\nX10.").tells("fanuc-length-ended"));
  EXPECT_FALSE(run("G43 H1 G0 Z20.\nG49\nG0 G53 Z0\nZ10.").tells("fanuc-length-ended"));
}

// fan-5-nomachine
TEST(FanucReference, WithoutAMachineZeroZGoesToTheStartHeight) {
  for (const char* text : {"G53 Z0", "G91 G28 Z0", "G53 Z-50.", "G91 G30 Z0"}) {
    const IsoRun run = nothing(std::string("G0 Z5.\n") + text);
    EXPECT_EQ(run.motions(), (Lines{"R 0 0 5", "R 0 0 80"})) << text;
    EXPECT_TRUE(tellsPart(run, "machine zero")) << text;
    EXPECT_EQ(run.error(), "") << text;
  }
  EXPECT_EQ(nothing("G0 Z5.\nG53 X0 Y0").motions(), (Lines{"R 0 0 5"}));
  EXPECT_EQ(nothing("G0 X9. Z5.\nG91 G28 X0 Y0").motions(), (Lines{"R 9 0 5"}));
  EXPECT_EQ(nothing("G0 X9. Z5.\nG53 Z0\nG53 X0 Y0", {{"park.1", -40.0}, {"park.2", 60.0}}).motions(),
            (Lines{"R 9 0 5", "R 9 0 80", "R -40 60 80"}));
  EXPECT_EQ(nothing("G0 X9. Z5.\nG53 X0", {{"park.1", -40.0}}).motions(),
            (Lines{"R 9 0 5", "R 9 0 80", "R -40 0 80"}));
  // It is told once.
  int told = 0;
  const IsoRun twice = nothing("G53 Z0\nG0 Z5.\nG53 Z0\nG28 Z0");
  for (const Diagnostic& d : twice.path.diagnostics.all()) told += d.code == "fanuc-machine-zero" ? 1 : 0;
  EXPECT_EQ(told, 1);
}

// Acceptance 56: the head and end of a CAM program.
TEST(FanucReference, HeadOfAPostedProgram) {
  ControlSettings settings = withReference();
  settings.length_offsets[1].geometry = 0.0;
  const IsoRun run = machine(
      "G90 G94 G17 G49 G40 G80\nG21\nG28 G91 Z0.\nG90\nT1 M6\nS5000 M3\nG54\nG0 X-50. Y10.\nG43 Z15. H1\n"
      "G0 Z5.\nG1 Z-2. F300.\nX50. F1000.\nG0 Z15.\nM5\nG28 G91 Z0.\nG90",
      settings);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 0 0 100", "R -50 10 100", "R -50 10 15", "R -50 10 5", "F -50 10 -2",
                                  "F 50 10 -2", "R 50 10 15", "R 50 10 100"}));
}

}  // namespace
}  // namespace proveout::test
