#include "core/mesh/mesh_simplifier.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "core/base/thread_limit.h"
#include "core/mesh/intersections.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {
namespace {

using Place = std::function<Vec3(const Vec3&)>;

/// The cube from -1 to 1 with n x n squares a face, each point moved by `place`. The motion is the number of
/// the face, from 0; the top has two, of which one begins where x > `split`.
TriMesh cube(int n, const Place& place, double split = 2.0) {
  TriMesh mesh;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, sign = face % 2 == 0 ? -1 : 1;
    const auto at = [&](int i, int j) {
      Vec3 p;
      p[axis] = sign;
      p[(axis + 1) % 3] = 2.0 * i / n - 1.0;
      p[(axis + 2) % 3] = 2.0 * j / n - 1.0;
      return p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        std::array<Vec3, 4> quad = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        if (sign < 0) std::swap(quad[1], quad[3]);
        const bool far = face == 5 && (quad[0].x() + quad[2].x()) / 2.0 > split;
        for (const auto& corners : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
          const auto first = static_cast<std::uint32_t>(mesh.positions.size());
          for (const int c : corners)
            mesh.positions.push_back(place(quad[static_cast<std::size_t>(c)]).cast<float>());
          mesh.triangles.push_back({first, first + 1, first + 2});
          mesh.motion.push_back(static_cast<std::uint32_t>(far ? 6 : face));
        }
      }
    }
  }
  TriMesh welded = weldVertices(mesh);
  welded.motion = mesh.motion;  // no triangle collapses
  return welded;
}

Vec3 asItIs(const Vec3& p) { return 10.0 * p; }
Vec3 onSphere(const Vec3& p) { return 10.0 * p.normalized(); }
/// A round bar along z, its ends flat.
Vec3 onBar(const Vec3& p) {
  const double r = std::max(std::abs(p.x()), std::abs(p.y())), length = std::hypot(p.x(), p.y());
  const double s = length > 0.0 ? 5.0 * r / length : 0.0;
  return {s * p.x(), s * p.y(), 20.0 * p.z()};
}
/// Waves on all faces.
Vec3 wavy(const Vec3& p) {
  return 10.0 * p + 0.15 * Vec3(std::sin(9 * p.y()), std::sin(7 * p.z() + 1), std::sin(8 * p.x() + 2));
}

/// Largest distance of samples of one mesh, 10 along each edge of a triangle, from another.
double farthest(const TriMesh& from, const TriMesh& to) {
  constexpr int kSamples = 10;
  const SurfaceMesh surface = toSurface(from);
  const TriangleTree tree(toSurface(to));
  double most = 0.0;
  for (const auto& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    for (int i = 0; i <= kSamples; ++i) {
      for (int j = 0; i + j <= kSamples; ++j)
        most = std::max(most, tree.nearest(a + (b - a) * i / kSamples + (c - a) * j / kSamples).squared);
    }
  }
  return std::sqrt(most);
}

Simplification simplify(TriMesh& mesh, double tolerance_mm) {
  Progress progress;
  const auto done = simplifyMesh(mesh, tolerance_mm, progress);
  EXPECT_TRUE(done.has_value());
  return done.value_or(Simplification());
}

std::map<std::uint32_t, double> areaOfMotions(const TriMesh& mesh) {
  const SurfaceMesh surface = toSurface(mesh);
  std::map<std::uint32_t, double> area;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area[mesh.motion[t]] += 0.5 * surface.areaVector(t).norm();
  return area;
}

bool samePlaces(const TriMesh& part, const TriMesh& whole) {
  const auto key = [](const Eigen::Vector3f& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::map<std::array<float, 3>, int> places;
  for (const auto& p : whole.positions) places[key(p)] = 1;
  return std::ranges::all_of(part.positions, [&](const auto& p) { return places.count(key(p)) == 1; });
}

TEST(MeshSimplifier, CubeBecomesTwelveTriangles) {
  TriMesh mesh = cube(40, asItIs);
  const Simplification done = simplify(mesh, 0.01);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 8000.0);
  EXPECT_LT(done.distance_mm, 1e-9);
  for (const auto& [motion, area] : areaOfMotions(mesh)) EXPECT_NEAR(area, 400.0, 1e-3) << motion;
}

TEST(MeshSimplifier, BorderOfMotionsOnOnePlaneStays) {
  TriMesh mesh = cube(40, asItIs, 0.25);
  const auto before = areaOfMotions(mesh);
  simplify(mesh, 0.01);
  EXPECT_EQ(mesh.triangles.size(), 16u);
  const auto after = areaOfMotions(mesh);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [motion, area] : before) EXPECT_NEAR(after.at(motion), area, 1e-3) << motion;
}

TEST(MeshSimplifier, BarHasLongStrips) {
  TriMesh mesh = cube(48, onBar);
  const std::size_t before = mesh.triangles.size();
  simplify(mesh, 0.02);
  // A perfect one has 36 chords of 0.02 mm around, 140 triangles; the bound adds up what each step may have
  // moved.
  EXPECT_LT(mesh.triangles.size(), 450u) << "of " << before;
}

struct Shape {
  const char* name;
  TriMesh mesh;
};
std::vector<Shape> shapes() {
  return {{"cube", cube(24, asItIs)},
          {"split cube", cube(24, asItIs, 0.1)},
          {"sphere", cube(40, onSphere)},
          {"bar", cube(40, onBar)},
          {"wavy", cube(60, wavy, 0.3)}};
}

