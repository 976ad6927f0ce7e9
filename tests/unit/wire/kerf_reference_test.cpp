// Random ways of a wire against a slow reference: the distance of points to all stretches
// (wedm-x-kerf; of leaning wires in lean_solid_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/base/thread_limit.h"
#include "removal/wire/section/prism_mesh.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

using test::arcWay;
using test::lineWay;

constexpr double kHalf = 20.0, kHole = 2.0;
const Vec2 kHoleAt(3, 3);
const std::vector<PlaneLoop> kPlate = {rectangleLoop({-kHalf, -kHalf}, {kHalf, kHalf}),
                                       circleLoop(kHoleAt, kHole, true)};

/// Above 0 in the material: the distance to the nearest surface.
double materialAt(const std::vector<WireStretch>& way, const Vec2& p) {
  double least = std::min(kHalf - p.cwiseAbs().maxCoeff(), (p - kHoleAt).norm() - kHole);
  for (const WireStretch& s : way) least = std::min(least, distanceTo(s, p).mm - s.kerf_mm);
  return least;
}

/// Lines and arcs that cross themselves in any way, closed, with gaps now and then.
std::vector<WireStretch> randomWay(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-15, 15), share(-1, 1);
  std::vector<WireStretch> way;
  Vec2 at(place(random), place(random));
  const Vec2 start = at;
  const double kerf = 0.05 + 0.5 * std::abs(share(random));
  const auto count = static_cast<MotionId>(3 + random() % 50);
  for (MotionId i = 0; i < count; ++i) {
    if (random() % 3 == 0) {
      const Vec2 center = at + 4.0 * Vec2(share(random), share(random));
      way.push_back(arcWay(at, center, 6.2 * share(random), kerf, i));
    } else if (random() % 4 == 0) {  // many short ones
      way.push_back(lineWay(at, at + 0.1 * Vec2(share(random), share(random)), kerf, i));
    } else {
      way.push_back(lineWay(at, {place(random), place(random)}, kerf, i));
    }
    at = random() % 10 == 0 ? Vec2(place(random), place(random)) : way.back().to;
  }
  way.push_back(lineWay(at, start, kerf, count));
  return way;
}

bool inBodies(const std::vector<std::vector<Vec2>>& polygons, const Vec2& p) {
  return std::count_if(polygons.begin(), polygons.end(),
                       [&](const auto& polygon) { return surrounds(polygon, p); }) %
             2 ==
         1;
}

class KerfReference : public testing::TestWithParam<unsigned> {};

TEST_P(KerfReference, PointsAndMesh) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  std::mt19937 random(GetParam());
  const std::vector<WireStretch> way = randomWay(random);
  const std::vector<PlaneBody> bodies = cutSection(kPlate, way);
  std::vector<std::vector<Vec2>> polygons;
  for (const PlaneBody& body : bodies) {
    for (const PlaneLoop& loop : body.loops) polygons.push_back(chordsOf(loop, 1e-5).points);
  }
  std::uniform_real_distribution<double> place(-21, 21);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p(place(random), place(random));
    const double material = materialAt(way, p);
    if (std::abs(material) > 3e-4) {
      ASSERT_EQ(inBodies(polygons, p), material > 0.0) << p;
    }
  }
  // Edges lie on the surface, and belong to who is nearest.
  for (const PlaneBody& body : bodies) {
    for (const PlaneLoop& loop : body.loops) {
      const ChordLoop chords = chordsOf(loop, 1e-5);
      for (const Vec2& p : chords.points) ASSERT_LT(std::abs(materialAt(way, p)), 1.2e-4) << p;
    }
  }
  const TriMesh mesh = prismMesh(bodies, 0.0, 10.0, 1e-3);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_NEAR(test::faceArea(mesh, 10.0F) * 10.0 / meshVolume(mesh), 1.0, 1e-5);
  EXPECT_NEAR(meshVolume(mesh) / (10.0 * test::totalArea(bodies)), 1.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, KerfReference, testing::Range(1u, 41u));

TEST(KerfReferenceThreads, SameForOneAndMany) {
  std::mt19937 random(7);
  const std::vector<WireStretch> way = randomWay(random);
  const TriMesh many = prismMesh(cutSection(kPlate, way), 0.0, 10.0, 1e-3);
  const ThreadLimit alone(1);
  const TriMesh one = prismMesh(cutSection(kPlate, way), 0.0, 10.0, 1e-3);
  EXPECT_EQ(one.triangles, many.triangles);
  EXPECT_EQ(one.motion, many.motion);
  EXPECT_TRUE(one.positions == many.positions);
}

/// A contour whose corners are rounded to micrometres, a few micrometres apart: offsets turn over themselves.
TEST(KerfReferenceDense, ShortRoughMotions) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 4000; ++i) {
    const double angle = 2 * kPi * i / 4000, r = 4.0 * (1 + 0.05 * std::sin(40 * angle));
    corners.emplace_back(std::round(1e3 * r * std::cos(angle)) / 1e3,
                         std::round(1e3 * r * std::sin(angle)) / 1e3);
  }
  std::vector<WireStretch> way;
  for (const WireStretch& s : test::closedWay(corners, 0.15)) {
    if (s.length() > 0.0) way.push_back(s);
  }
  const std::vector<PlaneLoop> plate = {rectangleLoop({-kHalf, -kHalf}, {kHalf, kHalf})};
  const std::vector<PlaneBody> bodies = cutSection(plate, way);
  ASSERT_EQ(bodies.size(), 2u);
  for (const PlaneBody& body : bodies) {
    for (const PlaneLoop& loop : body.loops) {
      for (std::size_t i = 0; i < loop.edges.size(); i += 7) {
        const Vec2& p = loop.edges[i].from;
        if (p.cwiseAbs().maxCoeff() > 10) continue;
        double off = std::numeric_limits<double>::infinity();
        for (const WireStretch& s : way) off = std::min(off, distanceTo(s, p).mm - s.kerf_mm);
        ASSERT_NEAR(off, 0.0, 1e-4) << p;
      }
    }
  }
}

}  // namespace
}  // namespace proveout
