// Few triangles of what is cut, near to the surface of all cells.
#include <Eigen/Geometry>
#include <random>

#include "core/base/thread_limit.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mesh_simplifier.h"
#include "tests/support/mesh_distance.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr int kPoints = 3;  ///< samples of a triangle

std::size_t meetings(const TriMesh& mesh) {
  return findIntersections(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1)).size();
}

TEST(LeanSurface, StraightSlotIsAFewTrianglesOnAnyGrid) {
  PathMaker path;
  path.line({-10, 25, -5}, {110, 25, -5});
  for (const double grid : {1.0, 0.5, 0.25}) {
    RemovalOptions options;
    options.resolution_mm = grid;
    Progress progress;
    Result<Stock> stock = Stock::create(BoxShape{{0, 0, -20}, {100, 50, 0}}, options, progress);
    ASSERT_TRUE(stock.ok());
    ASSERT_TRUE(stock->remove(path.path(), {tool("1=flat:10")}, options, progress).ok());
    const Result<StockSurface> surface = stock->surface(0, progress);
    ASSERT_TRUE(surface.ok());
    EXPECT_LE(surface->mesh.triangles.size(), 50u) << grid;
    EXPECT_NEAR(meshVolume(surface->mesh), 95000.0, 0.1) << grid;
    EXPECT_TRUE(analyseTopology(surface->mesh).closedManifold());
  }
}

// A tolerance below the height of the facets (0.004 mm here) must not keep every cell: the wall is straight
// along the axis. 62 facets around, two triangles each, and the rims.
TEST(LeanSurface, WallOfAHoleIsLongStripsBelowTheHeightOfItsFacets) {
  for (const char* name : {"1=flat:4", "1=drill:4:118"}) {
    SCOPED_TRACE(name);
    PathMaker path;
    path.line({10.07, 10.11, 2}, {10.07, 10.11, -15.03});
    RemovalOptions options;
    options.resolution_mm = 0.25;
    Progress progress;
    Result<Stock> stock = Stock::create(BoxShape{{0, 0, -20}, {20, 20, 0}}, options, progress);
    ASSERT_TRUE(stock.ok());
    ASSERT_TRUE(stock->remove(path.path(), {tool(name)}, options, progress).ok());
    const Result<StockSurface> surface = stock->surface({.simplify_mm = 0.002}, progress);
    ASSERT_TRUE(surface.ok());
    EXPECT_LE(surface->mesh.triangles.size(), 1300u);
    double farthest = 0.0;  // corners of the wall, and middles of their sides
    for (const auto& t : surface->mesh.triangles) {
      for (int i = 0; i < 3; ++i) {
        const Vec3 a = surface->mesh.positions[t[i]].cast<double>();
        const Vec3 b = surface->mesh.positions[t[(i + 1) % 3]].cast<double>();
        const auto off = [](const Vec3& p) { return std::abs((p - Vec3(10.07, 10.11, p.z())).norm() - 2.0); };
        if (a.z() > -13.0 && b.z() > -13.0 && off(a) < 0.01 && off(b) < 0.01)
          farthest = std::max({farthest, off(a), off(0.5 * (a + b))});
      }
    }
    EXPECT_GT(farthest, 0.0);
    EXPECT_LE(farthest, 0.25 * 0.25 / (8 * 2.0) + 0.002);
  }
}

/// Random lines and arcs of one tool in a block of 20 x 20 x 8.
Toolpath randomPath(std::mt19937& random) {
  std::uniform_real_distribution<double> place(1.0, 19.0), depth(-5.0, -0.3), turn(40.0, 350.0);
  PathMaker path;
  Vec3 at(place(random), place(random), depth(random));
  for (int i = 0; i < 8; ++i) {
    if (i % 3 == 2) {
      path.arc(at, at + Vec3(2.0, 1.0, 0.0), Vec3::UnitZ(), turn(random), -0.2);
    } else {
      const Vec3 to(place(random), place(random), depth(random));
      path.line(at, to);
      at = to;
    }
  }
  return path.path();
}

