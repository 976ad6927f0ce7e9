// Steps lower than a cell: both edges of their walls are in the mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kStepGrid = 0.25;
constexpr double kOffEdge = 1e-3;  ///< mm

StockSurface surfaceOf(const Toolpath& path, const Tool& cutter, double simplify_mm, int threads = 1) {
  RemovalOptions options;
  options.resolution_mm = kStepGrid;
  options.threads = threads;
  Progress progress;
  Result<Stock> stock = Stock::create(BoxShape{{0.03, 0.08, -3.17}, {24.16, 18.12, 0.0}}, options, progress);
  EXPECT_TRUE(stock.ok());
  EXPECT_TRUE(stock->remove(path, {cutter}, options, progress).ok());
  SurfaceOptions how;
  how.simplify_mm = simplify_mm;
  Result<StockSurface> surface = stock->surface(how, progress);
  EXPECT_TRUE(surface.ok());
  EXPECT_TRUE(analyseTopology(surface->mesh).closedManifold());
  EXPECT_EQ(surface->self_intersections, 0u);
  return std::move(*surface);
}

/// Places on the edges of a slot: a point on its middle line, and where its wall is.
struct Beside {
  Vec3 middle, aside;  ///< on the floor; unit
};

/// The largest distance of the mesh from the edges of a slot at these places, above and below.
double edgesOff(const TriMesh& mesh, const std::vector<Beside>& places, double radius) {
  const TriangleTree tree(toSurface(mesh));
  double most = 0.0;
  for (const Beside& place : places) {
    for (const double z : {0.0, place.middle.z()}) {
      Vec3 p = place.middle + radius * place.aside;
      p.z() = z;
      most = std::max(most, std::sqrt(tree.nearest(p).squared));
    }
  }
  return most;
}

/// Both sides of a straight slot, a tool's radius off its ends.
std::vector<Beside> besideLine(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = (to - from).normalized(), aside = Vec3::UnitZ().cross(along);
  std::vector<Beside> out;
  for (double s = radius; s < (to - from).norm() - radius; s += 0.173)
    for (const double side : {-1.0, 1.0}) out.push_back({from + s * along, side * aside});
  return out;
}

const Tool kStepFlat = tool("1=flat:5");
constexpr double kSlotRadius = 2.5;

TEST(LowStep, StraightSlotsHaveBothEdges) {
  for (int i = 0; i < 12; ++i) {
    const double ahead = degToRad(-34.0 + 6.3 * i), depth = 0.02 + 0.019 * i;
    const Vec3 middle(12.1, 9.03, -depth), way(std::cos(ahead), std::sin(ahead), 0.0);
    const Vec3 from = middle - 8.0 * way, to = middle + 8.0 * way;
    PathMaker path;
    path.line(from + Vec3(0, 0, 5), from).line(from, to);
    const std::vector<Beside> places = besideLine(from, to, kSlotRadius);
    EXPECT_LT(edgesOff(surfaceOf(path.path(), kStepFlat, 0.0).mesh, places, kSlotRadius), kOffEdge) << i;
  }
}

TEST(LowStep, RoundSlotsHaveBothEdges) {
  for (int i = 0; i < 6; ++i) {
    const Vec3 center(12.05, 9.02, -0.04 - 0.035 * i), from = center + Vec3(5.1, 0, 0);
    PathMaker path;
    path.line(from + Vec3(0, 0, 5), from).arc(from, center, Vec3::UnitZ(), radToDeg(2.0 * kPi));
    std::vector<Beside> places;
    for (double at = 0.3; at < 6.0; at += 0.021) {
      const Vec3 out(std::cos(at), std::sin(at), 0.0);
      for (const double side : {-1.0, 1.0}) places.push_back({center + 5.1 * out, side * out});
    }
    // Chords of a cell's diagonal on the inner wall are off by 6 micrometres.
    const double chord = 2.0 * kStepGrid * kStepGrid / (8.0 * (5.1 - kSlotRadius));
    EXPECT_LT(edgesOff(surfaceOf(path.path(), kStepFlat, 0.0).mesh, places, kSlotRadius), chord + kOffEdge)
        << i;
  }
}

