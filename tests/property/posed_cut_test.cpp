// Cuts of tools whose axis turns, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "removal/sweep/motion_bodies.h"
#include "tests/property/random_moves.h"
#include "tests/support/posed_motions.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout {
namespace posed_cut_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

Vec3 leaning(double degrees) { return {0.0, -std::sin(degToRad(degrees)), std::cos(degToRad(degrees))}; }

Tool longTool(const std::string& option) {
  Tool tool = test::tool(option);
  tool.flute_length = 120.0;
  return tool;
}

/// Columns of the bodies of one part on one motion.
class Columns {
 public:
  Columns(const ConvexProfile& part, const test::PosedMotion& motion)
      : path_(motion.path()), solid_(columnSolid(part)) {
    BodyMaker maker(path_, 1.0, 100.0, store_);
    bodies_ = maker.make(0, {&part, &solid_, true, true});
  }
  ColumnSpan at(double x, double y) const {
    ColumnSpan all;
    for (const MotionBody& made : bodies_) {
      double lo = 0.0, hi = 0.0;
      made.body.columns(&x, &y, 1, &lo, &hi);
      if (lo < hi) all = {std::min(all.lo, lo), std::max(all.hi, hi)};
    }
    return all;
  }

 private:
  Toolpath path_;
  ColumnSolid solid_;
  BodyStore store_;
  std::vector<MotionBody> bodies_;
};

TEST(PosedSweep, AFlatEndThatTiltsAboutItsTipReachesBelowIt) {
  constexpr double kRadius = 5.0;
  const ToolSolid solid = makeToolSolid(test::tool("1=flat:10"));
  const test::PosedMotion tilt = test::vectorMotion(Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), leaning(25.0));
  const Columns columns(solid.cutter[0], tilt);
  const double tangent = std::tan(degToRad(25.0)), edge = kRadius * std::cos(degToRad(25.0));
  double off = 0.0;
  for (double y = -4.99; y < 4.9; y += 0.13) {
    // The side that goes down: the end's plane or the flank of the last pose.
    const double flank = -edge * tangent + (-y - edge) / tangent;
    const double low = y > 0.0 ? 0.0 : -y < edge ? y * tangent : flank;
    off = std::max(off, std::abs(columns.at(0.0, y).lo - low));
  }
  EXPECT_LT(off, 1e-7);
  const double lowest = motionField(solid.cutter[0], tilt.asked()).distance({0.0, -edge, -20.0}, kInf);
  EXPECT_NEAR(lowest, 20.0 - kRadius * std::sin(degToRad(25.0)), 1e-7);
}

TEST(PosedSweep, ABallThatTiltsAboutItsCentreSweepsTheBall) {
  const ToolSolid solid = makeToolSolid(test::tool("1=ball:6"));
  const Vec3 center(1.0, 2.0, 3.0);
  test::PosedMotion tilt = test::vectorMotion(center - 3.0 * leaning(-20.0), center - 3.0 * leaning(30.0),
                                              leaning(-20.0), leaning(30.0));
  auto pose = std::make_shared<PoseSweep>();
  pose->beyond = -3.0;
  tilt.axis.pose = pose;
  const SweptField field = motionField(solid.cutter[0], tilt.asked());
  test::RandomMoves moves(3);
  for (int i = 0; i < 200; ++i) {
    Vec3 out = moves.point().normalized();
    out.z() = -std::abs(out.z()) - 1.0;  // below the flanks of all poses
    const Vec3 p = center + moves.number(0.5, 9.0) * out.normalized();
    EXPECT_NEAR(field.distance(p, kInf), (p - center).norm() - 3.0, 1e-8);
  }
}

