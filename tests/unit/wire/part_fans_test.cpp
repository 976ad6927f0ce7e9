#include "removal/wire/lean/part_fans.h"

#include <gtest/gtest.h>

#include "removal/wire/lean/wall_meetings.h"

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
  EXPECT_EQ(wallMeetings(mesh).size(), 0u);
  EXPECT_NEAR(meshVolume(mesh), 2.0, 5e-5);
}

/// A wedge with its edge at corners `edge` (below, above), if it is there, between two directions.
void addWedge(const std::array<std::uint32_t, 2>& edge, float from, float to, TriMesh& mesh) {
  const Eigen::Vector3f tip(20.0f, 20.0f, 0.0f);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const float slope : {from, to}) {
    for (const float z : {0.0f, 1.0f})
      mesh.positions.emplace_back(tip + Eigen::Vector3f(10.0f, slope * 10.0f, z));
  }
  const std::uint32_t a = edge[0], b = first, c = first + 2, above_a = edge[1], above_b = b + 1,
                      above_c = c + 1;
  mesh.triangles.insert(mesh.triangles.end(), {{a, c, b},
                                               {above_a, above_b, above_c},
                                               {a, b, above_b},
                                               {a, above_b, above_a},
                                               {b, c, above_c},
                                               {b, above_c, above_b},
                                               {c, a, above_a},
                                               {c, above_a, above_c}});
}

/// Both go away from their common edge in as good as one direction: what stands back along it stays in one
/// place.
TEST(PartFans, WedgesBesideEachOther) {
  TriMesh mesh;
  mesh.positions = {{20.0f, 20.0f, 0.0f}, {20.0f, 20.0f, 1.0f}};
  addWedge({0, 1}, 0.0f, 0.02f, mesh);
  addWedge({0, 1}, -0.04f, -0.02f, mesh);
  partFans(mesh);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
  EXPECT_EQ(analyseTopology(mesh).components, 2u);
  EXPECT_EQ(wallMeetings(mesh).size(), 0u);
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