// The floor goes down along the slot, and the step from nothing to more than a cell.
TEST(LowStep, SlantedSlotsHaveTheirUpperEdges) {
  for (int i = 0; i < 6; ++i) {
    const double ahead = degToRad(7.0 + 11.0 * i);
    const Vec3 way(std::cos(ahead), std::sin(ahead), 0.0), middle(12.1, 9.03, -0.17);
    const Vec3 from = middle + 7.0 * way, to = middle - 7.0 * way - Vec3(0, 0, 0.11);
    PathMaker path;
    path.line(from + Vec3(0, 0, 5), from).line(from, to);
    const TriMesh mesh = surfaceOf(path.path(), kStepFlat, 0.0).mesh;
    const TriangleTree tree(toSurface(mesh));
    int far = 0, all = 0;
    for (Beside place : besideLine(from, to, kSlotRadius)) {
      Vec3 p = place.middle + kSlotRadius * Vec3(place.aside.x(), place.aside.y(), 0.0);
      p.z() = 0.0;
      far += std::sqrt(tree.nearest(p).squared) > 2 * kOffEdge ? 1 : 0;
      ++all;
    }
    EXPECT_LE(far, all / 10) << i;
  }
}

TEST(LowStep, WallsAreOfTheMotionThatMadeThem) {
  const Vec3 from(4.1, 9.03, -0.1), to(20.1, 10.33, -0.1);
  PathMaker path;
  path.line(from + Vec3(0, 0, 5), from).line(from, to);
  const TriMesh mesh = surfaceOf(path.path(), kStepFlat, 0.0).mesh;
  int walls = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.positions[v[0]].cast<double>(), b = mesh.positions[v[1]].cast<double>(),
               c = mesh.positions[v[2]].cast<double>();
    const Vec3 n = (b - a).cross(c - a).normalized();
    if (std::max({a.z(), b.z(), c.z()}) < -0.101 || std::min({a.z(), b.z(), c.z()}) < -0.101) continue;
    if (std::abs(n.z()) > 0.5 || std::abs(a.x() - 12.0) > 6.0) continue;
    EXPECT_EQ(mesh.motion[t], 1u);
    ++walls;
  }
  EXPECT_GE(walls, 180);
}

/// A comb of slots across others, some nearer to each other than the grid.
Toolpath crossedSlots() {
  PathMaker path;
  for (int i = 0; i < 9; ++i) {
    const double x = 2.3 + 2.4 * i + 0.08 * i * i, depth = 0.04 + 0.03 * (i % 5);
    path.line({x, 1.0, 5.0}, {x, 1.0, -depth}).line({x, 1.0, -depth}, {x + 1.7, 17.0, -depth});
    const double y = 1.4 + 1.9 * i;
    path.line({1.0, y, 5.0}, {1.0, y, -0.12}).line({1.0, y, -0.12}, {23.0, y + 0.6, -0.07});
  }
  return path.path();
}

TEST(LowStep, CrossedSlotsStaySoundOnAnyNumberOfThreads) {
  const Tool narrow = tool("1=flat:1.6");
  for (const double simplify : {0.0, 0.002, 0.025}) {
    const TriMesh one = surfaceOf(crossedSlots(), narrow, simplify, 1).mesh;
    const TriMesh four = surfaceOf(crossedSlots(), narrow, simplify, 4).mesh;
    EXPECT_EQ(one.positions, four.positions);
    EXPECT_EQ(one.triangles, four.triangles);
    EXPECT_EQ(one.motion, four.motion);
  }
}

TEST(LowStep, SimplifiedSlotsAreFewTriangles) {
  const Vec3 from(4.1, 9.03, -0.1), to(20.1, 10.33, -0.1);
  PathMaker path;
  path.line(from + Vec3(0, 0, 5), from).line(from, to);
  const TriMesh mesh = surfaceOf(path.path(), kStepFlat, 0.025).mesh;
  EXPECT_LT(mesh.triangles.size(), 600u);
  EXPECT_LT(edgesOff(mesh, besideLine(from, to, kSlotRadius), kSlotRadius), 0.025);
}

}  // namespace
}  // namespace proveout::test
