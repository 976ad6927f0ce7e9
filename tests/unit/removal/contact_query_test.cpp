#include "removal/contact/contact_query.h"

#include <gtest/gtest.h>

#include <cmath>

#include "removal/sweep/convex_cast.h"

namespace proveout {
namespace {

Tool toolOf(int number, ToolType type, double diameter) {
  Tool tool;
  tool.number = number;
  tool.type = type;
  tool.diameter = diameter;
  return tool;
}

constexpr double kProbe = 6.0;  ///< diameter of the ball of tool 9

std::vector<Tool> tools() {
  return {toolOf(1, ToolType::kFlat, 8.0), toolOf(2, ToolType::kBall, 10.0),
          toolOf(9, ToolType::kBall, kProbe)};
}

class Path {
 public:
  Path& line(int tool, const Vec3& from, const Vec3& to) {
    Motion m;
    m.kind = MotionKind::kFeed;
    m.spindle = 1000;
    m.tool = tool;
    m.from = from;
    m.to = to;
    path.motions.push_back(m);
    return *this;
  }
  Path& circle(int tool, const Vec3& center, double radius) {
    const Vec3 at = center + Vec3(radius, 0, 0);
    line(tool, at, at);
    path.motions.back().arc = static_cast<std::int32_t>(path.arcs.size());
    path.arcs.push_back({center, Vec3::UnitZ(), 2 * kPi});
    return *this;
  }
  Toolpath path;
};

ContactQuery queryOf(const StockShape& shape, const Toolpath& path, double resolution, int threads = 0) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = resolution;
  options.threads = threads;
  Result<Stock> stock = Stock::create(shape, options, progress);
  EXPECT_TRUE(stock.ok());
  EXPECT_TRUE(stock->remove(path, tools(), options, progress).ok());
  SurfaceOptions surface_options;
  surface_options.simplify_mm = ContactQuery::kMeshMm;
  surface_options.threads = threads;
  Result<StockSurface> surface = stock->surface(surface_options, progress);
  EXPECT_TRUE(surface.ok());
  return ContactQuery(std::move(*surface), path, tools(), &shape, resolution);
}

/// Where the tip stands at the contact; NaN where there is none.
Vec3 contact(const ContactQuery& query, const Tool& tool, const Vec3& from, const Vec3& to) {
  const auto t = query.firstContact(tool, from, to);
  return t ? Vec3(from + *t * (to - from)) : Vec3::Constant(std::nan(""));
}

constexpr double kMicron = 1e-3;
const Tool kBall = toolOf(9, ToolType::kBall, kProbe);
const StockShape kBlock = BoxShape{{0, 0, -20}, {40, 30, 0}};

TEST(ContactQuery, FacesAndEdgesOfABlock) {
  const Path none;
  const ContactQuery query = queryOf(kBlock, none.path, 0.7);
  EXPECT_NEAR(contact(query, kBall, {-10, 13, -11}, {10, 13, -11}).x(), -3.0, 1e-5);
  EXPECT_NEAR(contact(query, kBall, {11, 13, 9}, {11, 13, -5}).z(), 0.0, 1e-5);
  // Slanted, onto the top; the flat tool with its rim on the edge X0.
  const Vec3 slanted = contact(query, kBall, {5, 5, 10}, {25, 15, -10});
  EXPECT_NEAR(slanted.z(), 0.0, 1e-5);
  EXPECT_NEAR(slanted.x(), 15.0, 1e-5);
  EXPECT_NEAR(contact(query, toolOf(1, ToolType::kFlat, 8), {-10, 13, -1}, {10, 13, 1}).x(), -4.0, 1e-5);
  // The ball's centre at height 2 meets the edge between X0 and the top: sqrt(9 - 4) before it.
  EXPECT_NEAR(contact(query, kBall, {-10, 13, -1}, {10, 13, -1}).x(), -std::sqrt(9.0 - 4.0), 1e-4);
  EXPECT_FALSE(query.firstContact(kBall, {-10, 13, 0.001}, {50, 13, 0.001}).has_value());
  EXPECT_FALSE(query.firstContact(kBall, {-10, 13, -5}, {-3.0001, 13, -5}).has_value());
}

TEST(ContactQuery, CloserThanTheChordsOfTheGridOnRoundWalls) {
  // A round pocket of radius 14 around a boss of radius 6 in a block.
  const Path milled = Path().circle(1, {20, 15, -5}, 10);
  constexpr double kGrid = 1.0;  // chords of this grid are off by 9 and 21 micrometres
  const ContactQuery query = queryOf(BoxShape{{0, -5, -20}, {40, 35, 0}}, milled.path, kGrid);
  const Vec3 center(20, 15, 0);
  for (const double degrees : {3.0, 37.0, 118.0, 200.5, 301.0}) {
    const Vec3 out(std::cos(degToRad(degrees)), std::sin(degToRad(degrees)), 0);
    const Vec3 aside(-out.y(), out.x(), 0);
    const Vec3 start = center + 10 * out + Vec3(0, 0, -4);
    const Vec3 wall = contact(query, kBall, start, start + 8 * out + 2 * aside);
    EXPECT_NEAR((wall - center).head<2>().norm(), 14.0 - 3.0, kMicron) << degrees;
    const Vec3 boss = contact(query, kBall, start, start - 8 * out + 2 * aside);
    EXPECT_NEAR((boss - center).head<2>().norm(), 6.0 + 3.0, kMicron) << degrees;
    EXPECT_NEAR(contact(query, kBall, start, start - Vec3(0, 0, 5)).z(), -5.0, 1e-5);
  }
}

TEST(ContactQuery, GroovesOfBallEnds) {
  // The groove is half a cylinder of radius 5 about y = 15, z = 0.
  const Path milled = Path().line(2, {-10, 15, -5}, {50, 15, -5});
  const ContactQuery query = queryOf(kBlock, milled.path, 0.8);
  for (const double y : {0.0, 0.3, 1.7}) {
    const Vec3 tip = contact(query, kBall, {20, 15 + y, 2}, {20, 15 + y, -9});
    EXPECT_NEAR(tip.z(), -std::sqrt(4.0 - y * y) - 3.0, kMicron) << y;  // the centres are 5 - 3 apart
  }
}

TEST(ContactQuery, TheRoundOfABlank) {
  const StockShape bar = CylinderShape{2, {0, 0, -20}, 12.0, 0.0, 20.0};
  const Path none;
  const ContactQuery query = queryOf(bar, none.path, 1.0);
  for (const double y : {0.0, 3.3, 9.7}) {
    EXPECT_NEAR(contact(query, kBall, {30, y, -8}, {0, y, -8}).x(), std::sqrt(225.0 - y * y), kMicron) << y;
  }
}

TEST(ContactQuery, OnItsOwnWayAToolTouchesWhereItHasNotCut) {
  const Tool flat = toolOf(1, ToolType::kFlat, 8.0), ball = toolOf(2, ToolType::kBall, 10.0);
  const Path hole = Path().line(1, {20, 15, 30}, {20, 15, -5});
  const ContactQuery in_hole = queryOf(kBlock, hole.path, 1.0);
  EXPECT_NEAR(contact(in_hole, flat, {20, 15, 5}, {20, 15, -8}).z(), -5.0, 1e-5);
  EXPECT_NEAR(contact(in_hole, flat, {20, 15, -3}, {20, 15, -8}).z(), -5.0, 1e-5);
  EXPECT_FALSE(in_hole.firstContact(flat, {20, 15, -3}, {20, 15, 8}).has_value());
  EXPECT_NEAR(contact(in_hole, flat, {21, 15, 5}, {21, 15, -8}).z(), 0.0, 1e-5);
  const Path groove = Path().line(2, {-10, 15, -4}, {25, 15, -4});
  const ContactQuery in_groove = queryOf(kBlock, groove.path, 0.8);
  EXPECT_NEAR(contact(in_groove, ball, {-10, 15, -4}, {40, 15, -4}).x(), 25.0, kMicron);
  EXPECT_NEAR(contact(in_groove, ball, {20, 15, -4}, {20, 15, -6}).z(), -4.0, kMicron);
  EXPECT_NEAR(contact(in_groove, ball, {20, 15, 6}, {20, 15, -6}).z(), -4.0, kMicron);
}

TEST(ContactQuery, TheAnswerDoesNotDependOnThreads) {
  const Path milled = Path().circle(1, {20, 15, -5}, 10);
  const ContactQuery one = queryOf(kBlock, milled.path, 0.5, 1), three = queryOf(kBlock, milled.path, 0.5, 3);
  const Vec3 from(29, 17, -4), to(40, 21, -4);
  ASSERT_TRUE(one.firstContact(kBall, from, to).has_value());
  EXPECT_EQ(*one.firstContact(kBall, from, to), *three.firstContact(kBall, from, to));
}

TEST(ConvexCast, BallsAgainstClosedForms) {
  const ToolSolid solid = makeToolSolid(toolOf(9, ToolType::kBall, 2.0));
  const ConvexProfile& ball = solid.cutter.front();
  const Triangle flat{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  EXPECT_NEAR(*castAgainst(ball, {2, 2, 10}, {2, 2, -10}, flat), 0.5, 1e-8);
  EXPECT_NEAR(*castAgainst(ball, {2, 2, 10}, {2, 2, -10}, flat, 0.5), 0.475, 1e-8);
  // Beside a corner: the centre is 1 from it at a height of sqrt(1 - 0.5).
  EXPECT_NEAR(10 - 20 * *castAgainst(ball, {-0.5, -0.5, 10}, {-0.5, -0.5, -10}, flat), std::sqrt(0.5) - 1.0,
              1e-7);
  EXPECT_FALSE(castAgainst(ball, {-1, -1, 10}, {-1, -1, -10}, flat).has_value());
  EXPECT_FALSE(castAgainst(ball, {2, 2, 10}, {2, 2, 0.001}, flat).has_value());
  EXPECT_EQ(*castAgainst(ball, {2, 2, -0.5}, {2, 2, 10}, flat), 0.0);
}

TEST(ConvexCast, FurthestPointsAreThoseOfTheProfile) {
  Tool bull = toolOf(1, ToolType::kBull, 10);
  bull.corner_radius = 2;
  const ToolSolid solid = makeToolSolid(bull);
  const ConvexProfile& profile = solid.cutter.front();
  for (int k = 0; k < 200; ++k) {
    const Vec3 d(std::cos(0.7 * k), std::sin(0.7 * k), std::cos(1.3 * k));
    const Vec3 p = furthestPoint(profile, d);
    EXPECT_NEAR(profile.sample(p.head<2>().norm(), p.z()).value, 0.0, 1e-9);
    // Nothing of the solid lies beyond the plane through it.
    for (int i = 0; i < 200; ++i) {
      const double r = 5.0 * (i % 20) / 19.0, z = 6.0 * (i / 20) / 9.0;
      if (profile.sample(r, z).value > 0.0) continue;
      EXPECT_LE(r * d.head<2>().norm() + z * d.z(), p.dot(d) + 1e-9);
    }
  }
}

}  // namespace
}  // namespace proveout
