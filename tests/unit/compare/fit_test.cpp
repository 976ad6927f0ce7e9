// Fits of a nominal to points and meshes of the part: known poses come back.
#include "removal/compare/fit/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <random>

#include "removal/compare/fit/point_cells.h"
#include "shapes.h"

namespace proveout {
namespace {

/// A step, a pocket and a boss: no turn takes it onto itself. 80 x 60 x 30 mm about.
TriMesh bracket() {
  const std::vector<double> x{-40, -25, -10, 12, 30, 40}, y{-30, -12, 5, 30}, z{0, 8, 14, 22, 30};
  return shapes::blocks(x, y, z, [](int i, int j, int k) {
    if (k == 0) return true;
    if (k == 1) return !(i == 3 && j == 1);
    if (k == 2) return i <= 1;
    return i == 0 && j == 2;
  });
}

RigidTransform pose(const Vec3& rotate_deg, const Vec3& move) { return {rotationXyzDeg(rotate_deg), move}; }

/// Points of the mesh by area, without those for which `missing` says so, each off by a normal error.
template <typename Missing>
std::vector<Vec3> scanOf(const TriMesh& mesh, std::size_t count, double noise_mm, const RigidTransform& at,
                         const Missing& missing) {
  const SurfaceMesh s = shapes::surface(mesh);
  std::vector<double> areas;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) areas.push_back(s.areaVector(t).norm());
  std::mt19937_64 random(20'240'611);
  std::discrete_distribution<std::size_t> pick(areas.begin(), areas.end());
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> error(0.0, 1.0);
  std::vector<Vec3> out;
  while (out.size() < count) {
    const auto& v = s.triangles[pick(random)];
    double u = unit(random), w = unit(random);
    if (u + w > 1.0) {
      u = 1.0 - u;
      w = 1.0 - w;
    }
    const Vec3 p =
        s.points[v[0]] + u * (s.points[v[1]] - s.points[v[0]]) + w * (s.points[v[2]] - s.points[v[0]]);
    const Vec3 off(error(random), error(random), error(random));
    if (!missing(p)) out.push_back(at(p + noise_mm * off));
  }
  return out;
}

bool nothing(const Vec3&) { return false; }

/// The farthest that a point of the nominal is from where it should lie.
double poseError(const TriMesh& nominal, const RigidTransform& found, const RigidTransform& wanted) {
  double most = 0.0;
  for (const auto& position : nominal.positions) {
    const Vec3 p = position.cast<double>();
    most = std::max(most, (found(p) - wanted(p)).norm());
  }
  return most;
}

double turnError(const RigidTransform& found, const RigidTransform& wanted) {
  return turnOf(found * wanted.inverse());
}

TEST(Fit, RecoversAPoseFromNoisyPointsOfSevenTenths) {
  const TriMesh nominal = bracket();
  const RigidTransform wanted = pose({0.4, -0.3, 0.5}, {0.5, -0.4, 0.3});
  // The end at +X was not scanned: three tenths of the area.
  const auto missing = [](const Vec3& p) { return p.x() > 13.0; };
  double kept = 0.0, all = 0.0;
  for (const Vec3& p : scanOf(nominal, 20'000, 0.0, {}, nothing)) {
    all += 1.0;
    kept += missing(p) ? 0.0 : 1.0;
  }
  EXPECT_NEAR(kept / all, 0.7, 0.03);
  const FitPoints scan{scanOf(nominal, 300'000, 0.02, wanted, missing)};
  Progress progress;
  const Result<Alignment> found = fitNominal(nominal, nullptr, scan, 2.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(poseError(nominal, found->motion, wanted), 1e-3);
  EXPECT_LT(turnError(found->motion, wanted), 1e-5);
  EXPECT_EQ(found->free_directions, 0);
  EXPECT_NEAR(found->rms_mm, 0.02, 0.001);
  EXPECT_GT(found->points, 290'000u);
  EXPECT_EQ(found->points + found->left_out, 300'000u);
  EXPECT_NEAR(found->moved_mm, farthestMove(wanted, nominal), 1e-3);
  EXPECT_NEAR(found->turned_rad, turnOf(wanted), 1e-5);
  RecordProperty("pose_error_nm", static_cast<int>(1e6 * poseError(nominal, found->motion, wanted)));
  RecordProperty("turn_error_nrad", static_cast<int>(1e9 * turnError(found->motion, wanted)));
}

TEST(Fit, StraysAndWrongPlacesDoNotPull) {
  const TriMesh nominal = bracket();
  const RigidTransform wanted = pose({-0.2, 0.3, 0.1}, {0.2, 0.3, -0.4});
  std::vector<Vec3> points = scanOf(nominal, 60'000, 0.005, {}, nothing);
  // The top of the boss is 0.6 mm too low, a fifth of the points are dust about the part.
  for (Vec3& p : points)
    if (p.z() > 29.5) p.z() -= 0.6;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int k = 0; k < 15'000; ++k)
    points.emplace_back(50.0 * unit(random), 40.0 * unit(random), 15.0 + 25.0 * unit(random));
  for (Vec3& p : points) p = wanted(p);
  Progress progress;
  const Result<Alignment> found = fitNominal(nominal, nullptr, {points}, 1.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(poseError(nominal, found->motion, wanted), 1e-3);
  EXPECT_GT(found->left_out, 12'000u);
}

TEST(Fit, AMeshComesBackToRounding) {
  const TriMesh nominal = bracket();
  const RigidTransform wanted = pose({0.1, 0.2, -0.3}, {-0.2, 0.1, 0.3});
  TriMesh part = nominal;
  moveMesh(wanted, part);
  Progress progress;
  const FitPoints points = fitPointsOf(part, nullptr, 0.1, {}, 20'000);
  EXPECT_TRUE(points.of_facets);
  const Result<Alignment> found = fitNominal(nominal, nullptr, points, 1.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(poseError(nominal, found->motion, wanted), 2e-5);
  EXPECT_EQ(found->left_out, 0u);
}

TEST(Fit, WhatIsRoundTurnsFreely) {
  const TriMesh ball = shapes::sphere({1, 2, 3}, 10.0, 4);
  const RigidTransform wanted = pose({0, 0, 0}, {0.3, -0.2, 0.1});
  const FitPoints scan{scanOf(ball, 50'000, 0.0, wanted, nothing), true};
  Progress progress;
  const Result<Alignment> found = fitNominal(ball, nullptr, scan, 1.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->free_directions, 3);
  EXPECT_LT((found->motion(Vec3(1, 2, 3)) - wanted(Vec3(1, 2, 3))).norm(), 1e-3);
  EXPECT_LT(turnOf(found->motion), 1e-3);
}

/// A prism of many sides about Z, from 0 to 20.
TriMesh cylinder(double radius, int sides) {
  TriMesh mesh;
  for (const double z : {0.0, 20.0}) {
    for (int k = 0; k < sides; ++k) {
      const double a = 2.0 * kPi * k / sides;
      mesh.positions.push_back(Vec3(radius * std::cos(a), radius * std::sin(a), z).cast<float>());
    }
  }
  mesh.positions.push_back(Vec3(0, 0, 0).cast<float>());
  mesh.positions.push_back(Vec3(0, 0, 20).cast<float>());
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{k, next, n + k}, {next, n + next, n + k}, {2 * n, next, k}, {2 * n + 1, n + k, n + next}});
  }
  return mesh;
}

TEST(Fit, ACylinderIsLeftAsItIsTurned) {
  const TriMesh pin = cylinder(8.0, 96);
  const RigidTransform wanted = pose({0.3, -0.2, 0.0}, {0.2, 0.1, -0.3});
  const FitPoints scan{scanOf(pin, 60'000, 0.002, wanted, nothing), true};
  Progress progress;
  const Result<Alignment> found = fitNominal(pin, nullptr, scan, 1.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->free_directions, 1);
  for (const double z : {0.0, 20.0})
    EXPECT_LT((found->motion(Vec3(0, 0, z)) - wanted(Vec3(0, 0, z))).norm(), 1e-3);
}

TEST(Fit, ALargeWayIsToldAndNotHidden) {
  const TriMesh nominal = bracket();
  const RigidTransform wanted = pose({0, 0, 0}, {0.9, 0.9, 0.0});
  const FitPoints scan{scanOf(nominal, 30'000, 0.0, wanted, nothing)};
  Progress progress;
  const Result<Alignment> found = fitNominal(nominal, nullptr, scan, 1.0, progress);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->moved_mm, std::hypot(0.9, 0.9), 1e-3);
}

TEST(Fit, FarPointsAreNoPart) {
  const TriMesh nominal = bracket();
  const FitPoints scan{scanOf(nominal, 5'000, 0.0, pose({0, 0, 0}, {200, 0, 0}), nothing)};
  Progress progress;
  const Result<Alignment> found = fitNominal(nominal, nullptr, scan, 1.0, progress);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ErrorKind::kInput);
  EXPECT_THAT(found.error().message, testing::HasSubstr("within 2 mm of the nominal"));
}

TEST(Fit, DoesNotDependOnThreads) {
  const TriMesh nominal = bracket();
  const FitPoints scan{scanOf(nominal, 20'000, 0.01, pose({0.1, 0.1, 0.1}, {0.1, 0.2, 0.3}), nothing)};
  Progress progress;
  const Result<Alignment> many = fitNominal(nominal, nullptr, scan, 1.0, progress);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Result<Alignment> alone = fitNominal(nominal, nullptr, scan, 1.0, progress);
  ASSERT_TRUE(many && alone);
  EXPECT_EQ(many->motion.rotation, alone->motion.rotation);
  EXPECT_EQ(many->motion.translation, alone->motion.translation);
}

TEST(Fit, APlacementSaysTheSameAsTheMotion) {
  const RigidTransform motion = pose({12.5, -7.25, 3.0}, {1, 2, 3});
  const RigidTransform again = placementOf(motion).motion();
  EXPECT_LT((again.rotation - motion.rotation).norm(), 1e-14);
  EXPECT_EQ(again.translation, motion.translation);
}

TEST(PointCells, FindsWhatIsNear) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 10.0);
  std::vector<Vec3> points;
  for (int k = 0; k < 2000; ++k) points.emplace_back(unit(random), unit(random), unit(random));
  const PointCells cells(points, 0.7);
  for (const Vec3& p : {Vec3(5, 5, 5), Vec3(0, 0, 0), Vec3(-0.5, 10.4, 3), Vec3(1e9, 0, 0)}) {
    std::size_t found = 0, wanted = 0;
    cells.forEachNear(p, 1.3, [&](std::uint32_t i, double squared) {
      EXPECT_EQ(squared, (points[i] - p).squaredNorm());
      ++found;
    });
    for (const Vec3& q : points) wanted += (q - p).norm() <= 1.3 ? 1 : 0;
    EXPECT_EQ(found, wanted);
  }
}

TEST(PointCells, SpacingIsThatOfAGrid) {
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) points.emplace_back(0.25 * i, 0.25 * j, 1.0);
  EXPECT_NEAR(pointSpacing(points, 60 * 60 * 0.0625), 0.25, 0.05);
  EXPECT_NEAR(pointSpacing(points, 6 * 60 * 60 * 0.0625), 0.25, 0.05);  // of a body of which one side is seen
}

}  // namespace
}  // namespace proveout
