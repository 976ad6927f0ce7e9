#include "removal/wire/part_fans.h"

#include <gtest/gtest.h>

#include "removal/wire/wall_meetings.h"

namespace proveout {
namespace {

void addBox(const Eigen::Vector3f& at, std::vector<std::uint32_t> corner, TriMesh& mesh) {
  for (std::uint32_t k = 0; k < 8; ++k) {
    if (corner[k] != 99) continue;
    corner[k] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(at + Eigen::Vector3f(k & 1 ? 1 : 0, k & 2 ? 1 : 0, k & 4 ? 1 : 0));
  }
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({corner[a], corner[b], corner[c]});
    mesh.triangles.push_back({corner[a], corner[c], corner[d]});
  };
  quad(0, 2, 3, 1);
  quad(4, 5, 7, 6);
  quad(0, 1, 5, 4);
  quad(2, 6, 7, 3);
  quad(0, 4, 6, 2);
  quad(1, 3, 7, 5);
}

/// Two boxes that share an upright edge.
TEST(PartFans, BoxesThatTouchAlongAnEdge) {
  TriMesh mesh;
  addBox({0, 0, 0}, std::vector<std::uint32_t>(8, 99), mesh);
  // Corners 0 and 4 of the second are corners 3 and 7 of the first.
  addBox({1, 1, 0}, {3, 99, 99, 99, 7, 99, 99, 99}, mesh);
  ASSERT_GT(analyseTopology(mesh).non_manifold_edges, 0u);
  partFans(mesh);
  const MeshTopology topology = analyseTopology(mesh);
  EXPECT_TRUE(topology.closedManifold());
  EXPECT_EQ(topology.components, 2u);
  EXPECT_EQ(mesh.positions.size(), 16u);
  // Both edges stand back, by some micrometres' hundredths.
  EXPECT_EQ(wallMeetings(mesh), 0u);
  EXPECT_NEAR(meshVolume(mesh), 2.0, 5e-5);
}

TEST(PartFans, BoxesThatTouchInAPoint) {
  TriMesh mesh;
  addBox({0, 0, 0}, std::vector<std::uint32_t>(8, 99), mesh);
  addBox({1, 1, 1}, {7, 99, 99, 99, 99, 99, 99, 99}, mesh);
  ASSERT_GT(analyseTopology(mesh).non_manifold_vertices, 0u);
  partFans(mesh);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_EQ(analyseTopology(mesh).components, 2u);
}

}  // namespace
}  // namespace proveout
