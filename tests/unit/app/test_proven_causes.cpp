// The cause that is told first is what was put wrong, and with it put right nothing is left.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/session/causes/trial_budget.h"
#include "app/session/session.h"
#include "io/mesh_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

const std::string kProgram =
    "G21 G17 G90 G40 G49 G80 G94\n"  // 1
    "T1 M6\n"                        // 2
    "S4000 M3\n"                     // 3
    "G54 G0 X25 Y20\n"               // 4
    "G43 H1 Z5\n"                    // 5
    "G1 Z-4 F200\n"                  // 6
    "G41 D1 X19 Y16 F600\n"          // 7
    "G3 X25 Y10 R6\n"                // 8
    "G1 X34.5\n"                     // 9
    "G3 X40 Y15.5 R5.5\n"            // 10
    "G1 Y24.5\n"                     // 11
    "G3 X34.5 Y30 R5.5\n"            // 12
    "G1 X15.5\n"                     // 13
    "G3 X10 Y24.5 R5.5\n"            // 14
    "G1 Y15.5\n"                     // 15
    "G3 X15.5 Y10 R5.5\n"            // 16
    "G1 X25\n"                       // 17
    "G3 X31 Y16 R6\n"                // 18
    "G40 G1 X25 Y20\n"               // 19
    "G0 Z50\n"                       // 20
    "T2 M6\n"                        // 21
    "S2500 M3\n"                     // 22
    "G0 X52 Y8\n"                    // 23
    "G43 H2 Z5\n"                    // 24
    "G99 G83 Z-6 R2 Q3 F200\n"       // 25
    "G91 Y12 L2\n"                   // 26
    "G90 G80\n"                      // 27
    "G0 Z50\n"                       // 28
    "M5\n"                           // 29
    "M30\n";                         // 30

class ProvenCauses : public testing::Test {
 protected:
  ProvenCauses() {
    job = app_test::blockJob("plate", {60, 40, 10},
                             {app_test::toolOf(1, 10), app_test::toolOf(2, 6, ToolType::kDrill)});
    job.simulation.resolution_mm = 0.3;
    job.simulation.simplify_mm = 1e-3;
    job.settings.placement.origin = Vec3(0, 0, 0);
    job.settings.work_given[0] = true;
    job.settings.length_offsets = {{1, {0, 0}}, {2, {0, 0}}};
    job.settings.radius_offsets = {{1, {5, 0}}, {2, {3, 0}}};
    const Result<RunResult> right = run(kProgram);
    if (!right.ok() || right->alarm) throw std::runtime_error("the right program does not run");
    const std::string path = folder.path("nominal.stl");
    if (!writeMesh(right->surface().mesh, path, MeshFormat::kStlBinary).ok())
      throw std::runtime_error("no nominal");
    job.nominal.emplace();
    job.nominal->mesh.path = path;
    job.nominal->gouge_mm = 0.02;
    job.nominal->excess_mm = 0.05;
  }

  Result<RunResult> run(const std::string& program) const { return app_test::run(job, {program}); }

  /// Runs a program with a word put otherwise.
  void expectWord(const std::string& right, const std::string& wrong, int line,
                  const std::string& with) const {
    std::string program = kProgram;
    const std::size_t at = program.find(right);
    ASSERT_NE(at, std::string::npos);
    expectFirst(program.replace(at, right.size(), wrong), line, "", with);
  }

  /// `line` 0: the cause is the datum `what`.
  void expectFirst(const std::string& program, std::uint32_t line, const std::string& what,
                   const std::string& with) const {
    const Result<RunResult> done = run(program);
    ASSERT_TRUE(done.ok());
    std::size_t deviations = 0;
    for (const Finding& f : done->findings) {
      if (f.kind != FindingKind::kGouge && f.kind != FindingKind::kExcess) continue;
      ++deviations;
      ASSERT_FALSE(f.causes.empty());
      const Cause& first = f.causes.front();
      SCOPED_TRACE(
          fmt::format("{} at X{:.3f} Y{:.3f} Z{:.3f}", f.message, f.where->x(), f.where->y(), f.where->z()));
      EXPECT_EQ(first.left_mm, 0.0) << first.what << " " << first.value;
      EXPECT_EQ(first.with, with) << first.what << " " << first.value;
      EXPECT_EQ(first.source ? first.source->line : 0, line) << first.what;
      if (line == 0) {
        EXPECT_EQ(first.what, what);
      }
    }
    EXPECT_GT(deviations, 0U);
  }

  test::TemporaryFolder folder;
  Job job;
};

