#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "app/run_report.h"
#include "app/session/findings/provenance.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/session.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

using app_test::run;

TEST(RigidTransform, QuarterTurnsAreExact) {
  EXPECT_EQ(rotationAbout(Vec3::UnitX(), 180)(1, 1), -1.0);
  EXPECT_EQ(rotationAbout(Vec3::UnitX(), 180)(2, 1), 0.0);
  EXPECT_EQ((rotationAbout(Vec3(0, 0, 5), -90) * Vec3(1, 2, 3)).eval(), Vec3(2, -1, 3));
  EXPECT_EQ((rotationXyzDeg({90, 0, 90}) * Vec3(0, 1, 0)).eval(), Vec3(0, 0, 1));
  EXPECT_EQ((rotationXyzDeg({90, 0, 90}) * Vec3(0, 0, 1)).eval(), Vec3(1, 0, 0));
  EXPECT_EQ(rotationAbout(Vec3::UnitY(), 270), rotationAbout(Vec3::UnitY(), -90));
}

TEST(RigidTransform, InverseAndBounds) {
  const RigidTransform move{rotationXyzDeg({30, -20, 110}), {1, 2, 3}};
  const Vec3 p(4, -5, 6);
  EXPECT_LT((move.inverse()(move(p)) - p).norm(), 1e-12);
  EXPECT_NEAR(move.rotation.determinant(), 1.0, 1e-12);
  const RigidTransform flip{rotationAbout(Vec3::UnitX(), 180), {0, 40, -20}};
  const Box3 box = flip(Box3{{0, 0, -20}, {60, 40, 0}});
  EXPECT_EQ(box.min, Vec3(0, 0, -20));
  EXPECT_EQ(box.max, Vec3(60, 40, 0));
}

Job blockJob(double resolution) {
  Job job;
  job.name = "block";
  job.control = "nct";
  job.stock = BoxShape{{0, 0, -10}, {20, 20, 0}};
  Tool tool;
  tool.number = 1;
  tool.diameter = 6;
  job.tools = {tool};
  job.simulation.resolution_mm = resolution;
  return job;
}

/// Two clampings of a block of 20 x 20 x 10; the second is turned over about X.
Job twoSetups(double resolution) {
  Job job = blockJob(resolution);
  SetupSpec top, bottom;
  top.name = "top";
  bottom.name = "bottom";
  bottom.from_previous = {rotationAbout(Vec3::UnitX(), 180), {0, 20, -10}};
  job.setups = {top, bottom};
  return job;
}

std::string hole(double x, double y, double z) {
  return fmt::format("G21 G90 T1 M6\nS1000 M3\nG0 X{} Y{} Z5\nN40 G1 Z{} F200\nN50 G0 Z5\nM30\n", x, y, z);
}

TEST(Setups, MovedStockKeepsItsVolumeAndPlace) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.25;
  const Result<Stock> tube = Stock::create(CylinderShape{2, {0, 0, 0}, 8, 3, 10}, options, progress);
  ASSERT_TRUE(tube.ok());
  const RigidTransform move{rotationXyzDeg({25, 40, -15}), {5, 6, 7}};
  const Result<Stock> moved = tube->moved(move, options, progress);
  ASSERT_TRUE(moved.ok()) << moved.error().message;
  const Result<StockSurface> surface = moved->surface(0, progress);
  ASSERT_TRUE(surface.ok());
  EXPECT_TRUE(analyseTopology(surface->mesh).closedManifold());
  EXPECT_NEAR(surface->volume_mm3, kPi * (64 - 9) * 10, 4.0);
  const RigidTransform back = move.inverse();
  double off = 0;
  for (const auto& p : surface->mesh.positions) {
    const Vec3 q = back(p.cast<double>());
    const double r = std::hypot(q.x(), q.y());
    const bool at_wall = q.z() > 0.25 && q.z()<9.75, at_end = r> 3.25 && r < 7.75;
    EXPECT_TRUE(r > 2.75 && r < 8.25 && q.z() > -0.25 && q.z() < 10.25);  // edges to a part of a cell
    if (at_wall) off = std::max(off, std::min(std::abs(r - 8), std::abs(r - 3)));
    if (at_end) off = std::max(off, std::min(std::abs(q.z()), std::abs(q.z() - 10)));
  }
  const double chord = 0.25 * 0.25 / (8 * 3);
  EXPECT_LT(off, 4 * chord + 0.005);
}

TEST(Setups, TheSecondProgramCutsTheOtherSide) {
  const Result<RunResult> result = run(twoSetups(0.25), {hole(6, 5, -4), hole(14, 12, -3)});
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_EQ(result->setups.size(), 2u);
  EXPECT_TRUE(result->findings.empty());
  EXPECT_TRUE(result->topology().closedManifold());
  EXPECT_NEAR(result->surface().volume_mm3, 4000 - kPi * 9 * 7, 1.0);
  for (std::size_t k = 0; k < 2; ++k) {
    double removed = 0;
    for (const float v : result->setups[k].removal.removed_mm3) removed += static_cast<double>(v);
    EXPECT_NEAR(removed, kPi * 9 * (4.0 - static_cast<double>(k)), 0.6);
  }
  // Of the first hole, now at (6, 15) and below: its floor at z = -6, of which the rim has vertices.
  const auto& positions = result->surface().mesh.positions;
  const bool floor = std::any_of(positions.begin(), positions.end(), [](const Eigen::Vector3f& p) {
    return std::hypot(p.x() - 6.f, p.y() - 15.f) < 3.01f && std::abs(p.z() + 6.f) < 0.01f;
  });
  EXPECT_TRUE(floor);
  EXPECT_DOUBLE_EQ(movesUncertainty(*result), 0.0);  // half a turn is exact
}

