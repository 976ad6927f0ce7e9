// Where the workpiece really lies against where the offsets say: the path is that of the true workpiece.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/session/programs/first_offset.h"
#include "app/session/programs/placed_path.h"
#include "app/session/session.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

using app_test::run;

Job plateJob() {
  Job job;
  job.name = "plate";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {60, 40, 0}};
  Tool tool;
  tool.number = 1;
  tool.diameter = 10;
  job.tools = {tool};
  job.simulation.resolution_mm = 1.0;
  return job;
}

/// The first cut, which the programs below make to X30 Y20 Z-2.
Vec3 endOfFirstCut(const RunResult& run, std::size_t setup = 0) {
  for (const Motion& motion : run.setups[setup].interpreted.path.motions) {
    if (motion.kind == MotionKind::kFeed) return motion.to;
  }
  return Vec3::Constant(-1e9);
}

std::string plunge(const std::string& offset) {
  return "G21 G90 T1 M6\nS1000 M3\n" + offset + " G0 X30 Y20 Z5\nG1 Z-2 F200\nG0 Z50\nM30\n";
}

/// Tells whether a text is in the messages of a run.
bool says(const RunResult& run, std::string_view text) {
  for (const SetupRun& setup : run.setups) {
    for (const Diagnostic& d : setup.interpreted.path.diagnostics.all()) {
      if (d.message.find(text) != std::string::npos) return true;
    }
  }
  return false;
}

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-9) << a.transpose(); }

