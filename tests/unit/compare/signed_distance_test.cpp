#include "core/mesh/signed_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "removal/compare/sample_mesh.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using shapes::blocks;
using shapes::surface;

/// Sharp convex and concave edges, saddle corners, knife edges of 1.1 degrees, thin walls, slivers.
std::vector<std::pair<const char*, TriMesh>> difficultSolids() {
  std::vector<std::pair<const char*, TriMesh>> out;
  out.emplace_back("staircase", blocks({0, 3, 5, 9}, {0, 2, 6, 9}, {0, 1, 4, 9}, [](int i, int j, int k) {
                     return i + j + k < 4 && !(i == 1 && j == 1 && k == 0);
                   }));
  out.emplace_back("thin walls", blocks({0, 0.02, 5, 5.02}, {0, 4}, {0, 0.02, 3},
                                        [](int i, int, int k) { return i != 1 || k == 0; }));
  TriMesh knife = shapes::box({0, 0, 0}, {10, 10, 0.2});
  for (auto& p : knife.positions) {
    if (p.x() > 5 && p.z() > 0.1f) p.z() = 0.001f;
  }
  out.emplace_back("knife", knife);
  // A star whose tips are needles and whose valleys are deep.
  TriMesh star = shapes::sphere({0, 0, 0}, 4, 2);
  for (std::size_t i = 0; i < star.positions.size(); ++i)
    star.positions[i] *= i % 3 == 0 ? 2.5f : i % 3 == 1 ? 1.0f : 0.4f;
  out.emplace_back("star", star);
  // Slivers along a sharp edge, as simplified meshes have them.
  TriMesh slivers = shapes::box({0, 0, 0}, {8, 8, 8});
  const SampleMesh fine = makeSampleMesh(slivers, 0.9, 100000);
  slivers.positions.clear();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-4e-6f, 4e-6f);
  for (const auto& p : fine.surface.points) {
    slivers.positions.push_back(p.cast<float>() +
                                Eigen::Vector3f(noise(random), noise(random), noise(random)));
  }
  slivers.triangles = fine.surface.triangles;
  out.emplace_back("noisy box", slivers);
  return out;
}

std::vector<Vec3> pointsNear(const SurfaceMesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[random() % mesh.triangles.size()];
    Vec3 p = mesh.points[t[0]];                                                           // a corner
    if (i % 3 == 1) p += unit(random) * (mesh.points[t[1]] - p);                          // on an edge
    if (i % 3 == 2) p = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;  // on a face
    const double reach = std::pow(10.0, -4.0 * unit(random) + 0.7);
    out.push_back(p + reach * Vec3(normal(random), normal(random), normal(random)));
  }
  return out;
}

TEST(SignedDistance, SignsAgreeWithTheWindingNumber) {
  Progress progress;
  for (const auto& [name, mesh] : difficultSolids()) {
    ASSERT_TRUE(analyseTopology(mesh).boundary_edges == 0) << name;
    const SurfaceMesh s = surface(mesh);
    const SignedDistance distance(s);
    const std::vector<Vec3> points = pointsNear(s, 6000, 11);
    const auto found = distance.at(points, progress, 0, 1);
    int wrong = 0, compared = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::abs(found[i].distance) < 1e-5) continue;
      ++compared;
      const double winding = shapes::windingNumber(s, points[i]);
      wrong += (winding > 0.5) != (found[i].distance < 0.0);
    }
    EXPECT_EQ(wrong, 0) << name;
    EXPECT_GT(compared, 5000) << name;
  }
}

TEST(SignedDistance, DistancesAgreeWithEveryTriangleTried) {
  Progress progress;
  const auto segment = [](const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - t * (b - a)).norm();
  };
  const SurfaceMesh s = surface(difficultSolids()[3].second);
  const SignedDistance distance(s);
  const std::vector<Vec3> points = pointsNear(s, 500, 5);
  const auto found = distance.at(points, progress, 0, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double best = 1e9;
    for (const auto& t : s.triangles) {
      const Vec3 &a = s.points[t[0]], &b = s.points[t[1]], &c = s.points[t[2]], &p = points[i];
      const Vec3 n = (b - a).cross(c - a).normalized();
      const Vec3 foot = p - n * n.dot(p - a);
      const bool within = n.dot((b - a).cross(foot - a)) > 0 && n.dot((c - b).cross(foot - b)) > 0 &&
                          n.dot((a - c).cross(foot - c)) > 0;
      best = std::min(best, within ? std::abs(n.dot(p - a))
                                   : std::min({segment(p, a, b), segment(p, b, c), segment(p, c, a)}));
    }
    EXPECT_NEAR(std::abs(found[i].distance), best, 1e-9);
    EXPECT_NEAR(found[i].gradient.norm(), 1.0f, 1e-5f);
  }
}