TEST(Setups, TurnsThatAreNotQuartersCountTheirChords) {
  Job job = twoSetups(0.5);
  job.setups[1].from_previous.rotation = rotationAbout(Vec3::UnitZ(), 30);
  job.setups[1].from_previous.translation = Vec3::Zero();
  const Result<RunResult> result = run(job, {hole(10, 10, -4), "G21 G90 T1 M6\nM30\n"});
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_GT(movesUncertainty(*result), 0.0);
  EXPECT_DOUBLE_EQ(partUncertainty(*result), 2 * movesUncertainty(*result));
  EXPECT_NEAR(result->surface().volume_mm3, 4000 - kPi * 9 * 4, 4.0);
}

Motion feed(const Vec3& from, const Vec3& to) {
  Motion motion;
  motion.from = from;
  motion.to = to;
  motion.spindle = 1000;
  motion.tool = 1;
  motion.kind = MotionKind::kFeed;
  return motion;
}

/// All turns that take axes to axes: the same surface, and on it no vertex in a ball's sweep.
TEST(Setups, QuarterTurnsMoveTheStockExactly) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.25;
  Result<Stock> stock = Stock::create(BoxShape{{0, 0, -10}, {20, 16, 0}}, options, progress);
  ASSERT_TRUE(stock.ok());
  Tool ball;
  ball.number = 1;
  ball.type = ToolType::kBall;
  ball.diameter = 6;
  Toolpath path;
  path.files = {"p"};
  path.motions = {feed({3, 4, -2}, {17, 9, -4}), feed({5, -5, -8}, {12, 5, -3})};
  ASSERT_TRUE(stock->remove(path, {ball}, options, progress).ok());
  const StockSurface before = *stock->surface(0, progress);
  for (int i = 0; i < 64; ++i) {
    const RigidTransform move{rotationXyzDeg({90.0 * (i & 3), 90.0 * (i >> 2 & 3), 90.0 * (i >> 4)}),
                              {1.3, -2, 7}};
    ASSERT_TRUE(movesExactly(move));
    const Result<Stock> moved = stock->moved(move, options, progress);
    ASSERT_TRUE(moved.ok());
    const Result<StockSurface> after = moved->surface(0, progress);
    ASSERT_TRUE(after.ok());
    // What cut the stock is not known any more, and vertices on creases are as good as the crossings show.
    EXPECT_NEAR(after->volume_mm3, before.volume_mm3, 3e-5 * before.volume_mm3) << i;
    EXPECT_NEAR(meshArea(after->mesh), meshArea(before.mesh), 1e-3 * meshArea(before.mesh)) << i;
    ASSERT_TRUE(analyseTopology(after->mesh).closedManifold()) << i;
    double out = -1;
    const RigidTransform back = move.inverse();
    for (const auto& position : after->mesh.positions) {
      const Vec3 p = back(position.cast<double>());
      for (const Motion& m : path.motions) {
        const Vec3 a = m.from + Vec3(0, 0, 3), d = m.to - m.from;
        const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        out = std::max(out, 3 - (p - a - t * d).norm());
      }
    }
    EXPECT_LT(out, 0.004) << i;
  }
}

TEST(Setups, SurfacesRememberTheSetupThatMadeThem) {
  const Job job = twoSetups(0.25);
  const Result<RunResult> result = run(job, {hole(6, 5, -4), hole(14, 12, -3)});
  ASSERT_TRUE(result.ok());
  const auto made = madeEarlier(*result, {6, 15, -6}, 0.5);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->setup, 0u);
  const Toolpath& path = result->setups[0].interpreted.path;
  EXPECT_EQ(path.motions[made->motion].source.block, 40);
  EXPECT_FALSE(madeEarlier(*result, {0, 10, -5}, 0.5).has_value());  // the blank's side
  EXPECT_FALSE(madeEarlier(*result, {6, 15, 20}, 0.5).has_value());  // nothing there
  EXPECT_LT((inLastFrame(*result, 0, {6, 5, -4}) - Vec3(6, 15, -6)).norm(), 1e-12);
}

TEST(Setups, FindingsNameTheirSetup) {
  const std::string crash = "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y10 Z5\nN40 G0 Z-3\nG0 Z5\nM30\n";
  const Job job = twoSetups(0.5);
  const Result<RunResult> result = run(job, {crash, hole(5, 5, -1)});
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result->findings.size(), 1u) << result->findings[1].message;
  EXPECT_EQ(result->findings[0].kind, FindingKind::kRapidContact);
  EXPECT_EQ(result->findings[0].setup, "top");
  EXPECT_EQ(result->findings[0].source->block, 40);
}

TEST(Setups, AnAlarmInTheSecondProgramCutsNothing) {
  const Result<RunResult> result = run(twoSetups(0.5), {hole(6, 5, -4), "G777\nM30\n"});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->alarm);
  EXPECT_FALSE(result->stock.has_value());
  ASSERT_FALSE(result->findings.empty());
  EXPECT_EQ(result->findings[0].setup, "bottom");
}

TEST(Setups, NothingLeftEndsTheRun) {
  Job job = twoSetups(0.5);
  job.tools[0].diameter = 60;
  const std::string all = "G21 G90 T1 M6\nS1000 M3\nG0 X-50 Y10 Z5\nZ-11\nG1 X70 F500\nM30\n";
  const Result<RunResult> result = run(job, {all, hole(6, 5, -4)});
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_EQ(result->setups.size(), 1u);
  ASSERT_EQ(result->findings.size(), 1u);
  EXPECT_EQ(result->findings[0].kind, FindingKind::kNoPart);
}

}  // namespace
}  // namespace proveout
