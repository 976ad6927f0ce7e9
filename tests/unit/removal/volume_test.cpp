// One integral before and after a path; thin blanks; helices of many turns.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/geometry/rigid_transform.h"
#include "core/tool/tool_solid.h"
#include "removal/sweep/sweep.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

Result<Stock> make(const StockShape& shape, double grid) {
  RemovalOptions options;
  options.resolution_mm = grid;
  Progress progress;
  return Stock::create(shape, options, progress);
}

/// A path beside the blank leaves the same volume to the last bit, and surface() tells it as volume() does.
TEST(StockVolume, IsTheSameWhereNothingIsCut) {
  const std::vector<StockShape> shapes = {
      BoxShape{{0.13, 0.2, -7.77}, {20.1, 15.3, 0}}, CylinderShape{0, {1.2, 3.4, 5.6}, 1.1, 0.0, 9.7},
      CylinderShape{2, {1.2, 3.4, 5.6}, 6.1, 4.9, 9.7}, CylinderShape{1, {0, 0, 0}, 2.3, 0.0, 1.3}};
  PathMaker path;
  path.line({-90, -90, 60}, {90, -90, 60}).line({-90, -90, 60}, {90, -90, 60}, MotionKind::kRapid);
  Progress progress;
  for (const double grid : {0.3, 0.5}) {
    for (const StockShape& shape : shapes) {
      Result<Stock> stock = make(shape, grid);
      ASSERT_TRUE(stock.ok());
      RemovalOptions options;
      options.resolution_mm = grid;
      for (const double simplify_mm : {-1.0, 0.0, 1e-5, 0.2}) {
        SurfaceOptions surface;
        surface.simplify_mm = simplify_mm;
        const double before = stock->volume(surface, progress)->mm3;
        ASSERT_TRUE(stock->remove(path.path(), {tool("1=ball:4")}, options, progress).ok());
        EXPECT_EQ(stock->surface(surface, progress)->volume_mm3, before);
        EXPECT_EQ(stock->volume(surface, progress)->mm3, before);
      }
    }
  }
}

/// What a path of a flat end leaves of a block is less than before by this, as part of `exact`; 0 is right.
double offBy(const Toolpath& path, double radius, double exact) {
  RemovalOptions options;
  options.resolution_mm = 0.25;
  Progress progress;
  Result<Stock> stock = make(BoxShape{{-8.123, -8.169, -4.09}, {36.06, 36.06, 0}}, options.resolution_mm);
  const double before = stock->volume(SurfaceOptions{}, progress)->mm3;
  EXPECT_TRUE(
      stock->remove(path, {tool(fmt::format("1=flat:{:.17g}", 2.0 * radius))}, options, progress).ok());
  return (before - stock->volume(SurfaceOptions{}, progress)->mm3) / exact - 1.0;
}

/// Where a wall that a tool leaves in passing goes over into the round of its end, quads bent as both: up to
/// 2.5e-5 of slots of 2 mm on 0.25 mm, 1.4e-5 of arcs around what is left of a pillar of 0.8 mm.
TEST(StockVolume, KnowsWhereWallsGoOverIntoTheRoundOfTheirEnds) {
  constexpr double kDepth = 0.7226, kLength = 6.0, kTurn = 200.0;
  double slots = 0.0, arcs = 0.0;
  for (int i = 0; i < 12; ++i) {
    const Vec3 from(12 + 0.031 * i, 10 + 0.047 * i, -kDepth), up(0, 0, 5);
    const auto round = [](double angle) { return Vec3(std::cos(angle), std::sin(angle), 0.0); };
    const Vec3 to = from + kLength * round(0.1 + 0.26 * i);
    PathMaker slot;
    slot.line(from + up, from).line(from, to).line(to, to + up);
    slots = std::max(slots, std::abs(offBy(slot.path(), 1.0, (2.0 * kLength + kPi) * kDepth)));
    constexpr double kRadius = 3.7135, kPillar = 0.4, kWay = kRadius + kPillar;
    const double start = 0.3 + 0.2 * i, turn = degToRad(kTurn);
    const Vec3 first = from + kWay * round(start), last = from + kWay * round(start + turn);
    PathMaker arc;
    arc.line(first + up, first).arc(first, from, Vec3::UnitZ(), kTurn).line(last, last + up);
    const double swept = 2.0 * turn * kWay * kRadius + kPi * kRadius * kRadius;
    arcs = std::max(arcs, std::abs(offBy(arc.path(), kRadius, swept * kDepth)));
  }
  std::printf("ends of ways: slots %.1e, arcs %.1e\n", slots, arcs);
  EXPECT_LT(slots, 1e-5);
  EXPECT_LT(arcs, 3e-6);
}