/// An upright tool over a table that turns goes on a circle: the closed form of level arcs.
TEST(PosedSweep, AStandingToolOverATurningTableCutsARing) {
  const Vec3 origin(400.0, 300.0, -460.0);
  for (const char* const option : {"1=bull:8:1.5", "1=flat:6", "1=ball:6"}) {
    const ToolSolid solid = makeToolSolid(test::tool(option));
    for (const double turn : {360.0, -250.0, 1000.0}) {
      const test::PosedMotion m =
          test::axesMotion(test::trunnion('A'), test::axesAt(origin + Vec3(9.0, 2.0, 55.0), 0.0, 10.0),
                           test::axesAt(origin + Vec3(9.0, 2.0, 55.0), 0.0, 10.0 + turn), 50.0, origin);
      // The table turns left-handed: the tool goes round it the other way than it says.
      ArcGeometry arc;
      arc.center = Vec3(0.0, 0.0, m.motion.from.z());
      arc.sweep_rad = degToRad(turn);
      Vec3 end = Eigen::AngleAxisd(arc.sweep_rad, Vec3::UnitZ()) * m.motion.from;
      if ((end - m.motion.to).norm() > 1e-6) {
        arc.sweep_rad = -arc.sweep_rad;
        end = Eigen::AngleAxisd(arc.sweep_rad, Vec3::UnitZ()) * m.motion.from;
      }
      ASSERT_LT((end - m.motion.to).norm(), 1e-6);
      ASSERT_TRUE(m.asked().turns());
      const SweptField posed = motionField(solid.cutter[0], m.asked());
      const SweptField ring(solid.cutter[0], m.motion.from, m.motion.to, &arc);
      test::RandomMoves moves(5);
      for (int i = 0; i < 300; ++i) {
        const Vec3 p = m.motion.from.z() * Vec3::UnitZ() + 2.0 * moves.point();
        ASSERT_NEAR(posed.distance(p, kInf), ring.distance(p, kInf), 1e-7)
            << option << ' ' << turn << " at " << p.transpose();
      }
    }
  }
}

/// A rotary axis turns a bar under an end mill that goes along it.
test::PosedMotion turnedBar(double radius, double from, double to, double turns) {
  const Vec3 origin(400.0, 300.0, -500.0);  // the table's axis A goes through it
  return test::axesMotion(
      test::trunnion('A'), test::axesAt(origin + Vec3(from, 0.0, radius + 50.0), 0.0, 0.0),
      test::axesAt(origin + Vec3(to, 0.0, radius + 50.0), 360.0 * turns, 0.0), 50.0, origin);
}

TEST(PosedSweep, AnEndMillTurnsACylinder) {
  const ToolSolid solid = makeToolSolid(longTool("1=flat:6"));
  const test::PosedMotion m = turnedBar(7.0, -20.0, 20.0, 12.0);
  const SweptField field = motionField(solid.cutter[0], m.asked());
  test::RandomMoves moves(7);
  for (int i = 0; i < 200; ++i) {
    const double r = moves.number(5.0, 6.99), angle = moves.number(0.0, 6.28);
    const Vec3 p(moves.number(-15.0, 15.0), r * std::cos(angle), r * std::sin(angle));
    EXPECT_NEAR(field.distance(p, kInf), 7.0 - r, 1e-7);
  }
}

TEST(PosedCut, AnEndMillTurnsABlockIntoACylinder) {
  const test::PosedMotion m = turnedBar(7.0, -15.0, 15.0, 12.0);
  const Box3 box{{-8.0, -9.0, -9.0}, {8.0, 9.0, 9.0}};
  const test::Cut cut = test::cut(BoxShape{box.min, box.max}, m.path(), {longTool("1=flat:6")}, 0.5);
  EXPECT_NEAR(cut.volume, kPi * 49.0 * 16.0, 1e-3);
  double off = 0.0;
  std::size_t round = 0;
  for (const auto& vertex : cut.mesh.positions) {
    const Vec3 p = vertex.cast<double>();
    if (std::abs(p.x()) > 7.99) continue;
    off = std::max(off, std::abs(p.tail<2>().norm() - 7.0));
    ++round;
  }
  std::printf("turned cylinder: volume off by %.3g mm3 of %.0f, %zu vertices within %.3g mm\n",
              cut.volume - kPi * 49.0 * 16.0, cut.volume, round, off);
  EXPECT_GT(round, 1000u);
  EXPECT_LT(off, 1e-4);
}

}  // namespace
}  // namespace posed_cut_test
}  // namespace proveout
