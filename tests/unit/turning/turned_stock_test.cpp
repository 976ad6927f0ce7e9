// Turned closed forms, contacts and a slow reference.
#include "removal/turning/turned_stock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "removal/turning/section/revolve.h"
#include "removal/turning/section/sweep_paths.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

constexpr double kMicron = 1e-3;

struct Turned {
  TurnedShape shape;
  RemovalSummary summary;
  double initial_mm3 = 0.0;
};

Turned turn(const CylinderShape& blank, const TurningPath& path, const std::vector<Tool>& tools) {
  Progress progress;
  Result<TurnedStock> stock = TurnedStock::create(blank);
  EXPECT_TRUE(stock);
  Result<RemovalSummary> summary = stock->remove(path.path, tools, progress);
  EXPECT_TRUE(summary) << (summary ? "" : summary.error().message);
  return {stock->shape(), std::move(*summary), stock->initialVolume()};
}

double sum(const std::vector<float>& values) {
  double total = 0.0;
  for (const float v : values) total += static_cast<double>(v);
  return total;
}

/// Largest distance of the border's points between two heights from a curve r(z).
double worst(const SectionBody& body, double low, double high, const std::function<double(double)>& radius) {
  double most = -1.0;
  for (const Vec2& p : body.loops.front().points) {
    if (p.y() < low || p.y() > high || p.x() == 0.0) continue;
    most = std::max(most, std::abs(p.x() - radius(p.y())));
  }
  return most;
}

TEST(TurnedStock, CylinderAndShoulder) {
  TurningPath path({40, 5});
  path.rapid(25, 2).feed(25, -60).feed(31, -60).rapid(40, 5);
  const Turned t = turn(bar(30, 100), path, {insertTool(1, turningInsert(0.4))});
  ASSERT_EQ(t.shape.bodies.size(), 1u);
  // The nose leaves its radius in the corner: what of the square of 0.4 lies outside of the circle.
  const double r = 0.4, outside = (1 - kPi / 4) * r * r, centroid = (10 - 3 * kPi) / (12 - 3 * kPi) * r;
  const double corner = 2 * kPi * (25 + centroid) * outside;
  // The leading edge leans back by 3 degrees, but the way out makes the shoulder square.
  const double volume = kPi * (25.0 * 25 * 60 + 30.0 * 30 * 40) + corner;
  EXPECT_NEAR(t.shape.bodies[0].volume_mm3 / volume, 1.0, 1e-7);
  EXPECT_LT(worst(t.shape.bodies[0], -59, -1, [](double) { return 25.0; }), 1e-6);
  EXPECT_NEAR(sum(t.summary.removed_mm3) / (t.initial_mm3 - volume), 1.0, 1e-6);
  EXPECT_TRUE(t.summary.contacts.empty());
  // Who made what: the cylinder is the second motion's, the shoulder the third's.
  const SectionLoop& border = t.shape.bodies[0].loops.front();
  for (std::size_t i = 0; i < border.points.size(); ++i) {
    const Vec2 middle = 0.5 * (border.points[i] + border.points[(i + 1) % border.points.size()]);
    const bool cylinder = std::abs(middle.x() - 25.0)<1e-6, wall = middle.x()> 29.99;
    const bool shoulder = std::abs(middle.y() + 60.0) < 1e-6 && middle.x() > 26;
    EXPECT_TRUE(!cylinder || border.motion[i] == 1u);
    EXPECT_TRUE(!shoulder || border.motion[i] == 2u);
    EXPECT_TRUE(!wall || border.motion[i] == kNoMotion);
  }
}

