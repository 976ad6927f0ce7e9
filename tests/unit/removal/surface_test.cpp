// The surface against closed forms, on grids that are not aligned with the features.
#include "removal/surface/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "core/base/thread_limit.h"
#include "core/mesh/intersections.h"
#include "core/mesh/tri_mesh.h"
#include "field_stock.h"

namespace proveout {
namespace {

using test::Field;

const Vec3 kShift(0.0764, 0.0828, 0.0894);

StockSurface extract(const Field& field, const Box3& bounds, double h = 0.2, const Vec3& origin = kShift,
                     double simplify = 0.0) {
  Stock::Impl impl;
  test::fillStock(impl, field, bounds, h, origin);
  Progress progress;
  auto surface = extractSurface(impl, SurfaceOptions{simplify, 0}, progress);
  EXPECT_TRUE(surface.ok()) << surface.error().message;
  const MeshTopology topology = analyseTopology(surface->mesh);
  EXPECT_TRUE(topology.closedManifold())
      << topology.boundary_edges << " " << topology.non_manifold_edges << " " << topology.misoriented_edges
      << " " << topology.non_manifold_vertices << " " << topology.degenerate_triangles << " at "
      << topology.first_defect.transpose();
  return *surface;
}

double worstVertex(const TriMesh& mesh, const Field& field) {
  double worst = 0.0;
  for (const auto& p : mesh.positions) worst = std::max(worst, std::abs(field(p.cast<double>()).value));
  return worst;
}

/// Farthest of points inside the triangles from the closed form.
double worstInside(const TriMesh& mesh, const Field& field) {
  double worst = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    for (const Vec3& p :
         {Vec3((a + b + c) / 3.0), Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a))}) {
      worst = std::max(worst, std::abs(field(p).value));
    }
  }
  return worst;
}

const Box3 kBounds{Vec3::Constant(-6), Vec3::Constant(6)};
const Vec3 kAxis = Vec3(1, 2, 3).normalized();
const Vec3 kMiddle(0.03, 0.05, -0.07);

struct Case {
  std::string name;
  Field field;
  double volume = 0.0;    ///< mm3
  double radius = 0.0;    ///< least radius of curvature, mm; 0: all flat
  double vertex = 0.002;  ///< largest distance of a vertex from the closed form, mm; 0.01 on curved edges
  double off = 1e-5;      ///< of the volume, at most
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Field tube() { return test::cylinder(kMiddle, kAxis, 3.0, 1); }
Field between(const Field& body, double low, double high) {
  return test::both(test::both(body, test::halfSpace(kAxis * high, kAxis, 90)),
                    test::halfSpace(kAxis * low, -kAxis, 91));
}

std::vector<Case> cases() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, kAxis).toRotationMatrix();
  return {
      {"sphere", test::sphere(kMiddle, 4.0, 1), 4.0 / 3.0 * kPi * 64.0, 4.0},
      {"torus", test::torus(kMiddle, kAxis, 3.5, 1.5, 1), 2 * kPi * kPi * 3.5 * 2.25, 1.5},
      {"box", test::box(Vec3(-2, -3, -1), Vec3(2, 3, 1.5), 1), 60.0},
      {"turned_box", test::box(Vec3(-2, -3, -1), Vec3(2, 3, 1.5), 1, turn), 60.0},
      {"cylinder", between(tube(), -2.0, 2.5), kPi * 9 * 4.5, 3.0, 0.01},
      {"countersink",
       test::without(test::box(Vec3(-4, -4, -2), Vec3(4, 4, 2), 1),
                     test::cone({0.03, 0.05, -0.9}, -Vec3::UnitZ(), degToRad(45.0), 10)),
       8 * 8 * 4 - kPi / 3.0 * std::pow(2.9, 3), 0.2, 0.01},
      {"pocket",
       test::without(test::box(Vec3(-4, -4, -2), Vec3(4, 4, 2), 1),
                     test::both(test::cylinder(kMiddle, Vec3::UnitZ(), 2.5, 10),
                                test::halfSpace(Vec3(0, 0, -0.9), -Vec3::UnitZ(), 11))),
       8 * 8 * 4 - kPi * 6.25 * 2.9, 2.5},
      {"ball_slot",
       test::without(test::box(Vec3(-4, -4, -2), Vec3(4, 4, 2), 1),
                     test::cylinder({0, 0.1, 1.7}, Vec3::UnitX(), 2.0, 10)),
       8 * 8 * 4 - 8 * (kPi * 2.0 + 2 * (0.5 * 0.3 * std::sqrt(4 - 0.09) + 2.0 * std::asin(0.15))), 2.0,
       0.002, 1.1e-5},  // vertices on rims that hang over are as far off as crossings show
      {"thin_wall",
       test::without(test::box(Vec3(-4, -4, -2), Vec3(4, 4, 2), 1),
                     test::without(test::box(Vec3(-3, -3, -1), Vec3(3, 3, 5), 10),
                                   test::box(Vec3(-3, 0.02, -1), Vec3(3, 0.13, 5), 20))),
       8 * 8 * 4 - 6 * (6 - 0.11) * 3},
  };
}

