// Fans of triangles around vertices: closed, open, pinched, with an edge too many.
#include "removal/surface/mesh/surface_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace proveout {
namespace {

using Names = std::vector<std::uint32_t>;

/// Two cones over a ring of `n` vertices: number 0 above, 1 below.
TriMesh spindle(std::uint32_t n) {
  TriMesh mesh;
  mesh.positions.resize(n + 2);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({1, b, a});
  }
  return mesh;
}

Names brokenOf(const TriMesh& mesh, const Names& watched) {
  Names name(mesh.positions.size(), kNoWatch), broken;
  for (const std::uint32_t v : watched) name[v] = 100 + v;
  findBrokenFans(mesh, name, broken);
  return broken;
}

Names allOf(const TriMesh& mesh) {
  Names all(mesh.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

TEST(SurfaceFaults, ClosedFansAreWhole) {
  for (const std::uint32_t n : {3u, 4u, 7u, 24u, 25u, 300u, 5000u}) {
    const TriMesh mesh = spindle(n);
    EXPECT_TRUE(brokenOf(mesh, allOf(mesh)).empty()) << n;
  }
}

TEST(SurfaceFaults, AMissingTriangleOpensThreeFans) {
  for (const std::uint32_t n : {5u, 40u, 6000u}) {
    TriMesh mesh = spindle(n);
    mesh.triangles.erase(mesh.triangles.begin() + 2);  // of 0, 3, 4
    EXPECT_EQ(brokenOf(mesh, allOf(mesh)), (Names{100, 103, 104})) << n;
    EXPECT_EQ(brokenOf(mesh, {1, 2, 4}), Names{104}) << n;
    EXPECT_TRUE(brokenOf(mesh, {}).empty());
  }
}

TEST(SurfaceFaults, TwoFansAtOneVertexAreBroken) {
  for (const std::uint32_t n : {4u, 30u}) {
    TriMesh mesh = spindle(n);
    const TriMesh other = spindle(n);
    for (auto t : other.triangles) {  // a second spindle whose tip is the first one's
      for (std::uint32_t& v : t) v = v == 0 ? 0 : v + n + 1;
      mesh.triangles.push_back(t);
    }
    mesh.positions.resize(2 * n + 3);
    EXPECT_EQ(brokenOf(mesh, allOf(mesh)), Names{100}) << n;
  }
}

TEST(SurfaceFaults, TheOtherEndOfAnEdgeTooManyIsNamedToo) {
  TriMesh mesh = spindle(6);
  // Another closed body, a flat one of two sides, on the edge from 0 to 3.
  mesh.positions.resize(9);
  mesh.triangles.push_back({0, 3, 8});
  mesh.triangles.push_back({3, 0, 8});
  const Names broken = brokenOf(mesh, allOf(mesh));
  EXPECT_NE(std::find(broken.begin(), broken.end(), 100u), broken.end());
  EXPECT_NE(std::find(broken.begin(), broken.end(), 103u), broken.end());
  const Names ends = brokenOf(mesh, {0, 3});  // each names itself and the other
  EXPECT_EQ(ends, (Names{100, 103, 103, 100}));
}

}  // namespace
}  // namespace proveout
