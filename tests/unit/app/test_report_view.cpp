// Meshes for the page: few triangles, near the mesh that they were made of, with the deviation where it is.
#include <gtest/gtest.h>

#include <cmath>

#include "app/page/measured_surface.h"
#include "app/page/reduced_mesh.h"

namespace proveout {
namespace {

/// A closed sphere about the origin, of rings of quads.
TriMesh sphere(double radius, std::uint32_t rings) {
  TriMesh mesh;
  const std::uint32_t sides = 2 * rings;
  mesh.positions.emplace_back(0, 0, radius);
  for (std::uint32_t i = 1; i < rings; ++i) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double a = M_PI * i / rings, b = M_PI * k / rings;
      mesh.positions.emplace_back(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b),
                                  radius * std::cos(a));
    }
  }
  mesh.positions.emplace_back(0, 0, -radius);
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return 1 + (i - 1) * sides + k % sides; };
  for (std::uint32_t k = 0; k < sides; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
    mesh.triangles.push_back({at(rings - 1, k), last, at(rings - 1, k + 1)});
  }
  return mesh;
}

double farthestFromSphere(const TriMesh& mesh, double radius) {
  double off = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f middle =
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0F;
    off = std::max(off, std::abs(static_cast<double>(middle.norm()) - radius));
  }
  return off;
}

TEST(ReducedMesh, StaysAsItIsWhereItIsSmall) {
  const TriMesh mesh = sphere(10, 8);
  const ViewMesh view = reducedMesh(mesh, 1000, Progress());
  EXPECT_EQ(view.mesh.triangles, mesh.triangles);
  EXPECT_EQ(view.off_mm, 0.0);
}

TEST(ReducedMesh, ClosedOnesAreSimplifiedWithinWhatIsTold) {
  const TriMesh mesh = sphere(10, 60);
  ASSERT_TRUE(analyseTopology(mesh).closedManifold());
  const ViewMesh view = reducedMesh(mesh, 3000, Progress());
  EXPECT_LE(view.mesh.triangles.size(), 3000u);
  EXPECT_GT(view.mesh.triangles.size(), 500u);
  EXPECT_EQ(view.made_of, mesh.triangles.size());
  EXPECT_TRUE(analyseTopology(view.mesh).closedManifold());
  EXPECT_LE(farthestFromSphere(view.mesh, 10), view.off_mm + farthestFromSphere(mesh, 10));
}

TEST(ReducedMesh, OpenOnesAreGathered) {
  TriMesh mesh = sphere(10, 60);
  mesh.triangles.resize(mesh.triangles.size() - 5);
  const ViewMesh view = reducedMesh(mesh, 3000, Progress());
  EXPECT_LE(view.mesh.triangles.size(), 3750u);
  EXPECT_GT(view.mesh.triangles.size(), 500u);
  EXPECT_LE(farthestFromSphere(view.mesh, 10), view.off_mm);
  EXPECT_LT(view.off_mm, 2.0);
}

/// Two triangles with a spot in the middle of one: the vertices alone do not know of it.
TEST(AddDeviations, SpotOnALargeTriangleShows) {
  ViewMesh view;
  view.mesh.positions = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}};
  view.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto spot = [](const Vec3& p) { return (p - Vec3(71, 23, 0)).norm() < 6.0 ? -0.3F : 0.0F; };
  addDeviations(spot, 0.01, 20'000, view);
  EXPECT_LE(view.mesh.triangles.size(), 20'000u);
  double area = 0.0, seen = 0.0;
  for (const auto& t : view.mesh.triangles) {
    const auto at = [&](std::size_t k) { return view.mesh.positions[t[k]].cast<double>().eval(); };
    const double own = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).z();
    EXPECT_GT(own, 0.0);
    area += own;
    seen += own *
            static_cast<double>(view.deviation_mm[t[0]] + view.deviation_mm[t[1]] + view.deviation_mm[t[2]]) /
            3.0;
  }
  EXPECT_NEAR(area, 1e4, 1e-2);
  EXPECT_NEAR(seen, -0.3 * M_PI * 36.0, 0.03 * 0.3 * M_PI * 36.0);
}

