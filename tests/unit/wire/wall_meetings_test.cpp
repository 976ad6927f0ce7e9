// Meshes of wire cuts that run through themselves are told, sound ones are not.
#include "removal/wire/lean/wall_meetings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/shells.h"
#include "removal/wire/section/prism_mesh.h"
#include "removal/wire/section/segment_meetings.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

PlaneBody square(const Vec2& at, double half) {
  return {{rectangleLoop(at - Vec2(half, half), at + Vec2(half, half))}, 4.0 * half * half};
}

/// A square post whose upper face is somewhere else.
TriMesh leaningPost(const Vec2& low, const Vec2& high) {
  TriMesh mesh = prismMesh({square({0, 0}, 1.0)}, 0.0, 20.0, 1e-3);
  for (Eigen::Vector3f& p : mesh.positions) p.head<2>() += (p.z() == 0.0f ? low : high).cast<float>();
  return mesh;
}

TriMesh both(TriMesh a, const TriMesh& b) {
  append(a, b);
  return a;
}

TEST(WallMeetings, PostsBesideEachOther) {
  EXPECT_EQ(wallMeetings(prismMesh({square({0, 0}, 1), square({3, 0}, 1)}, 0, 5, 1e-3)).size(), 0u);
  EXPECT_EQ(wallMeetings(both(leaningPost({0, 0}, {4, 0}), leaningPost({3, 0}, {7, 0}))).size(), 0u);
}

TEST(WallMeetings, UprightPostsThatOverlapCrossTwice) {
  EXPECT_EQ(wallMeetings(prismMesh({square({0, 0}, 1), square({1, 1.5}, 1)}, 0, 5, 1e-3)).size(), 2u);
}

TEST(WallMeetings, PostsThatTouchInACorner) {
  const auto post = [](const Vec2& at) { return prismMesh({square(at, 1)}, 0, 5, 1e-3); };
  EXPECT_GT(wallMeetings(both(post({0, 0}), post({2, 2}))).size(), 0u);
}

TEST(PrismMesh, CornersThatTouchStandBack) {
  const TriMesh mesh = prismMesh({square({0, 0}, 1), square({2, 2}, 1)}, 0, 5, 1e-3);
  EXPECT_EQ(wallMeetings(mesh).size(), 0u);
  int near = 0;
  for (const Eigen::Vector3f& p : mesh.positions) {
    const double off = (p.head<2>().cast<double>() - Vec2(1, 1)).norm();
    near += off > 0.0 && off < 1e-4 ? 1 : 0;
  }
  EXPECT_EQ(near, 4);  // both corners, below and above
}

TEST(PrismMesh, ChordsBesideACornerAreShorter) {
  // A post in a round hole, with corners between the hole's arc and its chords.
  const double radius = 10.0, chord = 0.02;
  const PlaneBody plate{{rectangleLoop({-20, -20}, {20, 20}), circleLoop({0, 0}, radius, true)}, 1.0};
  const PlaneBody post = square({0, 0}, (radius - 0.2 * chord) / std::sqrt(2.0));
  EXPECT_GT(wallMeetings(both(prismMesh({plate}, 0, 5, chord), prismMesh({post}, 0, 5, chord))).size(), 0u);
  EXPECT_EQ(wallMeetings(prismMesh({plate, post}, 0, 5, chord)).size(), 0u);
}

TEST(WallMeetings, LeaningPostsThatCrossHalfWayUp) {
  EXPECT_GT(wallMeetings(both(leaningPost({0, 0}, {4, 0}), leaningPost({4, 0.5}, {0, 0.5}))).size(), 0u);
}

TEST(WallMeetings, AFaceThatIsTurnedOver) {
  TriMesh mesh = prismMesh({square({0, 0}, 1)}, 0, 5, 1e-3);
  std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
  EXPECT_EQ(wallMeetings(mesh).size(), 1u);
}

TEST(SegmentMeetings, CrossingTouchingAndFolded) {
  // A chain of corners by number, and an edge of its own.
  const auto chain = [](const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p, const Vec2& q) {
    return meetingSegments({{a, b, 0, 1}, {b, c, 1, 2}, {p, q, 3, 4}}).size();
  };
  EXPECT_EQ(chain({0, 0}, {4, 0}, {4, 4}, {1, 1}, {3, 1}), 0u);
  EXPECT_EQ(chain({0, 0}, {4, 0}, {4, 4}, {1, 1}, {3, -1}), 1u);   // crosses one
  EXPECT_EQ(chain({0, 0}, {4, 0}, {4, 4}, {1, 1}, {3, 0}), 1u);    // ends on one
  EXPECT_EQ(chain({0, 0}, {4, 0}, {4, 4}, {5, 1}, {4, 0}), 2u);    // at a corner, but not joined
  EXPECT_EQ(chain({0, 0}, {4, 0}, {1, 0}, {1, 1}, {3, 1}), 1u);    // goes back on itself
  EXPECT_EQ(chain({0, 0}, {4, 0}, {9, 0}, {10, 0}, {12, 0}), 0u);  // all on one line
}

}  // namespace
}  // namespace proveout