TEST(TurnedStock, ConeByCompensatedPath) {
  // Cone from radius 15 at z 0 to 25 at z -40, the nose centre off it by its radius.
  const double nose = 0.8, angle = std::atan2(10.0, 40.0);
  const Vec2 normal(std::cos(angle), std::sin(angle)), tip(-nose, -nose);
  const Vec2 a = Vec2(15, 0) + nose * normal + tip - 5 * Vec2(-std::sin(angle), std::cos(angle)) * -1.0;
  const Vec2 b = Vec2(25, -40) + nose * normal + tip + 20 * Vec2(std::sin(angle), -std::cos(angle));
  TurningPath path({40, 20});
  path.rapid(a.x(), a.y()).feed(b.x(), b.y()).rapid(50, 20);
  const Turned t = turn(bar(30, 100), path, {insertTool(1, turningInsert(nose))});
  ASSERT_EQ(t.shape.bodies.size(), 1u);
  const auto cone = [](double z) { return 15.0 - z * 0.25; };
  EXPECT_LT(worst(t.shape.bodies[0], -59, 0.0, cone), 1e-5);
}

TEST(TurnedStock, SphereEnd) {
  const double nose = 0.4;
  TurningPath path({60, 5});
  // Roughing keeps off the sphere of radius 20 about z -20.
  for (double r = 20; r > 0.0; r -= 2.0) {
    path.rapid(r, 2).feed(r, std::sqrt(std::max(0.0, 441.0 - r * r)) - 21.0).rapid(r + 2, 2);
  }
  path.rapid(-nose, 2).feed(-nose, 0.0);
  path.arc(20.0, -20.0 - nose, Vec2(-nose, -20.0 - nose), -kPi / 2).feed(20, -40);
  const Turned t = turn(bar(22, 60), path, {insertTool(1, turningInsert(nose))});
  ASSERT_GE(t.shape.bodies.size(), 1u);
  double most = 0.0;
  for (const Vec2& p : t.shape.bodies[0].loops.front().points) {
    if (p.y() > -20.0 && p.x() > 0.0) most = std::max(most, std::abs(std::hypot(p.x(), p.y() + 20.0) - 20.0));
  }
  EXPECT_LT(most, 0.01 * kMicron);
}

TEST(TurnedStock, GrooveHasItsWidthDepthAndVolume) {
  TurningPath path({40, -20});
  path.rapid(31, -20).feed(24, -20).rapid(40, -20);
  const Turned t = turn(bar(30, 60), path, {insertTool(1, grooveInsert(4.0, 0.2))});
  const double r = 0.2, outside = (1 - kPi / 4) * r * r, centroid = (10 - 3 * kPi) / (12 - 3 * kPi) * r;
  const double corners = 2 * 2 * kPi * (24 + centroid) * outside;
  const double volume = kPi * 900 * 60 - kPi * (900 - 576) * 4.0 + corners;
  EXPECT_NEAR(t.shape.bodies[0].volume_mm3 / volume, 1.0, 1e-7);
  EXPECT_TRUE(t.summary.contacts.empty());
}

TEST(TurnedStock, TubeByDrillAndBoringBar) {
  Tool drill;
  drill.number = 2;
  drill.type = ToolType::kDrill;
  drill.diameter = 10.0;
  drill.point_angle_deg = 118.0;
  TurningPath path({0, 5});
  path.tool(2).rapid(0, 2).feed(0, -70).rapid(0, 5);
  path.tool(1).rapid(8, 2).feed(8, -40).feed(7, -40).rapid(7, 5);
  Insert boring = turningInsert(0.4, 2);
  boring.edge_length = 4.0;
  const Turned t = turn(bar(30, 60), path, {insertTool(1, boring), drill});
  EXPECT_TRUE(t.summary.contacts.empty());
  ASSERT_EQ(t.shape.bodies.size(), 1u);
  const double r = 0.4, outside = (1 - kPi / 4) * r * r, centroid = (10 - 3 * kPi) / (12 - 3 * kPi) * r;
  // Towards the axis the leading edge leans back by 3 degrees: a hollow cone at the bottom of the bore.
  double lowest = 0.0;
  for (const Vec2& p : t.shape.bodies[0].loops.front().points) {
    if (p.x() > 7.5 && p.x() < 8.1) lowest = std::min(lowest, p.y());
  }
  EXPECT_NEAR(lowest, -40.0, 1e-6);
  EXPECT_LT(worst(t.shape.bodies[0], -59.5, -41, [](double) { return 5.0; }), 25.0 + 1e-6);
  const double lean = std::tan(degToRad(3.0));
  const double least = kPi * (900.0 * 60 - 64.0 * 40 - 25.0 * 20);
  const double corner = 2 * kPi * (8 - centroid) * outside;
  const double step = 2 * kPi * 6.5 * 0.5 * 3.0 * 3.0 * lean;  // about the triangle that leaning leaves
  EXPECT_GT(t.shape.bodies[0].volume_mm3, least);
  EXPECT_LT(t.shape.bodies[0].volume_mm3, least + corner + 1.1 * step);
}