TEST(SignedDistance, GradientPointsOutwards) {
  Progress progress;
  const SurfaceMesh s = surface(shapes::box({0, 0, 0}, {10, 10, 10}));
  const SignedDistance distance(s);
  const auto d = distance.at({{5, 5, 11}, {5, 5, 9}, {5, 5, 10}, {5, 5, 1}}, progress, 0, 1);
  EXPECT_DOUBLE_EQ(d[0].distance, 1.0);
  EXPECT_DOUBLE_EQ(d[1].distance, -1.0);
  EXPECT_NEAR(d[2].distance, 0.0, 1e-12);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(d[i].gradient.z(), 1.0f, 1e-6f) << i;
  EXPECT_NEAR(d[3].gradient.z(), -1.0f, 1e-6f);
}

/// Largest distance from random places of the mesh to the nearest sample.
double coarsestPlace(const TriMesh& mesh, const SampleMesh& fine, int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[random() % mesh.triangles.size()];
    double u = unit(random), v = unit(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>();
    const Vec3 p = a + u * (b - a) + v * (mesh.positions[t[2]].cast<double>() - a);
    double best = 1e9;
    for (const Vec3& q : fine.surface.points) best = std::min(best, (p - q).squaredNorm());
    worst = std::max(worst, std::sqrt(best));
  }
  return worst;
}

TEST(SampleMesh, StaysClosedAndCoversTheSurface) {
  TriMesh needle = shapes::box({0, 0, 0}, {30, 0.004, 12});
  for (const TriMesh& mesh :
       {blocks({0, 60, 60.3}, {0, 0.2, 20}, {0, 5}, [](int i, int j, int) { return i == 0 || j == 0; }),
        shapes::sphere({1, 2, 3}, 10, 1), needle}) {
    const SampleMesh fine = makeSampleMesh(mesh, 0.7, 1000000);
    TriMesh check;
    for (const auto& p : fine.surface.points) check.positions.push_back(p.cast<float>());
    check.triangles = fine.surface.triangles;
    EXPECT_TRUE(analyseTopology(check).closedManifold());
    EXPECT_EQ(weldVertices(check).positions.size(), check.positions.size());
    EXPECT_NEAR(meshArea(check) / meshArea(mesh), 1.0, 1e-6);
    EXPECT_NEAR(meshVolume(check) / meshVolume(mesh), 1.0, 1e-4);
    EXPECT_LE(coarsestPlace(mesh, fine, 2000), 0.7);
    EXPECT_LT(fine.surface.points.size(), 1.6 * meshArea(mesh) / 0.49 + 4000);
    ASSERT_EQ(fine.parent.size(), check.triangles.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) EXPECT_EQ(check.positions[i], mesh.positions[i]);
  }
}

TEST(SampleMesh, SliversCostTheirLengthOnly) {
  TriMesh fan;  // a disc of slivers 50 long and 0.03 wide, closed by a tip above
  for (int i = 0; i < 10000; ++i) {
    const double a = 2 * kPi * i / 10000;
    fan.positions.push_back(Vec3(50 * std::cos(a), 50 * std::sin(a), 0).cast<float>());
  }
  fan.positions.push_back({0, 0, 0});
  fan.positions.push_back({0, 0, 20});
  for (std::uint32_t i = 0; i < 10000; ++i) {
    fan.triangles.push_back({(i + 1) % 10000, i, 10000});
    fan.triangles.push_back({i, (i + 1) % 10000, 10001});
  }
  const SampleMesh fine = makeSampleMesh(fan, 1.0, 100000000);
  EXPECT_LT(fine.surface.triangles.size(), 20000 * 2 * 56u);
}

TEST(SampleMesh, WidensTheSpacingOfAHugeMesh) {
  const SampleMesh coarse = makeSampleMesh(shapes::box({0, 0, 0}, {1000, 1000, 1000}), 0.01, 50000);
  EXPECT_LT(coarse.surface.triangles.size(), 60000u);
  EXPECT_GT(coarse.surface.triangles.size(), 10000u);
  EXPECT_GT(coarse.spacing_mm, 10.0);
}

}  // namespace
}  // namespace proveout