class SurfaceOf : public testing::TestWithParam<Case> {};

TEST_P(SurfaceOf, IsOnTheClosedForm) {
  const Case& c = GetParam();
  const StockSurface s = extract(c.field, kBounds);
  const double bow = c.radius > 0.0 ? 0.04 / (8.0 * c.radius) : 0.0;
  EXPECT_LT(worstVertex(s.mesh, c.field), c.vertex);
  // Surfaces that bend both ways are off twice as much along the diagonals of their quads.
  EXPECT_LT(worstInside(s.mesh, c.field), 0.002 + 2.0 * bow);
  EXPECT_NEAR(s.volume_mm3 / c.volume, 1.0, c.off);
}

TEST_P(SurfaceOf, StaysWithinTheToleranceWhenSimplified) {
  const Case& c = GetParam();
  const StockSurface fine = extract(c.field, kBounds);
  for (const double tolerance : {0.002, 0.02, 0.1}) {
    const StockSurface s = extract(c.field, kBounds, 0.2, kShift, tolerance);
    EXPECT_LE(worstVertex(s.mesh, c.field), worstVertex(fine.mesh, c.field));
    EXPECT_LE(worstInside(s.mesh, c.field), worstInside(fine.mesh, c.field) + tolerance);
    EXPECT_EQ(s.volume_mm3, fine.volume_mm3);
    EXPECT_LT(s.mesh.triangles.size(), fine.mesh.triangles.size());
  }
}

TEST(Surface, DoesNotDependOnTheNumberOfThreads) {
  Stock::Impl impl;
  test::fillStock(impl, cases().back().field, kBounds, 0.2, kShift);
  StockSurface first;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    Progress progress;
    const auto s = extractSurface(impl, SurfaceOptions{0.02, 0}, progress);
    ASSERT_TRUE(s.ok());
    if (threads == 1) first = *s;
    EXPECT_EQ(s->mesh.positions, first.mesh.positions);
    EXPECT_EQ(s->mesh.triangles, first.mesh.triangles);
    EXPECT_EQ(s->mesh.motion, first.mesh.motion);
    EXPECT_EQ(s->volume_mm3, first.volume_mm3);
  }
}

TEST(Surface, SharpRimOfAConeStaysClosed) {
  // The rim is a wedge of 60 degrees, thinner than a cell at its edge: cells hold two sheets, and their
  // vertices do not all reach the edge.
  const double half = degToRad(30.0);
  const Field field =
      test::both(test::cone(kAxis * 3.0, kAxis, half, 1), test::halfSpace(kAxis * -2.0, -kAxis, 2));
  const StockSurface s = extract(field, kBounds);
  EXPECT_GT(s.thin_cells, 0u);
  EXPECT_LT(worstVertex(s.mesh, field), 0.1);
  EXPECT_NEAR(s.volume_mm3 / (kPi / 3.0 * std::pow(5.0 * std::tan(half), 2) * 5.0), 1.0, 5e-4);
  double tip = 1.0;
  for (const auto& p : s.mesh.positions) tip = std::min(tip, (p.cast<double>() - kAxis * 3.0).norm());
  EXPECT_LT(tip, 0.002);
}