TEST(TurnedStock, PartingLeavesTwoBodies) {
  TurningPath path({40, -50});
  path.rapid(31, -50).feed(-0.1, -50).rapid(40, -50).rapid(40, -30).rapid(29, -30);
  const Turned t = turn(bar(30, 100), path, {insertTool(1, grooveInsert(3.0, 0.0))});
  ASSERT_EQ(t.shape.bodies.size(), 2u);
  EXPECT_EQ(t.shape.bodies[0].parted_by, kNoMotion);
  EXPECT_EQ(t.shape.bodies[1].parted_by, 1u);
  EXPECT_NEAR(t.shape.bodies[0].volume_mm3, kPi * 900 * 50, 1e-3);
  EXPECT_NEAR(t.shape.bodies[1].volume_mm3, kPi * 900 * 47, 1e-3);
  // The piece is gone when the tool comes to where it was.
  EXPECT_TRUE(t.summary.contacts.empty());
}

TEST(TurnedStock, RapidIntoThePartIsAContact) {
  TurningPath path({40, 5});
  path.rapid(28, 2).rapid(28, -10).rapid(40, 5);
  const Turned t = turn(bar(30, 60), path, {insertTool(1, turningInsert(0.4))});
  ASSERT_EQ(t.summary.contacts.size(), 1u);
  EXPECT_EQ(t.summary.contacts[0].kind, ContactKind::kRapid);
  EXPECT_EQ(t.summary.contacts[0].motion, 1u);
  EXPECT_NEAR(t.summary.contacts[0].depth_mm, 2.0, 0.02);
  EXPECT_NEAR(t.summary.contacts[0].volume_mm3 / (kPi * (900 - 784) * 10), 1.0, 0.05);
}

TEST(TurnedStock, ContactsAreAsDeepAsTheirDeepestPoint) {
  // A corner of 10 mm is cut off at 45 degrees: it was so far above the cut.
  TurningPath corner({40, 10});
  corner.rapid(18, 2).rapid(32, -12).rapid(40, -12);
  const Turned cut = turn(bar(30, 60), corner, {insertTool(1, turningInsert(0.0))});
  ASSERT_FALSE(cut.summary.contacts.empty());
  EXPECT_EQ(cut.summary.contacts[0].motion, 1u);
  EXPECT_NEAR(cut.summary.contacts[0].depth_mm, 10.0 / std::sqrt(2.0), 1e-3);
  EXPECT_LT((cut.summary.contacts[0].where - Vec3(30, 0, 0)).norm(), 0.05);
  // A wall of 3 mm, through which a wider blade goes, has lost 5 mm of its height.
  TurningPath wall({40, -10});
  wall.rapid(30.5, -10).feed(20, -10).rapid(40, -10).rapid(40, -17).feed(20, -17).rapid(40, -17);
  wall.rapid(40, -14).rapid(25, -14).rapid(40, -14);
  const Turned thin = turn(bar(30, 60), wall, {insertTool(1, grooveInsert(4.0, 0.0))});
  ASSERT_EQ(thin.summary.contacts.size(), 1u);
  EXPECT_NEAR(thin.summary.contacts[0].depth_mm, 5.0, 1e-3);
}

TEST(TurnedStock, ADrillIsAsDeepAsItsTip) {
  TurningPath path({0, 10});
  path.rapid(0, -3.0).rapid(0, 10);
  Tool drill;
  drill.number = 1;
  drill.type = ToolType::kDrill;
  drill.diameter = 12;
  const Turned t = turn(bar(30, 60), path, {drill});
  ASSERT_EQ(t.summary.contacts.size(), 1u);
  EXPECT_NEAR(t.summary.contacts[0].depth_mm, 3.0, 1e-4);
}

