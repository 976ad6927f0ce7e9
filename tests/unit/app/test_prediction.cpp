#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/console.h"
#include "app/session/forecast/machine_speed.h"
#include "app/session/forecast/prediction.h"
#include "core/base/thread_limit.h"

namespace proveout {
namespace {

Motion feed(const Vec3& from, const Vec3& to) {
  Motion motion;
  motion.from = from;
  motion.to = to;
  motion.tool = 1;
  motion.kind = MotionKind::kFeed;
  return motion;
}

std::vector<Tool> flat(double diameter) {
  Tool tool;
  tool.number = 1;
  tool.diameter = diameter;
  return {tool};
}

const Box3 kBlock{{0, 0, -20}, {100, 50, 0}};
constexpr double kBlockArea = 2 * (100 * 50 + 50 * 20 + 20 * 100);

TEST(Workload, BlankAreas) {
  EXPECT_DOUBLE_EQ(blankArea(BoxShape{kBlock.min, kBlock.max}, kBlock), kBlockArea);
  EXPECT_DOUBLE_EQ(blankArea(CylinderShape{2, {0, 0, 0}, 5, 0, 10}, {}), 2 * kPi * (50 + 25));
  EXPECT_DOUBLE_EQ(blankArea(CylinderShape{2, {0, 0, 0}, 5, 3, 10}, {}), 2 * kPi * (8 * 10 + 16));
}

TEST(Workload, ASlotAddsItsWalls) {
  Toolpath path;
  path.motions = {feed({-10, 25, -5}, {110, 25, -5})};
  const Workload work = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_NEAR(work.surface_mm2, kBlockArea + 2 * 5 * 100, 150);
  EXPECT_DOUBLE_EQ(work.swept_mm2, (2 * 120 + 10) * 10);
  EXPECT_EQ(work.motions, 1u);
  // The same slot again sweeps as much, and cuts nothing.
  path.motions.push_back(path.motions[0]);
  const Workload twice = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_DOUBLE_EQ(twice.surface_mm2, work.surface_mm2);
  EXPECT_DOUBLE_EQ(twice.swept_mm2, 2 * work.swept_mm2);
}

TEST(Workload, ACutterWithFlanksLeavesThemStanding) {
  Toolpath path;
  path.motions = {feed({-10, 20, -5}, {110, 20, -5}), feed({-10, 30, -5}, {110, 30, -5})};
  std::vector<Tool> cone = flat(20);
  cone[0].type = ToolType::kCone;
  cone[0].tip_diameter = 4.0;
  cone[0].cone_angle_deg = 90.0;
  // Two floors of 4 mm, four flanks at 45 degrees: from 5 deep to the top, and 3 mm up between the two.
  const double flanks = std::sqrt(2.0) * (2 * 5 + 2 * 3) * 100;
  EXPECT_NEAR(workloadOf(path, cone, kBlock, kBlockArea).cut_mm2, flanks, 0.1 * flanks);
  // Flat, they are one floor between two walls.
  EXPECT_NEAR(workloadOf(path, flat(20), kBlock, kBlockArea).cut_mm2, 2 * 5 * 100, 150);
}

TEST(Workload, CuttingThroughTakesTopAndBottomAway) {
  Toolpath path;
  path.motions = {feed({-10, 25, -30}, {110, 25, -30})};
  const double walls = 2 * 20 * 100, gone = 2 * 10 * 100;
  EXPECT_NEAR(workloadOf(path, flat(10), kBlock, kBlockArea).surface_mm2, kBlockArea + walls - gone, 400);
}

TEST(Workload, MotionsAboveOrBesideTheBlankDoNotCount) {
  Toolpath path;
  path.motions = {feed({0, 25, 5}, {100, 25, 5}), feed({0, 80, -5}, {100, 80, -5})};
  const Workload work = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_DOUBLE_EQ(work.surface_mm2, kBlockArea);
  EXPECT_DOUBLE_EQ(work.swept_mm2, 0.0);
  EXPECT_EQ(work.motions, 2u);
}

TEST(Workload, AnArcIsFollowed) {
  Toolpath path;
  Motion circle = feed({65, 25, -5}, {65, 25, -5});
  circle.arc = 0;
  path.arcs = {{{50, 25, -5}, Vec3::UnitZ(), 2 * kPi}};
  path.motions = {circle};
  const Workload work = workloadOf(path, flat(4), kBlock, kBlockArea);
  EXPECT_NEAR(work.surface_mm2, kBlockArea + 2 * kPi * (17 + 13) * 5, 0.15 * 2 * kPi * 30 * 5);
}

TEST(Workload, LongLinesOfAFlatEndLeavePlanes) {
  Toolpath path;
  path.motions = {feed({-10, 25, -5}, {110, 25, -5})};
  const Workload slot = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_GT(slot.flat_mm2, 0.0);
  EXPECT_DOUBLE_EQ(slot.flat_mm2, slot.cut_mm2);
  std::vector<Tool> ball = flat(10);
  ball[0].type = ToolType::kBall;
  const Workload groove = workloadOf(path, ball, kBlock, kBlockArea);
  EXPECT_DOUBLE_EQ(groove.ruled_mm2, groove.cut_mm2);
  EXPECT_EQ(groove.uneven_mm2, 0.0);
  // A hole is round, more so the smaller it is.
  path.motions = {feed({50, 25, 5}, {50, 25, -5})};
  const Workload hole = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_EQ(hole.flat_mm2 + hole.ruled_mm2, 0.0);
  EXPECT_NEAR(hole.bends_mm, hole.cut_mm2 / 5.0, 1e-6 * hole.cut_mm2);
  EXPECT_EQ(slot.stepped_mm2 + hole.stepped_mm2, 0.0);
  // A short line that goes down leaves the rim's steps.
  path.motions = {feed({50, 25, -4}, {55, 25, -5})};
  const Workload ramp = workloadOf(path, flat(10), kBlock, kBlockArea);
  EXPECT_DOUBLE_EQ(ramp.stepped_mm2, ramp.cut_mm2);
  EXPECT_EQ(workloadOf(path, ball, kBlock, kBlockArea).stepped_mm2, 0.0);
  Workload uncut;
  uncut.surface_mm2 = slot.surface_mm2;
  EXPECT_LT(predict(slot, 0.1).time_s - predict(uncut, 0.1).time_s, 0.1);
}

TEST(MachineSpeed, IsThatOfThisMachine) {
  const double slowness = measureMachine(0.0).slowness;
  EXPECT_NE(slowness, 1.0);  // which stands for a piece that could not be cut
  EXPECT_GT(slowness, 0.02);
  EXPECT_LT(slowness, 500.0);
}

TEST(MachineSpeed, CountsTheThreadsThatARunMayUse) {
  const ThreadLimit one(1);
  EXPECT_EQ(measureMachine(0.0).threads, 1);
  // What one thread does alone takes as long with any number, the rest at most so much less.
  const Prediction predicted{100.0, 10.0, 4.0};
  const auto time_s = [&](int threads, double slowness) {
    return predictedOn({threads, slowness}, predicted).time_s;
  };
  EXPECT_DOUBLE_EQ(time_s(2, 1.0), 10.0);
  EXPECT_DOUBLE_EQ(time_s(2, 3.0), 30.0);
  EXPECT_GT(time_s(1, 1.0), 13.0);
  EXPECT_LT(time_s(1, 1.0), 16.0);
  EXPECT_LT(time_s(4, 1.0), 9.0);
  EXPECT_GT(time_s(64, 1.0), 4.0);
}

Toolpath arcInXz(double lean_mm) {
  Toolpath path;
  Motion arc = feed({20, 20, -2}, {60, 20 + lean_mm, -2});
  arc.arc = 0;
  path.arcs = {{{40, 20, 20}, Vec3::UnitY(), 1.5}};
  path.motions = {arc};
  return path;
}

TEST(Workload, OnlyLeaningArcsOfToolsWithoutVectorsAreChords) {
  const auto chords = [](double lean_mm, ToolType type) {
    std::vector<Tool> tools = flat(6);
    tools[0].type = type;
    tools[0].cone_angle_deg = 60.0;
    return workloadOf(arcInXz(lean_mm), tools, kBlock, kBlockArea)
        .curves[static_cast<std::size_t>(CurveKind::kChords)]
        .chords;
  };
  EXPECT_GT(chords(5.0, ToolType::kCone), 0.0);
  EXPECT_GT(chords(5.0, ToolType::kLollipop), 0.0);
  EXPECT_EQ(chords(0.0, ToolType::kCone), 0.0);
  EXPECT_EQ(chords(5.0, ToolType::kBall), 0.0);
}

TEST(Prediction, GrowsWithTheSquareOfTheGridAndWithTheWork) {
  Workload work;
  work.surface_mm2 = 1e5;
  const Prediction coarse = predict(work, 0.4), fine = predict(work, 0.2), finer = predict(work, 0.1);
  EXPECT_NEAR((finer.memory_mb - fine.memory_mb) / (fine.memory_mb - coarse.memory_mb), 4.0, 1e-6);
  EXPECT_GT(finer.time_s, fine.time_s);
  Workload more = work;
  more.motions = 1000000;
  more.nominal_mm2 = 1e5;
  more.pixels = 1e6;
  more.pictures = 2;
  EXPECT_GT(predict(more, 0.2).memory_mb, fine.memory_mb);
  EXPECT_GT(predict(more, 0.2).time_s, fine.time_s);
  const Workload both = together(work, more);
  EXPECT_DOUBLE_EQ(both.surface_mm2, 1e5);
  EXPECT_EQ(both.motions, 1000000u);
}

TEST(Prediction, EveryPartOfTheWorkCounts) {
  Workload plain;
  plain.surface_mm2 = plain.cut_mm2 = 1e5;
  plain.clampings = 1;
  const Prediction base = predict(plain, 0.2);
  const auto expectMore = [&](const char* name, bool memory, const auto& change) {
    Workload more = plain;
    change(more);
    EXPECT_GT(predict(more, 0.2).time_s, base.time_s) << name;
    EXPECT_EQ(predict(more, 0.2).memory_mb > base.memory_mb, memory) << name;
    const Workload both = together(plain, more);
    EXPECT_GE(predict(both, 0.2).time_s, predict(more, 0.2).time_s) << name;
    EXPECT_DOUBLE_EQ(predict(both, 0.2).memory_mb, predict(more, 0.2).memory_mb) << name;
  };
  expectMore("mesh blank", true, [](Workload& w) { w.blank_triangles = 1e5; });
  expectMore("saved stock", true, [](Workload& w) { w.reads_grid = true; });
  expectMore("stock to save", true, [](Workload& w) { w.writes_grid = true; });
  expectMore("text", false, [](Workload& w) { w.text_files = 1; });
  expectMore("second clamping", false, [](Workload& w) { w.clampings = 2; });
  expectMore("turned clamping", true, [](Workload& w) { w.mesh_moves = 1; });
  expectMore("fixture", true, [](Workload& w) { w.fixture_mm2 = 1e5; });
  expectMore("mesh as fixture", true, [](Workload& w) { w.fixture_mesh_mm2 = 1e5; });
  expectMore("turned lines", true, [](Workload& w) { w.turned_motions = 10000; });
  expectMore("threads", true, [](Workload& w) { w.triangles = w.thread_triangles = 1e5; });
  expectMore("turned, on a grid", true, [](Workload& w) { w.turned_mm2 = 1e4; });
  expectMore("threads on a grid", true, [](Workload& w) { w.threaded_mm2 = 1e4; });
  expectMore("round walls", false, [](Workload& w) { w.bends_mm = 1e4; });
  expectMore("terraces", false, [](Workload& w) { w.stepped_mm2 = 1e4; });
  const auto curve = [](CurveKind kind) {
    return [kind](Workload& w) { w.curves[static_cast<std::size_t>(kind)] = {1e3, 1e3, 1e5}; };
  };
  expectMore("leaning lines", true, curve(CurveKind::kLeansOnLine));
  expectMore("leaning lines, searched", true, curve(CurveKind::kLeanSearched));
  expectMore("leaning circles", true, curve(CurveKind::kLeansOnArc));
  expectMore("leaning circles of bull noses", true, curve(CurveKind::kLeanCornerArc));
  expectMore("chords of leaning curves", true, curve(CurveKind::kLeanChords));
  expectMore("turning tools", true, curve(CurveKind::kTurns));
  expectMore("their poses", true, curve(CurveKind::kPoses));
  expectMore("their poses, with edges", true, curve(CurveKind::kEdgedPoses));
  expectMore("turning tools, searched", true, curve(CurveKind::kTurnsSearched));
  expectMore("thin triangles", true, [](Workload& w) { w.blank_triangles = 1.0, w.blank_thin_mm = 1e6; });
}

TEST(Prediction, BodiesThatLeanAreAskedByTheComparison) {
  Workload work;
  work.surface_mm2 = work.nominal_mm2 = 1e4;
  const double base = predict(work, 0.2).time_s;
  work.lean_asked = 5.0;
  const double leaning = predict(work, 0.2).time_s;
  EXPECT_GT(leaning, base);
  work.turn_asked = 5.0;
  EXPECT_GT(predict(work, 0.2).time_s, leaning);
}

/// A line on which the tool's axis is this, and that at its end.
Toolpath tilted(const Vec3& from, const Vec3& to, const Vec3& axis_from, const Vec3& axis_to) {
  Toolpath path;
  path.motions = {feed(from, to)};
  path.motions[0].axis = 0;
  path.axes.resize(1);
  path.axes[0].from = axis_from.normalized();
  path.axes[0].to = axis_to.normalized();
  return path;
}

TEST(Workload, ToolsThatLeanOrTurnHaveKindsOfTheirOwn) {
  const auto of = [](const Toolpath& path, ToolType type, CurveKind kind) {
    std::vector<Tool> tools = flat(6);
    tools[0].type = type;
    tools[0].corner_radius = 1.0;
    return workloadOf(path, tools, kBlock, kBlockArea).curves[static_cast<std::size_t>(kind)];
  };
  const Vec3 lean(0.3, 0, 1), from(20, 25, -5), to(60, 25, -5);
  const Toolpath leaning = tilted(from, to, lean, lean), turning = tilted(from, to, Vec3::UnitZ(), lean);
  EXPECT_EQ(of(leaning, ToolType::kBall, CurveKind::kLeansOnLine).chords, 1.0);
  EXPECT_NEAR(of(leaning, ToolType::kBall, CurveKind::kLeansOnLine).columns_mm2, 48 * 6, 30);
  EXPECT_EQ(of(leaning, ToolType::kBull, CurveKind::kLeanSearched).chords, 1.0);
  EXPECT_EQ(of(turning, ToolType::kFlat, CurveKind::kTurns).chords, 1.0);
  EXPECT_EQ(of(turning, ToolType::kBull, CurveKind::kTurns).chords, 1.0);
  // Poses stand by sqrt(8 r e), and the far end of the tool goes farther than its tip.
  const double poses = of(turning, ToolType::kFlat, CurveKind::kEdgedPoses).chords;
  EXPECT_GT(poses, 40 / std::sqrt(8 * 3 * 5e-5));
  EXPECT_LT(poses, 60 / std::sqrt(8 * 3 * 5e-5));
  // Closer where corners of a radius of 1 are round.
  EXPECT_NEAR(of(turning, ToolType::kBull, CurveKind::kEdgedPoses).chords, std::sqrt(3.0) * poses,
              1e-6 * poses);
  const Toolpath away = tilted({20, 25, 30}, {60, 25, 30}, Vec3::UnitZ(), lean);
  EXPECT_EQ(of(away, ToolType::kFlat, CurveKind::kTurns).chords, 0.0);
}

TEST(Workload, WhereToolsThatTurnPassAgainLittleIsLeftForThem) {
  const Vec3 lean(0.3, 0, 1);
  Toolpath path = tilted({20, 25, -5}, {60, 25, -5}, Vec3::UnitZ(), lean);
  const auto turns = [&] {
    return workloadOf(path, flat(6), kBlock, kBlockArea).curves[static_cast<std::size_t>(CurveKind::kTurns)];
  };
  EXPECT_EQ(turns().fresh, turns().chords);
  path.motions.resize(1000, path.motions[0]);
  EXPECT_EQ(turns().chords, 1000.0);
  EXPECT_NEAR(turns().fresh, 100.0, 1e-9);
}

TEST(Workload, ToolsThatLieLeaveNoMoreThanTheFaceThatTheyAreSeenFrom) {
  Toolpath path = tilted({10, -1, -5}, {90, -1, -5}, -Vec3::UnitY(), -Vec3::UnitY());
  path.motions[0].from.y() = path.motions[0].to.y() = 1.0;
  const Workload one = workloadOf(path, flat(6), kBlock, kBlockArea);
  EXPECT_NEAR(one.cut_mm2, 6 * 80, 1.0);
  path.motions.resize(50, path.motions[0]);
  EXPECT_NEAR(workloadOf(path, flat(6), kBlock, kBlockArea).cut_mm2, 100 * 20, 1.0);
}

TEST(Prediction, FindsTheGridThatFits) {
  Workload work;
  work.surface_mm2 = 1e6;
  const double limit = 0.5 * predict(work, 0.1).memory_mb;
  const double fits = resolutionThatFits(work, 0.1, limit);
  EXPECT_GT(fits, 0.1);
  EXPECT_NEAR(predict(work, fits).memory_mb, limit, 1e-6 * limit);
  EXPECT_DOUBLE_EQ(resolutionThatFits(work, 0.1, 1e9), 0.1);
  EXPECT_TRUE(std::isinf(resolutionThatFits(work, 0.1, 1.0)));
  // Pictures share the memory that the stock gave back: what fits still does.
  work.pixels = 1e7;
  work.pictures = 1;
  const double drawn = resolutionThatFits(work, 0.1, limit);
  EXPECT_NEAR(predict(work, drawn).memory_mb, limit, 1e-6 * limit);
  EXPECT_GT(availableMemoryMb(), 1.0);
}

TEST(Prediction, TimeLeftIsTold) {
  std::ostringstream out;
  double now = 0;
  ConsoleProgress progress(out, [&] { return now; });
  progress.expect({100, 20});
  EXPECT_EQ(out.str(), "");  // nothing is shown yet
  progress.show(true);
  progress.expect({123, 20});
  EXPECT_NE(out.str().find("about 20 s and 123 MB"), std::string::npos) << out.str();
  now = 1;
  progress.report("removing", 0.0);
  EXPECT_EQ(out.str().find("left"), std::string::npos);
  now = 8;
  progress.report("removing", 0.7);  // 3 s more at this pace, but 12 s of what was predicted
  EXPECT_NE(out.str().find("removing 70 %, 12 s left"), std::string::npos) << out.str();
  progress.report("meshing", 0.0);
  now = 28;
  progress.report("meshing", 0.1);  // the prediction is used up; at this pace 180 s more
  EXPECT_NE(out.str().find("meshing 10 %, 3 min left"), std::string::npos) << out.str();
}

}  // namespace
}  // namespace proveout
