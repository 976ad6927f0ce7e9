// Where a mesh may run through itself.
#include "core/mesh/crowded_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/mesh/intersections.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {
namespace {

/// A sphere of n rings and 2 n sectors, turned inside out if `inward`.
TriMesh sphere(int n, double radius, const Eigen::Vector3f& middle, bool inward = false) {
  TriMesh mesh;
  const double step = 3.14159265358979 / n;
  const auto at = [&](int i, int j) {
    return Eigen::Vector3f(middle +
                           (radius * Vec3(std::sin(i * step) * std::cos(j * step),
                                          std::sin(i * step) * std::sin(j * step), std::cos(i * step)))
                               .cast<float>());
  };
  const auto ring = [&](int i, int j) {
    return static_cast<std::uint32_t>(1 + (i - 1) * 2 * n + j % (2 * n));
  };
  mesh.positions.push_back(at(0, 0));
  for (int i = 1; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) mesh.positions.push_back(at(i, j));
  }
  mesh.positions.push_back(at(n, 0));
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (int j = 0; j < 2 * n; ++j) {
    mesh.triangles.push_back({0, ring(1, j), ring(1, j + 1)});
    for (int i = 1; i + 1 < n; ++i) {
      mesh.triangles.push_back({ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)});
      mesh.triangles.push_back({ring(i, j), ring(i + 1, j + 1), ring(i, j + 1)});
    }
    mesh.triangles.push_back({ring(n - 1, j), last, ring(n - 1, j + 1)});
  }
  for (auto& t : mesh.triangles) {
    if (inward) std::swap(t[1], t[2]);
  }
  return mesh;
}

void append(TriMesh& mesh, const TriMesh& more) {
  const auto shift = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

/// Pairs that the whole search finds and that are not among the triangles.
std::size_t missed(const TriMesh& mesh, const std::vector<std::uint32_t>& among) {
  const std::vector<std::uint8_t> all(mesh.positions.size(), 1);
  const auto pairs = findIntersections(mesh, all);
  EXPECT_GT(pairs.size(), 0u);
  EXPECT_EQ(findIntersectionsAmong(mesh, among).size(), pairs.size());
  return static_cast<std::size_t>(std::ranges::count_if(pairs, [&](const auto& pair) {
    return !std::ranges::binary_search(among, pair[0]) || !std::ranges::binary_search(among, pair[1]);
  }));
}

TEST(CrowdedPlaces, SmoothSurfaceHasNone) {
  const TriMesh mesh = sphere(60, 10.0, {1, 2, 3});
  EXPECT_EQ(trianglesInCrowdedPlaces(mesh, 0.01).size(), 0u);
}

TEST(CrowdedPlaces, SmallBallIsOne) {
  TriMesh mesh = sphere(60, 10.0, {0, 0, 0});
  const std::size_t large = mesh.triangles.size();
  append(mesh, sphere(6, 0.3, {20, 0, 0}));
  const auto crowded = trianglesInCrowdedPlaces(mesh, 0.001);
  ASSERT_EQ(crowded.size(), mesh.triangles.size() - large);
  EXPECT_EQ(crowded.front(), large);
}

/// A shell whose sides were pulled through each other.
TEST(CrowdedPlaces, HoldAllPairsOfAShellPulledThroughItself) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> off(-0.05f, 0.05f);
  for (const double gap : {0.02, 0.05, 0.08}) {
    TriMesh mesh = sphere(40, 10.0, {0, 0, 0});
    append(mesh, sphere(40, 10.0 - gap, {0, 0, 0}, true));
    for (auto& p : mesh.positions) p += off(random) * p.normalized();
    EXPECT_EQ(missed(mesh, trianglesInCrowdedPlaces(mesh, 0.05)), 0u) << gap;
  }
}

/// Two bodies that are pushed into each other face each other where they meet.
TEST(CrowdedPlaces, HoldAllPairsOfBallsPushedTogether) {
  TriMesh mesh = sphere(50, 5.0, {0, 0, 0});
  append(mesh, sphere(50, 5.0, {9.95f, 0.1f, 0.2f}));
  EXPECT_EQ(missed(mesh, trianglesInCrowdedPlaces(mesh, 0.03)), 0u);
}

TEST(CrowdedPlaces, EmptyMeshAndTrianglesThatAreNone) {
  TriMesh mesh;
  EXPECT_TRUE(trianglesInCrowdedPlaces(mesh, 0.1).empty());
  mesh.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(trianglesInCrowdedPlaces(mesh, 0.1).size(), 1u);
}

}  // namespace
}  // namespace proveout
