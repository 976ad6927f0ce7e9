// Edges and points that the crossings of their cells do not show: the vertex is sought on the bodies.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mesh/triangle_tree.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.25;
constexpr double kOff = 1e-3;  ///< mm

/// The mesh of all cells.
TriMesh meshOf(const Toolpath& path, const Tool& cutter) {
  RemovalOptions options;
  options.resolution_mm = kGrid;
  options.threads = 1;
  Progress progress;
  Result<Stock> stock = Stock::create(BoxShape{{0.03, 0.08, -8.17}, {24.16, 18.12, 0.0}}, options, progress);
  EXPECT_TRUE(stock.ok());
  EXPECT_TRUE(stock->remove(path, {cutter}, options, progress).ok());
  SurfaceOptions all;
  all.simplify_mm = 0.0;
  Result<StockSurface> surface = stock->surface(all, progress);
  EXPECT_TRUE(surface.ok());
  return std::move(surface->mesh);
}

double nearest(const TriMesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& q : mesh.positions) least = std::min(least, (q.cast<double>() - p).norm());
  return least;
}

// Half of the point's cone belongs to the way down, the rest and the bottom of the groove to the way along.
TEST(EdgeEnds, GroovesOfAPointBeginAtIt) {
  const Tool drill = tool("1=drill:6.35:124");
  for (int i = 0; i < 12; ++i) {
    const Vec3 low(19.22 + 0.021 * i, 12.41 + 0.037 * i, -1.379 - 0.03 * i);
    const Vec3 end = low + Vec3(-5.9, 1.04 + 0.3 * i, 0.0);
    PathMaker path;
    path.line({low.x(), low.y(), 2.0}, low).line(low, end);
    const TriMesh mesh = meshOf(path.path(), drill);
    EXPECT_LT(nearest(mesh, low), kOff) << i;
    EXPECT_LT(nearest(mesh, end), kOff) << i;
  }
}

// An arc leaves a pillar, off which its start and end cut a part each: the ridge between is of one body.
TEST(EdgeEnds, RidgesOfOneArcAreFound) {
  const Tool flat = tool("1=flat:7.28");
  const double r = 0.5 * flat.diameter, radius = r + 0.63;
  for (int i = 0; i < 8; ++i) {
    const Vec3 center(12.02 + 0.03 * i, 9.01 + 0.04 * i, -3.0);
    const double turn = 4.9, half = 0.5 * (2.0 * kPi - turn);
    // The middle of the part that is not swept is at an angle of 0.
    const Vec3 from = center + radius * Vec3(std::cos(half), std::sin(half), 0.0);
    PathMaker path;
    path.line(from + Vec3(0, 0, 5.0), from).arc(from, center, Vec3::UnitZ(), radToDeg(turn));
    const double along = radius * std::cos(half), beside = radius * std::sin(half);
    const Vec3 ridge(center.x() + along - std::sqrt(r * r - beside * beside), center.y(), 0.0);
    std::vector<double> off(8, std::numeric_limits<double>::infinity());  // of the layers of cells
    for (const auto& q : meshOf(path.path(), flat).positions) {
      const Vec3 p = q.cast<double>();
      const double layer = (-0.4 - p.z()) / kGrid;
      if (layer < 0.0 || layer >= 8.0) continue;
      double& least = off[static_cast<std::size_t>(layer)];
      least = std::min(least, (p - ridge).head<2>().norm());
    }
    for (const double d : off) EXPECT_LT(d, kOff) << i;
  }
}

// Crossings below the rim are on the ball, the rim itself is on the cone above it.
TEST(EdgeEnds, RimsAreOfTheElementAboveTheirCrossings) {
  const Tool taper = tool("1=taper:2:20:8");
  const double r = 1.0, a = degToRad(20.0), joint = r * (1.0 - std::sin(a));
  for (int i = 1; i <= 6; ++i) {
    const double depth = joint + 0.02 * i;
    const double wide = (r + (depth - r) * std::sin(a)) / std::cos(a), y = 9.03 + 0.07 * i;
    PathMaker path;
    path.line({-6, y, -depth}, {30, y, -depth});
    int found = 0;
    for (const auto& q : meshOf(path.path(), taper).positions) {
      const double beside = std::abs(std::abs(q.y() - y) - wide);
      if (q.z() < -1e-6f || beside > 0.08 || q.x() < 0.1f || q.x() > 24.0f) continue;
      EXPECT_LT(beside, kOff) << i;
      ++found;
    }
    EXPECT_GE(found, 180) << i;
  }
}

// Below the rim the crossings of a cell may lie in one line along the groove: they show no bend across it.
TEST(EdgeEnds, RimsOfRoundCornersAreFoundFromOneLineOfCrossings) {
  const double radius = 2.4, corner = 0.92;
  const Tool bull = tool("1=bull:4.8:0.92");
  for (int i = 0; i < 8; ++i) {
    const double depth = 0.72 + 0.02 * i, ahead = degToRad(101.0 + i), up = corner - depth;
    const double wide = radius - corner + std::sqrt(corner * corner - up * up);
    const Vec3 middle(12.1, 9.03, -depth), way(std::cos(ahead), std::sin(ahead), 0.0);
    PathMaker path;
    path.line(middle - 20.0 * way, middle + 20.0 * way);
    int found = 0;
    for (const auto& q : meshOf(path.path(), bull).positions) {
      const Vec3 p = q.cast<double>() - middle;
      const double beside = std::abs(std::abs(way.x() * p.y() - way.y() * p.x()) - wide);
      if (q.z() < -1e-6f || beside > 0.08 || q.y() < 0.2f || q.y() > 18.0f) continue;
      EXPECT_LT(beside, 3e-3) << i << " at " << q.transpose();
      ++found;
    }
    EXPECT_GE(found, 120) << i;
  }
}

// Where a flat ridge between grooves goes into the next layer of cells, the cells beside it follow it there.
TEST(EdgeEnds, FlatRidgesAreFollowedOutOfTheirCells) {
  const Tool ball = tool("1=ball:3");
  const double r = 1.5, half = degToRad(2.0);
  const auto to = [](double angle) { return Vec3(std::cos(angle), std::sin(angle), 0.0); };
  for (int i = 0; i < 8; ++i) {
    const double ahead = degToRad(27.0 + 3.1 * i);
    const Vec3 start(2.1, 1.07 + 0.03 * i, -0.9 - 0.04 * i);
    PathMaker path;
    path.line(start - 9.0 * to(ahead - half), start + 30.0 * to(ahead - half));
    path.line(start - 9.0 * to(ahead + half), start + 30.0 * to(ahead + half));
    const TriangleTree mesh(toSurface(meshOf(path.path(), ball)));
    double most = 0.0;
    for (double s = 6.0; s < 14.0; s += 0.02) {
      const double beside = s * std::sin(half);
      const Vec3 ridge = start + s * to(ahead) + Vec3(0, 0, r - std::sqrt(r * r - beside * beside));
      most = std::max(most, std::sqrt(mesh.nearest(ridge).squared));
    }
    EXPECT_LT(most, kOff) << i;
  }
}

}  // namespace
}  // namespace proveout::test