/// The facets of a cylinder that was turned lean from each other by 10 to 40 degrees in a cell.
TEST(StockVolume, IsTheSameOfATurnedCylinderWhereNothingIsCut) {
  PathMaker path;
  path.line({-90, -90, 60}, {90, -90, 60});
  RemovalOptions options;
  options.resolution_mm = 1.0;
  Progress progress;
  const RigidTransform move{rotationXyzDeg({180, 0, 33}), {-1.5103, 3.2608, -1.5875}};
  for (const double radius : {1.0485, 2.3, 3.3, 6.9869}) {
    for (int axis = 0; axis < 3; ++axis) {
      const CylinderShape shape{axis, {-13.9515, 19.6508, -17.1327}, radius, 0.0, 9.666};
      const Result<Stock> blank = make(shape, options.resolution_mm);
      ASSERT_TRUE(blank.ok());
      Result<Stock> stock = blank->moved(move, options, progress);
      ASSERT_TRUE(stock.ok());
      const double before = stock->volume({}, progress)->mm3;
      ASSERT_TRUE(stock->remove(path.path(), {tool("1=ball:4")}, options, progress).ok());
      EXPECT_EQ(stock->volume({}, progress)->mm3, before) << radius << " along " << axis;
    }
  }
}

/// Two tangent planes of a thin cylinder meet in a line, which is no apex of it.
TEST(StockVolume, ThinCylindersAreNotHeavierThanTheyAre) {
  Progress progress;
  for (const double radius : {1.5, 1.75, 2.0, 2.3, 3.0}) {
    for (int i = 0; i < 12; ++i) {
      const CylinderShape shape{i % 3, Vec3(0.13, 0.37, 0.71) * i, radius, 0.0, 6.0 + 0.31 * i};
      const Result<Stock> stock = make(shape, 1.0);
      ASSERT_TRUE(stock.ok());
      const double off = stock->volume({}, progress)->mm3 / stock->initialVolume() - 1.0;
      EXPECT_LT(std::abs(off), radius < 2.0 ? 4e-3 : 1.5e-3) << radius << " case " << i;
    }
  }
}

/// Balls a few cells thick, at places that no grid favours: the volume is off by no more than it says, and
/// what it says vanishes with the grid.
TEST(StockVolume, TellsHowFarItIsOff) {
  Progress progress;
  for (const double grid : {1.0, 0.5, 0.1}) {
    for (int i = 0; i < 6; ++i) {
      const double radius = 1.3 + 0.21 * i, y = 0.37 * i, length = 30.0;
      Result<Stock> stock = make(BoxShape{{0, -10, -10}, {length, 10, 0}}, grid);
      ASSERT_TRUE(stock.ok());
      const StockVolume before = *stock->volume({}, progress);
      EXPECT_NEAR(before.error_mm3, 0.0, 1e-9);
      PathMaker path;
      path.line({-10, y, -0.8 * radius}, {length + 10, y, -0.8 * radius});
      RemovalOptions options;
      options.resolution_mm = grid;
      Tool ball = tool("1=ball:4");
      ball.diameter = 2.0 * radius;
      ASSERT_TRUE(stock->remove(path.path(), {ball}, options, progress).ok());
      const StockVolume after = *stock->volume({}, progress);
      const double removed = radius * radius * (std::acos(0.2) - 0.2 * std::sqrt(0.96)) * length;
      EXPECT_LT(std::abs(before.mm3 - after.mm3 - removed), after.error_mm3 + 2e-5 * removed)
          << grid << ' ' << i;
      EXPECT_LT(after.error_mm3, (grid > 0.2 ? 2e-2 : 2e-6) * removed) << grid << ' ' << i;
    }
  }
}

