// Whether triangles meet, without rounding.
#include "core/mesh/exact_meeting.h"

#include <gtest/gtest.h>

#include "core/mesh/intersections.h"

namespace proveout {
namespace {

using Corners = std::vector<Eigen::Vector3f>;

/// Two triangles by the numbers of their corners.
TriMesh pairOf(const Corners& corners, const std::array<std::uint32_t, 3>& a,
               const std::array<std::uint32_t, 3>& b) {
  TriMesh mesh;
  mesh.positions = corners;
  mesh.triangles = {a, b};
  return mesh;
}

/// Of walls that a wire left: in doubles they touch, in truth they are less than a step of them apart.
TEST(ExactMeeting, WallsThatAreApartByLessThanRounding) {
  const TriMesh leaning = pairOf({{-2.26467395f, 9.87932873f, 32.8861504f},
                                  {-2.08621407f, 9.07317162f, 43.8482018f},
                                  {-2.08622003f, 9.07317066f, 43.8482018f},
                                  {-2.26193905f, 9.87975121f, 32.8861504f},
                                  {-2.08619595f, 9.07317448f, 43.8482018f},
                                  {-2.08620811f, 9.07317257f, 43.8482018f}},
                                 {0, 1, 2}, {3, 4, 5});
  const TriMesh upright = pairOf({{-14.4212999f, 48.0004005f, 10.2177849f},
                                  {-14.4212999f, -22.5506477f, 10.2182598f},
                                  {-14.4212999f, -22.5468731f, 10.2182598f},
                                  {-14.4212694f, -22.5485382f, 10.2182598f},
                                  {-14.4212999f, -22.5506477f, 10.2177849f},
                                  {-14.4212694f, -22.5485382f, 10.2177849f}},
                                 {0, 1, 2}, {3, 4, 5});
  for (const TriMesh& mesh : {leaning, upright}) {
    EXPECT_TRUE(trianglesMeet(mesh, 0, 1));
    EXPECT_FALSE(meetExactly(mesh, 0, 1));
  }
}

TEST(ExactMeeting, TouchingInAPoint) {
  const Corners floor{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto above = [&](float z) {
    Corners corners = floor;
    corners.insert(corners.end(), {{0.25f, 0.25f, z}, {0.25f, 0.25f, 1}, {0.5f, 0.25f, 1}});
    return pairOf(corners, {0, 1, 2}, {3, 4, 5});
  };
  EXPECT_TRUE(meetExactly(above(-0.5f), 0, 1));
  EXPECT_TRUE(meetExactly(above(0.0f), 0, 1));
  EXPECT_FALSE(meetExactly(above(1e-30f), 0, 1));
}

TEST(ExactMeeting, InOnePlane) {
  Corners corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {5, 1, 0}, {1, 5, 0}, {5, 5, 0}, {9, 5, 0}};
  EXPECT_TRUE(meetExactly(pairOf(corners, {0, 1, 2}, {3, 4, 5}), 0, 1));
  EXPECT_FALSE(meetExactly(pairOf(corners, {0, 1, 2}, {4, 6, 7}), 0, 1));
}

TEST(ExactMeeting, CommonCorners) {
  const Corners corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0},  {-1, 3, 1},
                        {3, 3, 0}, {1, 1, 0}, {2, 2, -1}, {2, 1, 1}};
  EXPECT_FALSE(meetExactly(pairOf(corners, {0, 1, 2}, {2, 1, 4}), 0, 1));  // side by side
  EXPECT_TRUE(meetExactly(pairOf(corners, {0, 1, 2}, {1, 2, 5}), 0, 1));   // folded onto each other
  EXPECT_FALSE(meetExactly(pairOf(corners, {0, 1, 2}, {2, 3, 4}), 0, 1));  // at one corner
  EXPECT_TRUE(meetExactly(pairOf(corners, {0, 1, 2}, {0, 6, 7}), 0, 1));   // and through each other
  EXPECT_TRUE(meetExactly(pairOf(corners, {0, 1, 2}, {0, 1, 2}), 0, 1));
}

TEST(ExactMeeting, LinesAreFlat) {
  const Corners corners{{0.1f, 0.2f, 0.3f}, {0.2f, 0.4f, 0.6f}, {0.3f, 0.6f, 0.9f}, {0.4f, 0.8f, 1.2f}};
  // 0.3f and 0.9f are no multiples of 0.1f: only the doubled point is on the line.
  EXPECT_TRUE(isFlat(pairOf({{0, 0, 0}, corners[0], corners[1]}, {0, 1, 2}, {0, 1, 2}), 0));
  EXPECT_TRUE(isFlat(pairOf(corners, {0, 0, 3}, {0, 1, 2}), 0));
  EXPECT_FALSE(isFlat(pairOf({{0, 0, 0}, {1, 1, 1}, {1, 1, 1.0000001f}}, {0, 1, 2}, {0, 1, 2}), 0));
}

TEST(ExactMeeting, SeenFromAbove) {
  const TriMesh mesh = pairOf({{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {2, 2, 1}, {1, 1, 9}}, {0, 1, 2}, {0, 4, 3});
  EXPECT_EQ(turnFromAbove(mesh, 0), 1);
  EXPECT_EQ(turnFromAbove(mesh, 1), 0);
}

}  // namespace
}  // namespace proveout