TEST(TurnedStock, StandingSpindleIsAContact) {
  TurningPath path({40, 5});
  path.spindle(0).rapid(28, 2).feed(28, -10).spindle(500).feed(28, -20);
  const Turned t = turn(bar(30, 60), path, {insertTool(1, turningInsert(0.4))});
  ASSERT_EQ(t.summary.contacts.size(), 1u);
  EXPECT_EQ(t.summary.contacts[0].kind, ContactKind::kSpindleOff);
  EXPECT_EQ(t.summary.contacts[0].motion, 1u);
}

/// Goes down a slope of `degrees` behind a cylinder of 28 mm.
Turned downhill(double degrees) {
  TurningPath path({40, 5});
  const double depth = 6.0, along = depth / std::tan(degToRad(degrees));
  path.rapid(28, 2).feed(28, -20).feed(28 - depth, -20 - along).feed(28 - depth, -40).feed(31, -40);
  return turn(bar(30, 60), path, {insertTool(1, turningInsert(0.4))});
}

TEST(TurnedStock, TrailingEdgeMustStayClear) {
  // The trailing edge lies 180 - 93 - 55 = 32 degrees off the direction of feed.
  EXPECT_TRUE(downhill(30.0).summary.contacts.empty());
  const Turned steep = downhill(45.0);
  ASSERT_EQ(steep.summary.contacts.size(), 1u);
  EXPECT_EQ(steep.summary.contacts[0].kind, ContactKind::kInsertBack);
  EXPECT_EQ(steep.summary.contacts[0].motion, 2u);
  EXPECT_GT(steep.summary.contacts[0].depth_mm, 0.2);
}

/// Contacts of a blade of 3 x 5 that goes in to a radius, in steps.
std::vector<Contact> plunge(double radius, double step, double relief_deg = 0.0) {
  Insert blade;
  blade.shape = InsertShape::kGroove;
  blade.width = 3.0;
  blade.nose_radius = 0.1;
  blade.edge_length = 5.0;
  blade.side_relief_deg = relief_deg;
  blade.orientation = 3;
  TurningPath path({40, -20});
  path.rapid(31, -20);
  for (double r = 30.0 - step; r > radius - 1e-9; r -= step) path.feed(r, -20).rapid(31, -20);
  return turn(bar(30, 60), path, {insertTool(1, blade)}).summary.contacts;
}

TEST(TurnedStock, ABladeGoesInNoDeeperThanItsEdge) {
  EXPECT_TRUE(plunge(25.01, 4.99).empty());
  EXPECT_TRUE(plunge(25.1, 0.7, 2.0).empty());
  for (const double step : {8.0, 1.0}) {
    const std::vector<Contact> deep = plunge(22.0, step, 2.0);
    ASSERT_FALSE(deep.empty());
    for (const Contact& contact : deep) EXPECT_EQ(contact.kind, ContactKind::kInsertBack);
    EXPECT_GT(deep.back().depth_mm, 0.01);
  }
}

TEST(TurnedStock, AToothInsideAShoulderIsAContact) {
  Insert tooth;
  tooth.shape = InsertShape::kThread;
  tooth.insert_angle_deg = 60.0;
  tooth.tip_flat = 0.1;
  tooth.edge_length = 1.8;
  tooth.orientation = 8;
  const auto contacts = [&](double end) {
    TurningPath path({40, 5});
    path.tool(2).rapid(31, 2).tool(1).feed(10, 2).feed(10, -20).feed(31, -20).rapid(31, 8);
    path.tool(2).rapid(8.5, 8).thread(8.5, end, (8 - end) / 2.5).rapid(31, end);
    std::vector<Contact> all =
        turn(bar(20, 60), path, {insertTool(1, turningInsert(0.4)), insertTool(2, tooth)}).summary.contacts;
    std::erase_if(all, [](const Contact& c) { return c.kind != ContactKind::kInsertBack || c.motion != 6; });
    return all;
  };
  EXPECT_TRUE(contacts(-18.0).empty());
  ASSERT_EQ(contacts(-30.0).size(), 1u);
  EXPECT_GT(contacts(-30.0)[0].depth_mm, 0.01);
}

