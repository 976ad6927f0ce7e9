// What programs have set stays for the next one of the job (iso-fanuc, section 1). fan-1-reset fan-12-vars
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

/// Runs the programs one after the other, each with its settings, as one control does.
IsoRun lastOf(ControlId control, const std::vector<std::pair<std::string, ControlSettings>>& programs) {
  ControlHost host;
  for (const auto& [text, settings] : programs) {
    MemoryProgramSource source("main.nc", text);
    Toolpath path;
    ToolpathBuilder sink(path);
    if (&text == &programs.back().first) break;
    host.person.kept = interpret(control, source, settings, sink, nullptr, host).kept;
  }
  return {control, programs.back().first, programs.back().second, {}, host};
}

Vec3 lastEnd(ControlId control, const std::vector<std::pair<std::string, ControlSettings>>& programs) {
  const IsoRun run = lastOf(control, programs);
  EXPECT_EQ(run.error(), "") << run.message();
  return run.end();
}

ControlSettings withLength(double mm) {
  ControlSettings settings = runAtZero();
  settings.length_offsets[1] = {mm, 0.0};
  return settings;
}

TEST(FanucKept, ToolOffsets) {
  const std::string sets = "O1\nG21 G90\nG10 L10 P1 R60.\nG10 L11 P2 R5.\nM30\n";
  const std::string uses = "O2\nG21 G90 G0\nG43 H1 Z10.\nM30\n";
  EXPECT_NEAR(lastEnd(ControlId::kFanucMill, {{sets, withLength(50)}, {uses, withLength(50)}}).z(), 70.0,
              1e-9);
  // The person has measured the tool anew for the second setup.
  EXPECT_NEAR(lastEnd(ControlId::kFanucMill, {{sets, withLength(50)}, {uses, withLength(52)}}).z(), 62.0,
              1e-9);
  const std::string wear = "O2\nG21 G90 G0\nG43 H2 Z10.\nM30\n";
  EXPECT_NEAR(lastEnd(ControlId::kFanucMill, {{sets, withLength(50)}, {wear, withLength(50)}}).z(), 15.0,
              1e-9);
  // By way of a program that does not touch them.
  EXPECT_NEAR(lastEnd(ControlId::kFanucMill,
                      {{sets, withLength(50)}, {"O3\nM30\n", withLength(50)}, {uses, withLength(50)}})
                  .z(),
              70.0, 1e-9);
}

TEST(FanucKept, OffsetsOfLathes) {
  const std::string sets = "O1\nG21\nG10 P10001 X10. Z3. Q3\nM30\n";
  const std::string uses = "O2\nG21 T0101\nG0 X40. Z0\nM30\n";
  const Vec3 end = lastEnd(ControlId::kFanucLathe, {{sets, latheAt(50, 2)}, {uses, latheAt(50, 2)}});
  EXPECT_LT((end - Vec3(25, 0, 3)).norm(), 1e-9);
}

TEST(FanucKept, FramesThatTheJobDoesNotGive) {
  const std::string sets = "O1\nG21 G90\nG10 L2 P2 X7.\nG10 L2 P1 X5.\nG10 L20 P3 Y4.\nM30\n";
  const std::string uses = "O2\nG21 G90 G0\nG55 X1.\nG54.1 P3 Y1.\nM30\n";
  EXPECT_LT(
      (lastEnd(ControlId::kFanucMill, {{sets, runAtZero()}, {uses, runAtZero()}}) - Vec3(8, 5, 0)).norm(),
      1e-9);
  // G54 is the workpiece's own zero; a frame of the job is entered for each setup.
  EXPECT_NEAR(
      lastEnd(ControlId::kFanucMill, {{sets, runAtZero()}, {"O2\nG21 G90 G0 X1.\nM30\n", runAtZero()}}).x(),
      1.0, 1e-9);
  ControlSettings given = runAtZero();
  given.work_offsets[1] = Vec3(100, 0, 0);
  given.work_given[0] = given.work_given[1] = true;
  EXPECT_NEAR(lastEnd(ControlId::kFanucMill, {{sets, given}, {"O2\nG21 G90 G0 G55 X1.\nM30\n", given}}).x(),
              101.0, 1e-9);
}

TEST(FanucKept, VariablesOfHaas) {
  const ControlSettings settings = runAtZero({{"flavour", 1}});
  EXPECT_LT((lastEnd(ControlId::kFanucMill, {{"O1\n#500=3\n#10300=4\n#8500=5\nM30\n", settings},
                                             {"O2\nG21 G90 G0 X#500 Y#10300 Z#8500\nM30\n", settings}}) -
             Vec3(3, 4, 5))
                .norm(),
            1e-9);
}

}  // namespace
}  // namespace proveout::test
