// The surface against closed forms, on grids that are not aligned with the features.
#include "removal/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/mesh/tri_mesh.h"
#include "field_stock.h"

namespace proveout {
namespace {

using test::Field;

const Vec3 kShift(0.0764, 0.0828, 0.0894);

StockSurface extract(const Field& field, const Box3& bounds, double h = 0.2, const Vec3& origin = kShift) {
  Stock::Impl impl;
  test::fillStock(impl, field, bounds, h, origin);
  Progress progress;
  auto surface = extractSurface(impl, progress);
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

const Box3 kBounds{Vec3::Constant(-6), Vec3::Constant(6)};

TEST(Surface, SphereVolumeAndVertices) {
  const Field field = test::sphere({0.03, 0.05, -0.07}, 4.0, 1);
  const StockSurface s = extract(field, kBounds);
  EXPECT_LT(worstVertex(s.mesh, field), 0.002);
  const double volume = 4.0 / 3.0 * kPi * 64.0;
  EXPECT_NEAR(s.volume_mm3 / volume, 1.0, 1e-5);
}

TEST(Surface, RotatedBoxIsExact) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Field field = test::box(Vec3(-2, -3, -1), Vec3(2, 3, 1.5), 1, turn);
  const StockSurface s = extract(field, kBounds);
  EXPECT_LT(worstVertex(s.mesh, field), 0.03);
  EXPECT_NEAR(s.volume_mm3 / 60.0, 1.0, 1e-4);
  EXPECT_NEAR(meshVolume(s.mesh) / 60.0, 1.0, 5e-4);
}

TEST(Surface, Torus) {
  const Field field = test::torus({0.03, 0.05, -0.07}, {1, 2, 3}, 3.5, 1.5, 1);
  const StockSurface s = extract(field, kBounds);
  EXPECT_LT(worstVertex(s.mesh, field), 0.002);
  EXPECT_NEAR(s.volume_mm3 / (2 * kPi * kPi * 3.5 * 2.25), 1.0, 1e-5);
}

TEST(Surface, CylinderWithFlatEnds) {
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  const Field field = test::both(
      test::both(test::cylinder({0.03, 0.05, -0.07}, axis, 3.0, 1), test::halfSpace(axis * 2.5, axis, 2)),
      test::halfSpace(axis * -2.0, -axis, 3));
  const StockSurface s = extract(field, kBounds);
  EXPECT_LT(worstVertex(s.mesh, field), 0.05);
  EXPECT_NEAR(s.volume_mm3 / (kPi * 9 * 4.5), 1.0, 1e-4);
}

}  // namespace
}  // namespace proveout