TEST(TurnedStock, FacingPastTheAxisIsFineCuttingBeyondIsNot) {
  TurningPath face({40, 5});
  face.rapid(31, -1).feed(-0.8, -1).rapid(-0.8, 5);
  EXPECT_TRUE(turn(bar(30, 60), face, {insertTool(1, turningInsert(0.4))}).summary.contacts.empty());
  TurningPath beyond({40, 5});
  beyond.rapid(-5, 5).feed(-5, -3);
  const Turned t = turn(bar(30, 60), beyond, {insertTool(1, turningInsert(0.4))});
  bool crossed = false;
  for (const Contact& contact : t.summary.contacts) crossed |= contact.kind == ContactKind::kAxis;
  EXPECT_TRUE(crossed);
}

TEST(TurnedStock, HolderContact) {
  Insert insert = turningInsert(0.4);
  insert.holder = {{6.0, 0.5}, {60.0, 0.5}, {60.0, 20.0}, {6.0, 20.0}};
  TurningPath path({100, 5});
  // Cuts a face 10 mm deep: the holder begins 6 mm above the tip.
  path.rapid(31, -2).feed(20, -2).feed(20, 2);
  EXPECT_TRUE(turn(bar(30, 60), path, {insertTool(1, insert)}).summary.contacts.empty());
  insert.holder[0].y() = insert.holder[1].y() = -1.0;
  TurningPath shoulder({100, 5});
  shoulder.rapid(20, 2).feed(20, -5);
  const Turned t = turn(bar(30, 60), shoulder, {insertTool(1, insert)});
  bool holder = false;
  for (const Contact& contact : t.summary.contacts) holder |= contact.kind == ContactKind::kHolder;
  EXPECT_TRUE(holder);
}

TEST(TurnedStock, WhatCannotBeTurnedIsRefused) {
  Progress progress;
  EXPECT_FALSE(TurnedStock::create(BoxShape{Vec3(0, 0, 0), Vec3(1, 1, 1)}));
  CylinderShape lying = bar(10, 20);
  lying.axis = 0;
  EXPECT_FALSE(TurnedStock::create(lying));
  TurningPath path({40, 5});
  path.rapid(28, 2);
  path.path.motions.back().to.y() = 3.0;
  Result<TurnedStock> stock = TurnedStock::create(bar(30, 60));
  ASSERT_TRUE(stock);
  const auto cut = stock->remove(path.path, {insertTool(1, turningInsert(0.4))}, progress);
  ASSERT_FALSE(cut);
  EXPECT_NE(cut.error().message.find("test:1"), std::string::npos) << cut.error().message;
}

TEST(TurnedStock, MeshIsClosedAndHasTheVolume) {
  TurningPath path({40, 5});
  path.rapid(25, 2).feed(25, -30).feed(28, -40).feed(31, -40).rapid(40, -20);
  path.tool(2).rapid(31, -20).feed(20, -20).rapid(40, -20);
  const Turned t =
      turn(bar(30, 60), path, {insertTool(1, turningInsert(0.4)), insertTool(2, grooveInsert(3, 0.2))});
  for (const double tolerance : {1e-3, 1e-2}) {
    const TriMesh mesh = revolved(t.shape.bodies, tolerance);
    EXPECT_TRUE(analyseTopology(mesh).closedManifold());
    const double volume = meshVolume(mesh), exact = t.shape.bodies[0].volume_mm3;
    EXPECT_LT(volume, exact);
    EXPECT_GT(volume, exact * (1.0 - 2.0 * tolerance / 20.0));
    EXPECT_EQ(mesh.motion.size(), mesh.triangles.size());
  }
}