TEST(MeshSimplifier, StaysWithinTheToleranceBothWays) {
  for (const Shape& shape : shapes()) {
    for (const double tolerance : {0.002, 0.02, 0.2}) {
      SCOPED_TRACE(testing::Message() << shape.name << " " << tolerance);
      TriMesh mesh = shape.mesh;
      const Simplification done = simplify(mesh, tolerance);
      constexpr double kRounding = 1e-5;
      EXPECT_LE(done.distance_mm, tolerance * (1 + 1e-6));
      EXPECT_LE(farthest(shape.mesh, mesh), done.distance_mm + kRounding);
      EXPECT_LE(farthest(mesh, shape.mesh), done.distance_mm + kRounding);
      EXPECT_TRUE(analyseTopology(mesh).closedManifold());
      EXPECT_EQ(findIntersections(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1)).size(), 0u);
      EXPECT_EQ(done.self_intersections, 0u);
      EXPECT_TRUE(samePlaces(mesh, shape.mesh));
      EXPECT_EQ(areaOfMotions(mesh).size(), areaOfMotions(shape.mesh).size());
      EXPECT_LE(mesh.triangles.size(), shape.mesh.triangles.size());
    }
  }
}

/// Half of a ball is off by nearly the tolerance before: it stays fine, the other half does not.
TEST(MeshSimplifier, WhatIsOffBeforeCounts) {
  const TriMesh ball = cube(40, onSphere);
  std::vector<float> off(ball.positions.size());
  for (std::size_t v = 0; v < off.size(); ++v) off[v] = ball.positions[v].x() < 0.0f ? 0.0999f : 0.0f;
  TriMesh mesh = ball;
  Progress progress;
  const auto done = simplifyMesh(mesh, 0.1, progress, off);
  ASSERT_TRUE(done.has_value());
  EXPECT_LE(done->distance_mm, 0.1 * (1 + 1e-6));
  EXPECT_GE(done->distance_mm, 0.0999 * (1 - 1e-6));
  const auto below = [](const TriMesh& of) {
    return std::ranges::count_if(of.positions, [](const auto& p) { return p.x() < -0.5f; });
  };
  EXPECT_GT(below(mesh), below(ball) * 9 / 10);
  EXPECT_LT(static_cast<double>(mesh.positions.size() - below(mesh)), 0.3 * static_cast<double>(off.size()));
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
}

TEST(MeshSimplifier, CoarserToleranceLeavesFewerTriangles) {
  std::size_t last = 0;
  for (const double tolerance : {0.2, 0.02, 0.002}) {
    TriMesh mesh = cube(40, onSphere);
    simplify(mesh, tolerance);
    EXPECT_GT(mesh.triangles.size(), last);
    last = mesh.triangles.size();
  }
}

/// Two surfaces nearer to each other than twice the tolerance, which could be pulled through each other.
TEST(MeshSimplifier, ThinShellDoesNotRunThroughItself) {
  TriMesh mesh = cube(30, wavy);
  TriMesh inner = mesh;
  const auto shift = static_cast<std::uint32_t>(mesh.positions.size());
  for (auto& p : inner.positions) p *= 0.996f;
  for (auto& t : inner.triangles) t = {t[0] + shift, t[2] + shift, t[1] + shift};
  mesh.positions.insert(mesh.positions.end(), inner.positions.begin(), inner.positions.end());
  mesh.triangles.insert(mesh.triangles.end(), inner.triangles.begin(), inner.triangles.end());
  mesh.motion.insert(mesh.motion.end(), inner.motion.begin(), inner.motion.end());
  ASSERT_EQ(findIntersections(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1)).size(), 0u);
  const std::size_t before = mesh.triangles.size();
  const Simplification done = simplify(mesh, 0.08);
  EXPECT_EQ(done.self_intersections, 0u);
  EXPECT_EQ(findIntersections(mesh, std::vector<std::uint8_t>(mesh.positions.size(), 1)).size(), 0u);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_LT(mesh.triangles.size(), before);
}

TEST(MeshSimplifier, SameOnAnyNumberOfThreads) {
  const TriMesh fine = cube(130, wavy, 0.3);  // several blocks
  TriMesh first;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    TriMesh mesh = fine;
    simplify(mesh, 0.01);
    if (threads == 1) first = mesh;
    EXPECT_EQ(mesh.positions, first.positions) << threads;
    EXPECT_EQ(mesh.triangles, first.triangles) << threads;
    EXPECT_EQ(mesh.motion, first.motion) << threads;
  }
  EXPECT_LT(first.triangles.size(), fine.triangles.size() / 2);
}

TEST(MeshSimplifier, NothingToDo) {
  TriMesh mesh = cube(4, onSphere);
  const TriMesh before = mesh;
  simplify(mesh, 0.0);
  EXPECT_EQ(mesh.triangles, before.triangles);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_FALSE(simplifyMesh(mesh, 1.0, cancelled).has_value());
  EXPECT_EQ(mesh.triangles, before.triangles);
  TriMesh empty;
  EXPECT_EQ(simplify(empty, 1.0).distance_mm, 0.0);
  TriMesh tetrahedron;
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  simplify(tetrahedron, 100.0);
  EXPECT_EQ(tetrahedron.triangles.size(), 4u);
}

TEST(MeshSimplifier, MeshWithoutMotions) {
  TriMesh mesh = cube(20, asItIs);
  mesh.motion.clear();
  simplify(mesh, 0.01);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_TRUE(mesh.motion.empty());
}

}  // namespace
}  // namespace proveout
