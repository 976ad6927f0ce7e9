// Meshes with triangles that run through each other, repaired or left as they were.
#include "removal/surface/repair/intersection_repair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/intersections.h"

namespace proveout {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

Pairs allPairs(const TriMesh& mesh) {
  const std::vector<std::uint8_t> all(mesh.positions.size(), 1);
  return findIntersections(mesh, all);
}

/// A block of n x n x n cells of 1 mm whose faces are squares cut along one diagonal.
TriMesh block(int n) {
  TriMesh mesh;
  std::vector<std::uint32_t> at(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), 0xFFFFFFFFu);
  const auto vertex = [&](const Eigen::Vector3i& p) {
    std::uint32_t& v = at[static_cast<std::size_t>((p.x() * (n + 1) + p.y()) * (n + 1) + p.z())];
    if (v == 0xFFFFFFFFu) {
      v = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(p.cast<float>());
    }
    return v;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3),
                          v = Eigen::Vector3i::Unit((axis + 2) % 3);
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n * n; ++i) {
        const Eigen::Vector3i p = side * n * Eigen::Vector3i::Unit(axis) + i / n * u + i % n * v;
        std::array<std::uint32_t, 4> q = {vertex(p), vertex(p + u), vertex(p + u + v), vertex(p + v)};
        if (side == 0) std::swap(q[1], q[3]);
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
      }
    }
  }
  mesh.motion.assign(mesh.triangles.size(), 7);
  return mesh;
}

std::uint32_t vertexAt(const TriMesh& mesh, const Eigen::Vector3f& p) {
  std::uint32_t best = 0;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if ((mesh.positions[v] - p).norm() < (mesh.positions[best] - p).norm()) best = v;
  }
  return best;
}

/// Repairs and checks what always holds.
std::size_t repair(TriMesh& mesh) {
  const std::size_t left = repairIntersections(mesh, allPairs(mesh), 1.0).size();
  EXPECT_EQ(left, allPairs(mesh).size());
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_EQ(mesh.motion.size(), mesh.triangles.size());
  return left;
}

TEST(IntersectionRepair, LeavesASoundMeshAlone) {
  TriMesh mesh = block(4);
  const TriMesh before = mesh;
  ASSERT_TRUE(allPairs(mesh).empty());
  EXPECT_EQ(repair(mesh), 0u);
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(IntersectionRepair, PutsVerticesOfAnEdgeInOrder) {
  TriMesh mesh = block(6);
  // Along the top edge at y = 0, one vertex beyond the next: both stay on the edge.
  mesh.positions[vertexAt(mesh, {2, 0, 6})].x() = 3.4f;
  ASSERT_FALSE(allPairs(mesh).empty());
  EXPECT_EQ(repair(mesh), 0u);
  EXPECT_NEAR(meshVolume(mesh), 216.0, 1e-3);
  EXPECT_NEAR(meshArea(mesh), 216.0, 1e-3);
}

TEST(IntersectionRepair, DrawsCoincidentVerticesTogether) {
  TriMesh mesh = block(6);
  mesh.positions[vertexAt(mesh, {2, 0, 6})] = mesh.positions[vertexAt(mesh, {3, 0, 6})];
  ASSERT_FALSE(allPairs(mesh).empty());
  EXPECT_EQ(repair(mesh), 0u);
  EXPECT_NEAR(meshVolume(mesh), 216.0, 1e-3);
}

TEST(IntersectionRepair, KeepsACornerThatIsFoldedUnder) {
  TriMesh mesh = block(6);
  mesh.positions[vertexAt(mesh, {5, 5, 6})] = {6.0f, 6.0f, 6.0f};
  ASSERT_FALSE(allPairs(mesh).empty());
  EXPECT_EQ(repair(mesh), 0u);
  const Eigen::Vector3f corner(6, 6, 6);
  EXPECT_LT((mesh.positions[vertexAt(mesh, corner)] - corner).norm(), 0.051f);
}

TEST(IntersectionRepair, GivesUpWhereBodiesRunThroughEachOther) {
  TriMesh mesh = block(3);
  const TriMesh other = block(3);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& p : other.positions) mesh.positions.push_back(p + Eigen::Vector3f(1.3f, 1.4f, 1.2f));
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  mesh.motion.resize(mesh.triangles.size(), 8);
  ASSERT_FALSE(allPairs(mesh).empty());
  EXPECT_GT(repair(mesh), 0u);
  // Neither gets away from where it was.
  EXPECT_NEAR(meshVolume(mesh), 54.0, 1.0);
}

TEST(IntersectionRepair, LeavesAllAsItWasIfAllIsAskedForInVain) {
  TriMesh mesh = block(3);
  const TriMesh other = block(3);
  TriMesh folded = block(6);
  folded.positions[vertexAt(folded, {2, 0, 6})].x() = 3.4f;
  const auto add = [&](const TriMesh& body, const Eigen::Vector3f& by) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& p : body.positions) mesh.positions.push_back(p + by);
    for (const auto& t : body.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.motion.resize(mesh.triangles.size(), 8);
  };
  add(other, {1.3f, 1.4f, 1.2f});
  add(folded, {40, 0, 0});
  TriMesh most = mesh, all = mesh;
  const auto pairs = allPairs(mesh);
  const auto left = repairIntersections(most, pairs, 1.0, RepairAim::kMost);
  EXPECT_LT(left.size(), pairs.size());
  EXPECT_NE(most.positions, mesh.positions);
  EXPECT_EQ(repairIntersections(all, pairs, 1.0, RepairAim::kAll), left);
  EXPECT_EQ(all.positions, mesh.positions);
  EXPECT_EQ(all.triangles, mesh.triangles);
  EXPECT_EQ(all.motion, mesh.motion);
}

TEST(IntersectionRepair, IsTheSameEachTime) {
  TriMesh a = block(6);
  a.positions[vertexAt(a, {2, 0, 6})].x() = 3.4f;
  a.positions[vertexAt(a, {4, 3, 6})].y() = 4.2f;
  TriMesh b = a;
  EXPECT_EQ(repair(a), repair(b));
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace proveout