TEST(LeanSurface, RandomPathsStayWithinTheTolerance) {
  const std::vector<std::string> tools = {"1=flat:4", "1=ball:5", "1=bull:6:1", "1=cone:6:1:60"};
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const Toolpath path = randomPath(random);
    const TriMesh fine =
        cut(BoxShape{{0, 0, -8}, {20, 20, 0}}, path, {tool(tools[seed % tools.size()])}, 0.4).mesh;
    const bool clean = meetings(fine) == 0;
    for (const double tolerance : {0.005, 0.04}) {
      TriMesh first;
      for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        Progress progress;
        TriMesh lean = fine;
        const auto done = simplifyMesh(lean, tolerance, progress);
        ASSERT_TRUE(done.has_value());
        if (threads == 1) {
          first = lean;
          EXPECT_LE(done->distance_mm, tolerance * (1 + 1e-6));
          if (clean) {
            EXPECT_EQ(meetings(lean), 0u);
          }
        }
        EXPECT_TRUE(lean.positions == first.positions && lean.triangles == first.triangles &&
                    lean.motion == first.motion)
            << threads << " threads";
      }
      constexpr double kRounding = 1e-5;
      EXPECT_LE(farthest(fine, first, kPoints, random), tolerance + kRounding);
      EXPECT_LE(farthest(first, fine, kPoints, random), tolerance + kRounding);
      EXPECT_TRUE(analyseTopology(first).closedManifold());
      EXPECT_LT(first.triangles.size(), fine.triangles.size() / 3);
    }
  }
}

/// Lines in all directions over a block of 16 x 16 x 5, of which walls thinner than a cell are left.
Toolpath crowdedPath(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0.0, 16.0), depth(-3.0, -0.5);
  PathMaker path;
  Vec3 at(place(random), place(random), depth(random));
  for (int i = 0; i < 60; ++i) {
    const Vec3 to(place(random), place(random), depth(random));
    path.line(at, to);
    at = to;
  }
  return path.path();
}

StockSurface surfaceOf(const Stock& stock, double simplify_mm, int threads) {
  SurfaceOptions options;
  options.simplify_mm = simplify_mm;
  options.threads = threads;
  Progress progress;
  Result<StockSurface> surface = stock.surface(options, progress);
  EXPECT_TRUE(surface.ok());
  return surface.ok() ? std::move(*surface) : StockSurface();
}

/// Merging cells and simplifying the mesh, together.
TEST(LeanSurface, WholeWayStaysWithinTheToleranceBetweenThinWalls) {
  const std::vector<std::string> tools = {"1=flat:1", "1=ball:0.8", "1=bull:1.2:0.3", "1=cone:1:0.2:60"};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    RemovalOptions options;
    options.resolution_mm = 0.25;
    Progress progress;
    Result<Stock> stock = Stock::create(BoxShape{{0, 0, -5}, {16, 16, 0}}, options, progress);
    ASSERT_TRUE(stock.ok());
    ASSERT_TRUE(
        stock->remove(crowdedPath(random), {tool(tools[seed % tools.size()])}, options, progress).ok());
    const double tolerance = seed % 2 == 0 ? 0.025 : 0.008;
    const TriMesh all = surfaceOf(*stock, 0.0, 0).mesh;
    const StockSurface surface = surfaceOf(*stock, tolerance, 1);
    const TriMesh& lean = surface.mesh;
    EXPECT_TRUE(analyseTopology(lean).closedManifold());
    EXPECT_EQ(meetings(lean), surface.self_intersections);
    EXPECT_LE(farthest(all, lean, 1, random), tolerance);
    EXPECT_LE(farthest(lean, all, kPoints, random), tolerance);
    EXPECT_LT(lean.triangles.size(), all.triangles.size() * 3 / 4);
    for (const int threads : {2, 4}) {
      const TriMesh again = surfaceOf(*stock, tolerance, threads).mesh;
      EXPECT_TRUE(again.positions == lean.positions && again.triangles == lean.triangles &&
                  again.motion == lean.motion)
          << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace proveout::test