TEST(Placement, WithoutOneG54IsTheWorkpiece) {
  Job job = plateJob();
  job.settings.work_offsets[0] = {100, 50, -200};
  job.settings.work_given[0] = true;
  const auto done = run(job, {plunge("G54")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {30, 20, -2});
}

TEST(Placement, AWrongOffsetMovesTheCuts) {
  Job job = plateJob();
  job.settings.placement.origin = Vec3(100, 50, -200);
  job.settings.work_offsets[0] = {100.08, 50, -200.5};
  job.settings.work_given[0] = true;
  auto done = run(job, {plunge("G54")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {30.08, 20, -2.5});
  // The common offset counts with it, and so does what the program sets.
  job.settings.common_offset = {0, 0.25, 0};
  done = run(job, {plunge("G54")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {30.08, 20.25, -2.5});
  done = run(job, {plunge("G10 L2 P1 X101 Y50 Z-200\nG54")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {31, 20.25, -2});
}

TEST(Placement, AnotherOffsetIsHeldAgainstTheSamePlace) {
  Job job = plateJob();
  job.settings.placement.origin = Vec3(100, 50, -200);
  job.settings.work_offsets[0] = {100, 50, -200};
  job.settings.work_offsets[1] = {103, 50, -200};
  job.settings.work_given[0] = job.settings.work_given[1] = true;
  const auto done = run(job, {plunge("G55")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {33, 20, -2});
}

TEST(Placement, AWorkpieceThatIsClampedAskewIsCutAskew) {
  Job job = plateJob();
  job.settings.placement = {Vec3(100, 50, -200), 30.0};
  job.settings.work_offsets[0] = {100, 50, -200};
  job.settings.work_given[0] = true;
  const std::string arc = "G21 G90 T1 M6\nS1000 M3\nG54 G0 X30 Y20 Z5\nG1 Z-2 F200\nG2 X40 Y20 I5 J0\nG0 Z50\nM30\n";
  auto done = run(job, {arc});
  ASSERT_TRUE(done.ok());
  const double c = std::cos(degToRad(30.0)), s = std::sin(degToRad(30.0));
  const auto askew = [&](double x, double y, double z) { return Vec3(c * x + s * y, c * y - s * x, z); };
  expectNear(endOfFirstCut(*done), askew(30, 20, -2));
  const Toolpath& path = done->setups[0].interpreted.path;
  ASSERT_EQ(path.arcs.size(), 1u);
  expectNear(path.arcs[0].center, askew(35, 20, -2));
  // An operator who has measured the angle puts it right.
  job.settings.work_rotations_deg[0] = {0, 0, 30};
  done = run(job, {arc});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {30, 20, -2});
}

TEST(Placement, TheMachineStartsWhereTheJobSays) {
  Job job = plateJob();
  job.settings.placement = {Vec3(100, 50, -200), 30.0};
  job.settings.work_offsets[0] = {90, 50, -200};
  job.settings.work_given[0] = true;
  job.start = Vec3(1, 2, 80);
  const auto done = run(job, {plunge("G54")});
  ASSERT_TRUE(done.ok());
  expectNear(done->setups[0].interpreted.path.motions.front().from, {1, 2, 80});
}

TEST(Placement, MeasuringMovesMeetTheTrueWorkpiece) {
  Job job = plateJob();
  job.settings.placement.origin = Vec3(100, 50, -200);
  job.settings.work_offsets[0] = {102, 50, -200};
  job.settings.work_given[0] = true;
  Tool probe;
  probe.number = 2;
  probe.type = ToolType::kBall;
  probe.diameter = 4;
  job.tools.push_back(probe);
  // The plate's side X0 is at X-2 of the operator's frame: the ball stops its radius before it.
  const auto done = run(job, {"G21 G90 T2 M6\nG54 G0 X-30 Y20 Z20\nG0 Z-5\nG31 X20 F100\nG0 Z50\nM30\n"});
  ASSERT_TRUE(done.ok());
  ASSERT_FALSE(done->alarm);
  const std::vector<Motion>& motions = done->setups[0].interpreted.path.motions;
  const auto probe_move = std::find_if(motions.begin(), motions.end(),
                                       [](const Motion& m) { return m.kind == MotionKind::kProbe; });
  ASSERT_NE(probe_move, motions.end());
  EXPECT_NEAR(probe_move->to.x(), -2.0, 1e-3);
}

TEST(Placement, EachSetupHasItsOwn) {
  Job job = plateJob();
  SetupSpec top, bottom;
  top.name = "top";
  bottom.name = "bottom";
  top.settings = bottom.settings = job.settings;
  bottom.settings.placement.origin = Vec3(0, 0, 0);
  bottom.settings.work_offsets[0] = {0, 0.3, 0};
  bottom.settings.work_given[0] = true;
  bottom.from_previous = {rotationAbout(Vec3::UnitX(), 180), {0, 40, -10}};
  job.setups = {top, bottom};
  const auto done = run(job, {plunge("G54"), plunge("G54")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done, 0), {30, 20, -2});
  expectNear(endOfFirstCut(*done, 1), {30, 20.3, -2});
}

TEST(Placement, OfALatheIsOnItsAxis) {
  Job job;
  job.control = "wl4-lathe";
  job.stock = CylinderShape{2, {0, 0, -50}, 20, 0, 50};
  Tool insert;
  insert.number = 1;
  insert.type = ToolType::kInsert;
  insert.insert.emplace();
  job.tools = {insert};
  job.settings.placement.rotation_deg = 10.0;
  EXPECT_FALSE(run(job, {"G90 T1\nM30\n"}).ok());
}

TEST(FirstOffset, IsWhereTheWorkpieceLiesIfNothingIsCutUnderG54) {
  Job job = plateJob();
  job.settings.work_offsets[1] = {200, 0, 0};
  job.settings.work_given[1] = true;
  auto done = run(job, {plunge("G55")});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {30, 20, -2});
  EXPECT_TRUE(says(*done, "lie where G55 says"));
  // A cut under G54 makes that the place of the workpiece.
  done = run(job, {"G21 G90 T1 M6\nS1000 M3\nG55 G0 X30 Y20 Z5\nG1 Z-2 F200\nG0 Z50\nG54 X0 Y0\nG1 Z1\nG0 Z50\nM30\n"});
  ASSERT_TRUE(done.ok());
  expectNear(endOfFirstCut(*done), {230, 20, -2});
  EXPECT_FALSE(says(*done, "lie where"));
}

TEST(WorkOffsets, ThatAreCalledAndNotGivenAreTold) {
  Job job = plateJob();
  const auto toldOf = [&](const std::string& offset, const std::string& name) {
    const auto done = run(job, {plunge(offset)});
    return done.ok() && says(*done, name + " has no value in the job: 0 is taken");
  };
  EXPECT_FALSE(toldOf("G54", "G54")) << "without any offset G54 is the workpiece's own zero";
  EXPECT_TRUE(toldOf("G55", "G55"));
  EXPECT_TRUE(toldOf("G54.1 P3", "G54.1 P3"));
  EXPECT_FALSE(toldOf("G10 L2 P2 X1 Y2 Z3\nG55", "G55")) << "the program has set it";
  job.settings.work_given[1] = true;
  EXPECT_FALSE(toldOf("G55", "G55"));
  EXPECT_TRUE(toldOf("G54", "G54")) << "others have values";
}

}  // namespace
}  // namespace proveout