TEST(TurnedStock, ClampedTheOtherWayRound) {
  Progress progress;
  TurningPath front({40, 5});
  front.rapid(20, 2).feed(20, -20).feed(31, -20).rapid(40, 5);
  const Tool tool = insertTool(1, turningInsert(0.0));
  Result<TurnedStock> stock = TurnedStock::create(bar(30, 60));
  ASSERT_TRUE(stock && stock->remove(front.path, {tool}, progress));
  RigidTransform over{rotationAbout(Vec3::UnitX(), 180.0), Vec3(0, 0, -60)};
  Result<TurnedStock> turned = stock->moved(stock->shape().bodies.front(), over);
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->initialVolume(), kPi * (900 * 40 + 400 * 20), 1e-3);
  TurningPath back({40, 5});
  back.rapid(25, 2).feed(25, -10).feed(31, -10);
  ASSERT_TRUE(turned->remove(back.path, {tool}, progress));
  const SectionBody body = turned->shape().bodies.front();
  EXPECT_NEAR(body.volume_mm3, kPi * (900 * 30 + 400 * 20 + 625 * 10), 1e-3);
  // The thin end lies at the chuck now.
  EXPECT_LT(worst(body, -60, -41, [](double) { return 20.0; }), 1e-6);
  over.translation.x() = 1.0;
  EXPECT_FALSE(stock->moved(stock->shape().bodies.front(), over));
  over = {rotationAbout(Vec3::UnitX(), 90.0), Vec3::Zero()};
  EXPECT_FALSE(stock->moved(stock->shape().bodies.front(), over));
}

TEST(TurnedStock, FixturesAreNotTouched) {
  Progress progress;
  CylinderShape chuck = bar(60, 20, 30);
  chuck.base.z() = -60;
  const Result<TurnedStock> jaws = TurnedStock::create(chuck);
  ASSERT_TRUE(jaws);
  TurningPath path({70, 5});
  path.rapid(31, 2).feed(31, -39).feed(31, -41).rapid(70, -41);
  const auto touches = jaws->touches(path.path, {insertTool(1, turningInsert(0.4))}, progress);
  ASSERT_TRUE(touches);
  ASSERT_EQ(touches->size(), 2u);
  EXPECT_EQ((*touches)[0].kind, ContactKind::kFixture);
  EXPECT_EQ((*touches)[0].motion, 2u);
  EXPECT_NEAR((*touches)[0].depth_mm, 1.0, 0.05);
}

TEST(TurnedStock, FirstContactOfAMeasuringMove) {
  const Result<TurnedStock> stock = TurnedStock::create(bar(30, 60));
  ASSERT_TRUE(stock);
  Tool ball;
  ball.number = 1;
  ball.type = ToolType::kBall;
  ball.diameter = 4.0;
  Motion move;
  move.tool = 1;
  move.from = Vec3(0, 0, 10);
  move.to = Vec3(0, 0, -10);
  const auto face = stock->firstContact(move, nullptr, ball);
  ASSERT_TRUE(face);
  EXPECT_NEAR(*face, 0.5, 1e-6);
  // Obliquely onto the cylinder: centre of the ball 2 above its tip, 32 off the axis when it touches.
  move.from = Vec3(40, 0, -10);
  move.to = Vec3(30, 0, -20);
  const auto side = stock->firstContact(move, nullptr, ball);
  ASSERT_TRUE(side);
  EXPECT_NEAR(40.0 - 10.0 * *side, 32.0, 1e-4);
  move.to = Vec3(40, 0, -20);
  EXPECT_FALSE(stock->firstContact(move, nullptr, ball));
}

/// How deep in the outline a point comes on the way, by small steps; above 0: never.
double deepest(const ConvexOutline& outline, const PlaneWay& way, const Vec2& p) {
  double least = 1e9;
  for (int i = 0; i <= 400; ++i) least = std::min(least, outline.sample(p - way.at(i / 400.0)).value);
  return least;
}

bool inside(const SectionBody& body, const Vec2& p) {
  bool odd = false;
  for (const SectionLoop& loop : body.loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec2 &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
      if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
      odd ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    }
  }
  return odd;
}