TEST_F(ProvenCauses, TheRightProgramHasNone) {
  const Result<RunResult> done = run(kProgram);
  ASSERT_TRUE(done.ok());
  EXPECT_TRUE(done->comparison->patches.empty());
}

TEST_F(ProvenCauses, SideOfTheCompensation) { expectWord("G41", "G42", 7, "G41"); }
TEST_F(ProvenCauses, DirectionOfAnArc) { expectWord("G3 X40", "G2 X40", 10, "G3"); }
TEST_F(ProvenCauses, CountOfRepeats) { expectWord("L2", "L1", 26, "L2"); }
TEST_F(ProvenCauses, DepthOfACycle) { expectWord("Z-6", "Z-5", 25, "Z-6"); }
TEST_F(ProvenCauses, DepthOfAPocket) { expectWord("Z-4", "Z-3.4", 6, "Z-4."); }
TEST_F(ProvenCauses, PlaceOfAHole) { expectWord("X52", "X53.2", 23, "X52."); }
TEST_F(ProvenCauses, RowOfTheRadius) { expectWord("D1", "D2", 7, "D1"); }
TEST_F(ProvenCauses, StepOrPlace) { expectWord("G91 Y12", "G90 Y12", 26, "G91"); }

TEST_F(ProvenCauses, WhatWasNotTriedIsCounted) {
  // Two mistakes, which no single word explains, in a program of so many motions that few trials take as
  // long.
  std::string program = kProgram;
  program.replace(program.find("G1 Z-4 F200"), 11, "G1 Z-3.4 F200");
  program.replace(program.find("G3 X40 Y15.5 R5.5"), 17, "G3 X40 Y15.5 R7.5");
  const auto untried = [&] {
    const Result<RunResult> done = run(program);
    std::size_t most = 0;
    for (const Finding& f : done->findings) {
      most = std::max(most, f.untried_causes);
      if (!f.causes.empty() && f.causes.front().left_mm == 0.0) {
        EXPECT_EQ(f.untried_causes, 0U);
      }
    }
    return most;
  };
  EXPECT_EQ(untried(), 0U);
  std::string passes;
  for (int i = 0; i < 60000; ++i) passes += i % 2 == 0 ? "G1 X52\n" : "X50\n";
  program.replace(program.find("T2 M6"), 5, "G0 X50 Y20\nG1 Z20 F900\n" + passes + "G0 Z50\nT2 M6");
  EXPECT_GT(untried(), 0U);
}

TEST(TrialBudget, LargeTrialsCountForMore) {
  TrialBudget budget(10, 2000.0);
  budget.takeOne();
  EXPECT_TRUE(budget.takeRest(1000.0));  // no less than one
  budget.takeOne();
  EXPECT_TRUE(budget.takeRest(10000.0));  // four more
  budget.takeOne();
  EXPECT_FALSE(budget.takeRest(9000.0));  // three are left
  EXPECT_EQ(budget.refused(), 1U);
  EXPECT_TRUE(budget.takeRest(8000.0));
  EXPECT_TRUE(budget.isSpent());
}

TEST(TrialBudget, MotionsThatTurnTheToolAreLarge) {
  Toolpath path;
  path.motions.resize(3);
  path.axes.resize(1);
  path.axes[0].to = Vec3(0.1, 0, 1).normalized();
  EXPECT_EQ(trialSize(path), 3.0);
  path.motions[1].axis = 0;
  EXPECT_GT(trialSize(path), 20.0);
}

TEST_F(ProvenCauses, RadiusThatWasEntered) {
  job.settings.radius_offsets[1].geometry = 0.0;
  expectFirst(kProgram, 0, "offsets.radius.1", "offsets.radius.1 = 5");
}

TEST_F(ProvenCauses, ZeroThatWasEntered) {
  job.settings.work_offsets[0] = {0.08, 0, 0};
  expectFirst(kProgram, 0, "offsets.work.G54.x", "offsets.work.G54.x = 0");
}

TEST_F(ProvenCauses, LengthThatWasEntered) {
  job.settings.length_offsets[2].geometry = 0.6;
  expectFirst(kProgram, 0, "offsets.length.2", "offsets.length.2 = 0");
}

TEST_F(ProvenCauses, CornerOfTheTool) {
  job.tools[0].type = ToolType::kBull;
  job.tools[0].corner_radius = 1.0;
  expectFirst(kProgram, 0, "tools.1.corner_radius", "tools.1.corner_radius = 0");
}

TEST_F(ProvenCauses, AngleOfTheDrill) {
  job.tools[1].point_angle_deg = 90.0;
  expectFirst(kProgram, 0, "tools.2.point_angle", "tools.2.point_angle = 118");
}

}  // namespace
}  // namespace proveout
