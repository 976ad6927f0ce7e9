#include "removal/turning/turned_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "tests/unit/removal/turned_parts.h"

namespace proveout {
namespace {

using test::body;
using test::Made;
using test::make;
using test::shapeOf;

/// The largest |distance(r, z)| of the mesh's vertices, mm.
double worst(const TriMesh& mesh, const std::function<double(double, double)>& distance) {
  double most = 0.0;
  for (const auto& p : mesh.positions)
    most = std::max(most, std::abs(distance(std::hypot(double{p.x()}, double{p.y()}), p.z())));
  return most;
}

void expectSolid(const std::shared_ptr<const TurnedShape>& shape, double volume,
                 const std::function<double(double, double)>& distance) {
  const Made made = make(shape, 0.2);
  EXPECT_LT(worst(made.surface.mesh, distance), 1e-3);
  EXPECT_NEAR(made.surface.volume_mm3, volume, 1e-5 * volume);
  EXPECT_NEAR(made.initial, volume, 1e-5 * volume);
}

TEST(TurnedField, Cylinder) {
  expectSolid(shapeOf({body({{0, -20}, {8, -20}, {8, 0}, {0, 0}})}), kPi * 64 * 20, [](double r, double z) {
    return std::max({r - 8, z, -20 - z});
  });
}

TEST(TurnedField, Cone) {
  const double lean = std::atan2(3.0, 15.0);
  expectSolid(shapeOf({body({{0, -15}, {8, -15}, {5, 0}, {0, 0}})}), kPi / 3 * 15 * (64 + 40 + 25),
              [&](double r, double z) {
                return std::max({(r - 5 + z * 3.0 / 15.0) * std::cos(lean), z, -15 - z});
              });
}

TEST(TurnedField, SphereEnd) {
  const double radius = 6.0;
  std::vector<Vec2> points{{0, -10}, {radius, -10}};
  const int steps = circleSteps(radius, kSectionChordMm) / 4;
  for (int i = 0; i <= steps; ++i) {
    const double a = 0.5 * kPi * i / steps;
    points.emplace_back(i == steps ? 0.0 : radius * std::cos(a), radius * std::sin(a));
  }
  SectionBody part = body(points, true);
  part.loops[0].motion[0] = part.loops[0].motion[1] = 1;
  expectSolid(shapeOf({part}), kPi * 36 * 10 + 2.0 / 3.0 * kPi * 216, [&](double r, double z) {
    return std::max(z > 0 ? std::hypot(r, z) - radius : r - radius, -10 - z);
  });
}

TEST(TurnedField, Groove) {
  expectSolid(
      shapeOf({body({{0, -20}, {8, -20}, {8, -12}, {5.3, -12}, {5.3, -9.1}, {8, -9.1}, {8, 0}, {0, 0}})}),
      kPi * (64 * 20 - (64 - 5.3 * 5.3) * 2.9), [](double r, double z) {
        const double groove = std::max({z + 9.1, -12 - z, 5.3 - r});
        return std::max({r - 8, z, -20 - z, -groove});
      });
}

TEST(TurnedField, TubeWithHollow) {
  SectionBody part = body({{3, -20}, {8, -20}, {8, 0}, {3, 0}});
  SectionLoop hollow;  // a ring of air inside the wall
  hollow.points = {{5, -12}, {5, -8}, {6.5, -8}, {6.5, -12}};
  hollow.motion = {kNoMotion, kNoMotion, kNoMotion, kNoMotion};
  part.loops.push_back(hollow);
  expectSolid(shapeOf({part}), kPi * ((64 - 9) * 20 - (6.5 * 6.5 - 25) * 4), [](double r, double z) {
    const double ring = std::max({5 - r, r - 6.5, -12 - z, z + 8});
    return std::max({r - 8, 3 - r, z, -20 - z, -ring});
  });
}

TEST(TurnedField, TwoBodies) {
  const auto shape =
      shapeOf({body({{0, -20}, {8, -20}, {8, -5}, {0, -5}}), body({{2, -3}, {6, -3}, {6, 0}, {2, 0}})});
  const Made made = make(shape, 0.2);
  const double exact = kPi * (64 * 15 + (36 - 4) * 3);
  EXPECT_NEAR(made.surface.volume_mm3, exact, 1e-5 * exact);
  EXPECT_NEAR(made.initial, exact, 1e-9 * exact);
}

TEST(TurnedField, FacesNameTheirMotions) {
  const Made made = make(shapeOf({body({{0, -20}, {8, -20}, {8, 0}, {0, 0}})}), 0.5);
  const TriMesh& mesh = made.surface.mesh;
  ASSERT_EQ(mesh.motion.size(), mesh.triangles.size());
  std::array<int, 3> seen{};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Vec3 middle = Vec3::Zero();
    for (const auto v : mesh.triangles[i]) middle += mesh.positions[v].cast<double>() / 3.0;
    if (middle.head<2>().norm() > 7.0 && middle.z() > -19.0 && middle.z() < -1.0) {
      EXPECT_EQ(mesh.motion[i], 1u);
      ++seen[1];
    } else if (middle.head<2>().norm() < 7.0) {
      EXPECT_EQ(mesh.motion[i], middle.z() > -10.0 ? 2u : 0u);
      ++seen[middle.z() > -10.0 ? 2 : 0];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(TurnedField, RefusesWhatIsNoPart) {
  Progress progress;
  const auto refused = [&](const std::shared_ptr<const TurnedShape>& shape) {
    const auto stock = Stock::create(turnedStock(shape), RemovalOptions{}, progress);
    return !stock.ok();
  };
  EXPECT_TRUE(refused(nullptr));
  EXPECT_TRUE(refused(shapeOf({})));
  EXPECT_TRUE(refused(shapeOf({body({{0, 0}, {5, 0}})})));
  EXPECT_TRUE(refused(shapeOf({body({{-1, -5}, {5, -5}, {5, 0}})})));
  EXPECT_TRUE(refused(shapeOf({body({{0, -5}, {5, -5}, {5, std::nan("")}})})));
  EXPECT_TRUE(refused(shapeOf({body({{0, -5}, {0, -3}, {0, 0}})})));
  EXPECT_TRUE(refused(shapeOf({body({{2, 0}, {2, 0}, {2, 0}})})));
  EXPECT_TRUE(refused(shapeOf({body({{0, 0}, {5, 0}, {5, -5}, {0, -5}})})));
  auto no_motion = shapeOf({body({{0, -5}, {5, -5}, {5, 0}})});
  no_motion->bodies[0].loops[0].motion.pop_back();
  EXPECT_TRUE(refused(no_motion));
  for (const auto& spoil : std::vector<std::function<void(ThreadSweep&)>>{
           [](ThreadSweep& s) { s.outline = nullptr; }, [](ThreadSweep& s) { s.turns = 0.0; },
           [](ThreadSweep& s) { s.turns = 1e9; }, [](ThreadSweep& s) { s.bend = 1.5; },
           [](ThreadSweep& s) { s.from.x() = std::nan(""); }}) {
    auto shape = shapeOf({body({{0, -5}, {5, -5}, {5, 0}, {0, 0}})});
    OutlineSide a, b, c;
    a.from = c.to = {0, 0};
    a.to = b.from = {1, -1};
    b.to = c.from = {1, 1};
    shape->outlines.push_back(std::make_shared<ConvexOutline>(std::vector<OutlineSide>{a, b, c}));
    ThreadSweep s;
    s.outline = shape->outlines[0].get();
    s.from = {4, 1};
    s.to = {4, -4};
    s.turns = -2;
    shape->threads.push_back(s);
    EXPECT_FALSE(refused(shape));
    spoil(shape->threads[0]);
    EXPECT_TRUE(refused(shape));
  }
}

}  // namespace
}  // namespace proveout