/// What passes between all columns of samples counts for the motion that did it.
TEST(StockVolume, CutsBetweenTheSamplesBelongToTheirMotion) {
  PathMaker path;
  path.line({-20, -20, 5}, {-10, -20, 5}).line({-20, 11.4, -8}, {40, 11.4, -8});
  const Cut c = cut(BoxShape{{0, 0, -10}, {20, 10, 0}}, path.path(), {tool("1=flat:3")}, 1.0);
  EXPECT_NEAR(c.initial - c.volume, 0.1 * 20 * 8, 0.15);
  ASSERT_EQ(c.summary.removed_mm3.size(), 2u);
  EXPECT_EQ(c.summary.removed_mm3[0], 0.0f);
  EXPECT_GT(c.summary.removed_mm3[1], 0.0f);
}

Cut bore(int turns, const std::string& option) {
  PathMaker path;
  path.arc({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 360.0 * turns, -20.0);
  return cut(BoxShape{{-20, -20, -25}, {20, 20, 0}}, path.path(), {tool(option)}, 0.5);
}

TEST(ManyTurns, CostAsMuchAsFew) {
  const Cut few = bore(4, "1=flat:8"), many = bore(400, "1=flat:8");
  EXPECT_LT(many.summary.voxel_evaluations, 2 * few.summary.voxel_evaluations);
  // The ring down to the last turn, whose floor rises by a pitch of 0.05 mm once around.
  const double area = kPi * (14.0 * 14.0 - 6.0 * 6.0);
  EXPECT_NEAR(many.initial - many.volume, area * (20.0 - 0.025), 0.5e-3 * area * 20.0);
}

/// The ball leaves its tracks in the wall only under the last turn.
TEST(ManyTurns, LeaveTheSameWallAsFew) {
  const Cut ball = bore(100, "1=ball:8");
  const double ring = kPi * (14.0 * 14.0 - 6.0 * 6.0) * 16.0, half = 2.0 * kPi * 10.0 * 0.5 * kPi * 16.0;
  EXPECT_NEAR(ball.initial - ball.volume, ring + half, 0.02 * (ring + half));
}

/// The distance to a helix of many turns is the least of those to its single turns.
TEST(ManyTurns, DistanceIsThatOfTheNearestTurn) {
  const int turns = 60;
  const double pitch = 0.4, radius = 7.0;
  const Tool cutter = tool("1=bull:5:1");
  const ToolSolid solid = makeToolSolid(cutter);
  const ConvexProfile& profile = solid.cutter.front();
  ArcGeometry arc;
  arc.center = {1, 2, 0};
  arc.normal = {0, 0, 1};
  const auto at = [&](double t) {
    return Vec3(1 + radius * std::cos(t), 2 + radius * std::sin(t), -pitch * t / (2 * kPi));
  };
  const auto sweep = [&](double a, double b) {
    ArcGeometry part = arc;
    part.sweep_rad = b - a;
    part.center.z() = at(a).z();
    return Sweep(profile, at(a), at(b), &part);
  };
  const Sweep whole = sweep(0.0, 2 * kPi * turns);
  std::vector<Sweep> quarters;
  for (int i = 0; i < 4 * turns; ++i) quarters.push_back(sweep(0.5 * kPi * i, 0.5 * kPi * (i + 1)));
  for (int i = 0; i < 400; ++i) {
    const double angle = 0.37 * i, r = radius + 3.5 * std::sin(1.7 * i);
    const Vec3 p(1 + r * std::cos(angle), 2 + r * std::sin(angle), 4.0 - 30.0 * std::fmod(0.618 * i, 1.0));
    double least = 1e300;
    for (const Sweep& quarter : quarters) least = std::min(least, quarter.distance(p, 1e300));
    EXPECT_NEAR(whole.distance(p, 1e300), least, 1e-6 + 2e-4 * std::abs(least)) << i;
  }
}

}  // namespace
}  // namespace proveout::test