TEST(TurnedStock, RandomProgramsAgreeWithSmallSteps) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int asked = 0, gone = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Insert insert = trial % 3 == 0 ? grooveInsert(3.0, 0.3) : turningInsert(trial % 3 == 1 ? 0.8 : 0.0);
    TurningPath path({35, 0});
    std::vector<PlaneWay> ways;
    Vec2 at(35, 0);
    for (int i = 0; i < 10; ++i) {
      PlaneWay way;
      way.from = at;
      const Vec2 to(20 + 12 * any(random), -45 + 40 * any(random));
      if (i % 2 == 0) {
        path.feed(to.x(), to.y());
        way.to = to;
      } else {  // a quarter turn
        const Vec2 half = 0.5 * (to - at);
        way.arc = true;
        way.center = at + half + Vec2(-half.y(), half.x());
        way.sweep_rad = 0.5 * kPi;
        way.to = to;
        path.arc(to.x(), to.y(), way.center, way.sweep_rad);
      }
      at = to;
      ways.push_back(way);
    }
    const Turned t = turn(bar(30, 60), path, {insertTool(1, insert)});
    if (t.shape.bodies.size() != 1) continue;  // what fell off is not cut any more
    EXPECT_NEAR(sum(t.summary.removed_mm3), t.initial_mm3 - t.shape.bodies[0].volume_mm3, 0.1);
    const ConvexOutline outline = insertOutline(insert);
    for (int i = 0; i < 80; ++i) {
      const Vec2 p(12 + 17.9 * any(random), -59.9 + 59.8 * any(random));
      double least = 1e9;
      for (const PlaneWay& way : ways) least = std::min(least, deepest(outline, way, p));
      if (std::abs(least) < 0.02) continue;  // steps of this size cannot tell
      ++asked;
      gone += least < 0.0;
      EXPECT_EQ(inside(t.shape.bodies[0], p), least > 0.0) << "trial " << trial << " at " << p.transpose();
    }
  }
  EXPECT_GT(asked, 400);
  EXPECT_GT(gone, 50);
}

bool holds(const std::vector<SectionPath>& paths, const Vec2& p) {
  int winding = 0;
  for (const SectionPath& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vec2 a = path[i] - p, b = path[(i + 1) % path.size()] - p;
      if ((a.y() <= 0.0) == (b.y() <= 0.0)) continue;
      const double side = a.x() * b.y() - a.y() * b.x();
      if (b.y() > a.y() && side > 0.0) ++winding;
      if (b.y() < a.y() && side < 0.0) --winding;
    }
  }
  return winding != 0;
}

TEST(SweptPaths, AgreeWithSmallSteps) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const std::vector<Insert> inserts = {turningInsert(0.4), turningInsert(0.0), turningInsert(1.2, 2),
                                       grooveInsert(3.0, 0.3)};
  int asked = 0, taken = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ConvexOutline outline = insertOutline(inserts[static_cast<std::size_t>(trial) % inserts.size()]);
    PlaneWay way;
    way.from = Vec2(10 * any(random), 10 * any(random));
    if (trial % 3 == 0) {
      way.to = way.from + Vec2(6 * any(random), 6 * any(random));
    } else {
      way.arc = true;
      way.center = way.from + Vec2(5 * any(random), 5 * any(random));
      way.sweep_rad = 5.5 * any(random);
      const Vec2 arm = way.from - way.center;
      const double c = std::cos(way.sweep_rad), s = std::sin(way.sweep_rad);
      way.to = way.center + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
    }
    const std::vector<SectionPath> paths = sweptPaths(outline, way);
    const double length =
        way.arc ? std::abs(way.sweep_rad) * (way.from - way.center).norm() : (way.to - way.from).norm();
    for (int i = 0; i < 60; ++i) {
      const Vec2 p = way.at(0.5 + 0.5 * any(random)) + Vec2(9 * any(random), 9 * any(random));
      const double least = deepest(outline, way, p);
      if (std::abs(least) < length * length * 1e-4 + 2e-3) continue;  // too near for steps of this size
      ++asked;
      taken += least < 0.0;
      EXPECT_EQ(holds(paths, p), least < 0.0) << "trial " << trial << " at " << p.transpose();
    }
  }
  EXPECT_GT(asked, 1500);
  EXPECT_GT(taken, 500);
}

}  // namespace
}  // namespace proveout
