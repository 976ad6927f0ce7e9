#include "core/mesh/level_cut.h"

#include <gtest/gtest.h>

#include <cmath>

namespace proveout {
namespace {

/// A square pyramid of base 4 and height 2, with a hollow square pyramid of base 2 and height 1 beside its
/// axis.
TriMesh pyramid(double half, double height, bool inwards) {
  TriMesh mesh;
  const auto h = static_cast<float>(half);
  mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}, {0, 0, static_cast<float>(height)}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  if (inwards) {
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  }
  return mesh;
}

TEST(LevelCut, PyramidWithAHollow) {
  TriMesh mesh = pyramid(2, 2, false);
  const TriMesh hollow = pyramid(1, 1, true);
  for (const auto& p : hollow.positions) mesh.positions.push_back(p + Eigen::Vector3f(0, 0, 0.25f));
  for (const auto& [a, b, c] : hollow.triangles) mesh.triangles.push_back({a + 5, b + 5, c + 5});
  const auto section = cutAtHeight(mesh, 0.75);
  ASSERT_EQ(section.size(), 2u);
  EXPECT_NEAR(areaOf(section), 2.5 * 2.5 - 1.0, 1e-6);  // sides 4 (1 - z / 2) and 2 (1 - (z - 0.25))
  EXPECT_NEAR(areaOf(cutAtHeight(mesh, 1.5)), 1.0, 1e-6);
  EXPECT_TRUE(cutAtHeight(mesh, 2.5).empty());
  EXPECT_TRUE(cutAtHeight(mesh, -0.1).empty());
  // At its base the corners count as above: nothing is below.
  EXPECT_TRUE(cutAtHeight(pyramid(2, 2, false), 0.0).empty());
}

}  // namespace
}  // namespace proveout
