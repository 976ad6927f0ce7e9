// Wires that run into fixtures, against distances in closed form.
#include "removal/wire/contact/wire_fixture.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/tri_mesh.h"
#include "removal/wire/falls/fixture_solid.h"
#include "removal/wire/section/ruled_way.h"

namespace proveout {
namespace {

Tool wireTool(double diameter) {
  Tool wire;
  wire.number = 1;
  wire.type = ToolType::kWire;
  wire.diameter = diameter;
  wire.spark_gap = 1.0;  // is not met by fixtures
  return wire;
}

WireSweep upright(const Vec2& from, const Vec2& to) {
  WireSweep sweep;
  sweep.z_high = 20;
  sweep.lower = {from, to, Vec2::Zero(), 0.0};
  sweep.upper = sweep.lower;
  return sweep;
}

std::vector<Contact> touches(const StockShape& shape, const std::vector<WireSweep>& ways,
                             MotionKind kind = MotionKind::kFeed, double diameter = 0.2) {
  Toolpath path;
  ToolpathBuilder builder(path);
  for (const WireSweep& way : ways) {
    Motion motion;
    motion.kind = kind;
    builder.wireMotion(motion, way);
  }
  const SurfaceMesh solid = solidOf(shape);
  Progress progress;
  return WireFixture(solid).touches(path, {wireTool(diameter)}, progress);
}

TEST(FixtureSolid, IsClosedAndNeverTooSmall) {
  for (const StockShape& shape :
       {StockShape(BoxShape{{1, 2, 3}, {4, 6, 8}}), StockShape(CylinderShape{0, {1, 2, 3}, 5, 0, 10}),
        StockShape(CylinderShape{1, {1, 2, 3}, 5, 3, 10}),
        StockShape(CylinderShape{2, {1, 2, 3}, 5, 3, 10})}) {
    const SurfaceMesh solid = solidOf(shape);
    TriMesh mesh;
    for (const Vec3& p : solid.points) mesh.positions.push_back(p.cast<float>());
    mesh.triangles = solid.triangles;
    EXPECT_TRUE(analyseTopology(mesh).closedManifold());
    const auto* tube = std::get_if<CylinderShape>(&shape);
    const double volume =
        tube != nullptr ? kPi * 10 * (25 - tube->inner_radius * tube->inner_radius) : 3.0 * 4 * 5;
    EXPECT_GE(meshVolume(mesh), volume * (1 - 1e-6));
    EXPECT_LE(meshVolume(mesh), volume * 1.001);
    const Box3 box = shapeBounds(shape);
    for (const Vec3& p : solid.points) EXPECT_TRUE((box.inflated(2e-3).overlaps({p, p})));
  }
}

TEST(WireFixture, TouchesByItsRadiusWithoutSparks) {
  // A clamp above the workpiece, its side at X5.
  const BoxShape clamp{{5, -10, 20}, {15, 10, 30}};
  EXPECT_TRUE(touches(clamp, {upright({0, 0}, {4.895, 0})}).empty());
  const std::vector<Contact> found = touches(clamp, {upright({0, 0}, {4.95, 0}), upright({4.95, 0}, {0, 0})});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, ContactKind::kWire);
  EXPECT_EQ(found[0].motion, 0u);
  EXPECT_NEAR(found[0].depth_mm, 0.05, 1e-3);
  EXPECT_EQ(touches(clamp, {upright({0, 0}, {4.95, 0})}, MotionKind::kRapid).size(), 1u);
  // Below the lower plane, too.
  EXPECT_EQ(touches(BoxShape{{5, -10, -30}, {15, 10, -20}}, {upright({0, 0}, {8, 0})}).size(), 1u);
}

TEST(WireFixture, CrossesThinThings) {
  const CylinderShape pin{2, {10, 0, 20}, 0.05, 0, 5};
  const std::vector<Contact> through = touches(pin, {upright({-100, 0.14}, {100, 0.14})});
  ASSERT_EQ(through.size(), 1u);
  EXPECT_NEAR(through[0].depth_mm, 0.01, 2e-3);
  EXPECT_TRUE(touches(pin, {upright({-100, 0.152}, {100, 0.152})}).empty());
  // All around it, and through it on an arc.
  WireSweep arc = upright({30, 0}, {30, 0});
  arc.lower.center = Vec2(10, 0);
  arc.lower.sweep_rad = 2 * kPi;
  arc.upper = arc.lower;
  EXPECT_TRUE(touches(pin, {arc}).empty());
  arc.lower = {{30, 0}, {30, 0}, Vec2(20, 0.1), 0.0};
  arc.lower.center = Vec2(20, 0);
  arc.lower.sweep_rad = -2 * kPi;
  arc.upper = arc.lower;
  EXPECT_EQ(touches(pin, {arc}).size(), 1u);
}

TEST(WireFixture, DepthAndVolumeOfACutThroughAClamp) {
  const std::vector<Contact> found =
      touches(BoxShape{{5, -10, 20}, {15, 10, 30}}, {upright({0, 0}, {20, 0})});
  ASSERT_EQ(found.size(), 1u);
  // In its middle it is 5 mm to each of four faces.
  EXPECT_NEAR(found[0].depth_mm, 5.1, 0.5);
  EXPECT_NEAR(found[0].volume_mm3, 10 * 10 * 0.2, 1.5);
  EXPECT_NEAR(found[0].where.x(), 10, 0.6);
}

TEST(WireFixture, LeaningWiresMeetWhatUprightOnesDoNot) {
  const BoxShape clamp{{5, -10, 20}, {15, 10, 30}};
  WireSweep lean = upright({0, 0}, {0, 5});
  EXPECT_TRUE(touches(clamp, {lean}).empty());
  lean.upper.from = lean.upper.from + Vec2(4, 0);
  lean.upper.to = lean.upper.to + Vec2(4, 0);
  // At Z30 the wire is at X6.
  EXPECT_EQ(touches(clamp, {lean}).size(), 1u);
  EXPECT_TRUE(touches(BoxShape{{5, -10, 20}, {15, 10, 24}}, {lean}).empty());
}

TEST(WireFixture, UnthreadedWiresTouchNothing) {
  WireSweep cut = upright({0, 0}, {20, 0});
  cut.state.threaded = false;
  EXPECT_TRUE(touches(BoxShape{{5, -10, 20}, {15, 10, 30}}, {cut}).empty());
}

/// Random ways, upright and leaning, against a ball-like check of many points of the wire.
TEST(WireFixture, AgreesWithManyPointsOfTheWire) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-12.0, 12.0), turn(-3.0, 3.0);
  const BoxShape box{{-2, -3, 5}, {3, 2, 9}};
  const auto distanceToBox = [&](const Vec3& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).norm();
  };
  int met = 0;
  for (int k = 0; k < 200; ++k) {
    WireSweep sweep = upright({place(random), place(random)}, {place(random), place(random)});
    if (k % 2 == 1) {
      sweep.upper.from += Vec2(turn(random), turn(random));
      sweep.upper.to += Vec2(turn(random), turn(random));
    }
    if (k % 3 == 0) {
      for (WireTrack* track : {&sweep.lower, &sweep.upper}) {
        track->center = Vec2(place(random), place(random));
        track->sweep_rad = turn(random);
      }
    }
    const RuledWay way(sweep);
    double least = 1e9;
    for (int i = 0; i <= 400; ++i) {
      for (int j = 0; j <= 60; ++j)
        least = std::min(least, distanceToBox(way.at(i / 400.0, 4.5 + 5.0 * j / 60)));
    }
    const bool touched = !touches(box, {sweep}, MotionKind::kFeed, 2.0).empty();
    met += touched ? 1 : 0;
    EXPECT_TRUE(touched || least >= 1.0) << "case " << k << ", " << least;
    EXPECT_TRUE(!touched || least < 1.2) << "case " << k << ", " << least;
  }
  EXPECT_GT(met, 20);
  EXPECT_LT(met, 180);
}

}  // namespace
}  // namespace proveout