std::vector<std::array<std::uint32_t, 2>> meetings(const TriMesh& mesh) {
  return findIntersections(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1));
}

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

TEST(Intersections, TellTrianglesThatMeetFromThoseThatTouchOrPass) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0},       {4, 0, 0},   {0, 4, 0},        // 0
                    {1, 1, -1},      {1, 1, 1},   {5, 5, 1},        // 1: an edge through 0
                    {1, 1, 2},       {2, 1, 3},   {1, 2, 3},        // 2: above
                    {3.5f, 3.5f, 0}, {9, 3, 0},   {3, 9, 0},        // 3: beside 0 in its plane
                    {1, 2, 0},       {-3, 2, 0},  {-3, 3, 0},       // 4: over 0 in its plane
                    {7, -2, -2},     {7, -1, -2}, {7, -1.5f, -2}};  // 5: no area
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}, {12, 13, 14}, {15, 16, 17}};
  EXPECT_EQ(meetings(mesh), (Pairs{{0, 1}, {0, 4}, {5, 5}}));
}

TEST(Intersections, NeighboursMeetOnlyWhereTheyFold) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}, {0.5f, 0.5f, 0}, {1, 1, -1}, {1, 0.5f, 1}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_TRUE(meetings(mesh).empty());
  mesh.triangles = {{0, 1, 2}, {2, 1, 4}};  // over an edge, onto the other
  EXPECT_EQ(meetings(mesh), (Pairs{{0, 1}}));
  mesh.triangles = {{0, 1, 2}, {0, 5, 6}};  // through it from the common corner
  EXPECT_EQ(meetings(mesh), (Pairs{{0, 1}}));
  mesh.triangles = {{0, 1, 2}, {0, 3, 6}};  // above it
  EXPECT_TRUE(meetings(mesh).empty());
}

TEST(Intersections, OnlyThoseOfSuspectsAreLookedFor) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {5, 5, 1}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_TRUE(findIntersections(mesh, std::vector<std::uint8_t>(6, 0)).empty());
  EXPECT_EQ(findIntersections(mesh, std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1}), (Pairs{{0, 1}}));
  EXPECT_TRUE(findIntersectionsOf(mesh, std::vector<std::uint8_t>(2, 0)).empty());
  EXPECT_EQ(findIntersectionsOf(mesh, std::vector<std::uint8_t>{0, 1}), (Pairs{{0, 1}}));
}

TEST(Intersections, FindWhatComparingAllPairsFinds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> at(0.0f, 10.0f), size(-1.0f, 1.0f);
  TriMesh mesh;
  std::vector<std::uint8_t> suspect;
  for (std::uint32_t t = 0; t < 700; ++t) {
    const float reach = t % 50 == 0 ? 8.0f : 0.7f;  // some go through many others
    const Eigen::Vector3f middle(at(random), at(random), at(random));
    for (int i = 0; i < 3; ++i) {
      mesh.positions.push_back(middle + reach * Eigen::Vector3f(size(random), size(random), size(random)));
      suspect.push_back(t % 3 == 0);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    if (t % 7 == 0 && t > 0) mesh.triangles.back()[0] = 3 * t - 1;  // shares a corner
  }
  Pairs expected;
  for (std::uint32_t s = 0; s < 700; ++s) {
    for (std::uint32_t t = s + 1; t < 700; ++t) {
      const auto asked = [&](std::uint32_t n) {
        const auto& v = mesh.triangles[n];
        return suspect[v[0]] + suspect[v[1]] + suspect[v[2]] > 0;
      };
      if ((asked(s) || asked(t)) && trianglesMeet(mesh, s, t)) expected.push_back({s, t});
    }
  }
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(findIntersections(mesh, suspect), expected);
}

TEST_P(SurfaceOf, NeverRunsThroughItself) {
  for (const double tolerance : {0.0, 0.02, 0.1}) {
    const StockSurface s = extract(GetParam().field, kBounds, 0.2, kShift, tolerance);
    EXPECT_EQ(s.self_intersections, 0u) << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, SurfaceOf, testing::ValuesIn(cases()),
                         [](const auto& shape) { return shape.param.name; });

}  // namespace
}  // namespace proveout