TEST(AddDeviations, IgnoredPlacesKeepTheirEdge) {
  ViewMesh view;
  view.mesh.positions = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}};
  view.mesh.triangles = {{0, 1, 2}};
  addDeviations([](const Vec3& p) { return p.x() > 40.0 ? std::nanf("") : 0.1F; }, 0.01, 20'000, view);
  for (const auto& t : view.mesh.triangles) {
    double low = 100.0, high = 0.0;
    for (const std::uint32_t v : t) {
      low = std::min(low, static_cast<double>(view.mesh.positions[v].x()));
      high = std::max(high, static_cast<double>(view.mesh.positions[v].x()));
    }
    if (low < 39.0 && high > 41.0) ADD_FAILURE() << "a triangle from " << low << " to " << high;
  }
}

/// A square of 10 x 10 whose deviation goes from -0.5 to 0.5 along x: each band has its width's share.
TEST(DeviationBands, SharesOfARampAreTheWidthsOfTheBands) {
  ViewMesh view;
  view.mesh.positions = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 5}};
  view.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}};
  view.deviation_mm = {-0.5F, 0.5F, 0.5F, -0.5F, std::nanf("")};
  const std::vector<DeviationBand> bands = deviationBands(view, {-0.5, -0.1, 0.2, 0.5});
  ASSERT_EQ(bands.size(), 5u);
  const double shares[] = {0.0, 0.4, 0.3, 0.3, 0.0};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    EXPECT_NEAR(bands[i].share, shares[i], 1e-6) << i;
    EXPECT_NEAR(bands[i].area_mm2, 100.0 * shares[i], 1e-4) << i;
  }
  EXPECT_EQ(bands[2].colour, "#e6e6e0");
  EXPECT_EQ(scaleOf(bands).stops.size(), 10u);
}

TEST(DeviationBands, OneValueEverywhereIsInOneBand) {
  ViewMesh view;
  view.mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  view.mesh.triangles = {{0, 1, 2}};
  view.deviation_mm = {0.3F, 0.3F, 0.3F};
  const std::vector<DeviationBand> bands = deviationBands(view, {-0.1, 0.1});
  EXPECT_NEAR(bands[2].area_mm2, 2.0, 1e-9);
  EXPECT_EQ(bands[0].area_mm2 + bands[1].area_mm2, 0.0);
}

/// The wedge 0 <= x <= 6, 0 <= y <= 4, 0 <= z <= 3 (1 - x / 6).
TEST(PageSections, AreasAreThoseOfTheWedge) {
  TriMesh wedge;
  wedge.positions = {{0, 0, 0}, {6, 0, 0}, {0, 0, 3}, {0, 4, 0}, {6, 4, 0}, {0, 4, 3}};
  wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}};
  ASSERT_TRUE(analyseTopology(wedge).closedManifold());
  const auto sections = pageSections(wedge, &wedge, {{0, 2.0}, {1, 1.0}, {2, 1.0}, {1, 9.0}});
  ASSERT_EQ(sections.size(), 4u);
  EXPECT_NEAR(sections[0].machined_mm2, 4.0 * 2.0, 1e-5);
  EXPECT_NEAR(sections[1].machined_mm2, 0.5 * 6.0 * 3.0, 1e-5);
  EXPECT_NEAR(sections[2].machined_mm2, 4.0 * 4.0, 1e-5);
  EXPECT_NEAR(sections[2].nominal_mm2, 4.0 * 4.0, 1e-5);
  EXPECT_TRUE(sections[3].machined.empty());
  Vec2 high(0, 0);  // across X: (Y, Z)
  for (const Vec2& p : sections[0].machined.front()) high = high.cwiseMax(p);
  EXPECT_NEAR((high - Vec2(4, 2)).norm(), 0.0, 1e-5);
}

}  // namespace
}  // namespace proveout
