// The tables and the vertex placement behind the surface.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <map>
#include <set>

#include "core/tool/tool.h"
#include "removal/surface/cell/cell_cycles.h"
#include "removal/surface/cell/cell_vertex.h"

namespace proveout {
namespace {

TEST(CellCycles, EveryCrossedEdgeIsInOneCycleOfAtLeastThree) {
  for (int pattern = 0; pattern < 256; ++pattern) {
    const CellCycles c = cellCycles(static_cast<CellShape>(pattern));
    std::map<int, int> size;
    for (int e = 0; e < 12; ++e) {
      const int a = edgeStartCorner(e), b = a | 1 << e / 4;
      const bool crossed = (pattern >> a & 1) != (pattern >> b & 1);
      ASSERT_EQ(crossed, c.cycle_of_edge[e] >= 0) << pattern;
      if (crossed) ++size[c.cycle_of_edge[e]];
      ASSERT_EQ(edgeAt(e / 4, a), e);
    }
    ASSERT_EQ(static_cast<int>(size.size()), c.count);
    for (const auto& [cycle, n] : size) ASSERT_GE(n, 3) << pattern;
  }
  EXPECT_EQ(cellCycles(0b10000001).count, 2);  // opposite corners of material stay apart
  EXPECT_EQ(cellCycles(0b01101001).count, 4);
}

/// The crossed edges, as sets of those of one cycle.
std::set<std::set<int>> setsOf(const CellCycles& cycles) {
  std::map<int, std::set<int>> edges;
  for (int e = 0; e < 12; ++e) {
    if (cycles.cycle_of_edge[e] >= 0) edges[cycles.cycle_of_edge[e]].insert(e);
  }
  std::set<std::set<int>> out;
  for (const auto& [cycle, set] : edges) out.insert(set);
  return out;
}

// To join all faces is to change material and void.
TEST(CellCycles, JoinedFacesCutOffTheOtherCorners) {
  int doubtful = 0;
  for (int pattern = 0; pattern < kPatterns; ++pattern) {
    const std::uint8_t faces = doubtfulFaces()[pattern];
    doubtful += std::popcount(faces);
    ASSERT_EQ(faces, doubtfulFaces()[~pattern & 0xFF]);
    ASSERT_EQ(setsOf(cellCycles(static_cast<CellShape>(pattern | faces << kJoinedFaces))),
              setsOf(cellCycles(static_cast<CellShape>(~pattern & 0xFF))));
    for (int joined = 0; joined < 64; ++joined) {
      if ((joined & ~faces) != 0) continue;
      const CellCycles some = cellCycles(static_cast<CellShape>(pattern | joined << kJoinedFaces));
      ASSERT_LE(some.count, 4);
      for (const std::set<int>& cycle : setsOf(some)) ASSERT_GE(cycle.size(), 3u);
    }
  }
  EXPECT_EQ(doubtful, 6 * 2 * 16);  // two patterns of a face, any of the four corners behind it
  // Of two material corners across one face, joined, one sheet is left, which goes around both.
  EXPECT_EQ(doubtfulFaces()[0b00001001], 1 << 4);
  EXPECT_EQ(cellCycles(0b00001001).count, 2);
  EXPECT_EQ(cellCycles(0b00001001 | 1 << (kJoinedFaces + 4)).count, 1);
}

TEST(CellVertex, LiesOnASphere) {
  const Vec3 center(-4, -5, -6);
  for (const double radius : {9.0, 9.3, 10.1}) {
    std::vector<SheetPoint> points;
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 4; ++k) {
        Vec3 p = Vec3::Zero();
        p[(axis + 1) % 3] = k & 1;
        p[(axis + 2) % 3] = k >> 1;
        const double u = p[(axis + 1) % 3] - center[(axis + 1) % 3],
                     v = p[(axis + 2) % 3] - center[(axis + 2) % 3];
        if (radius * radius < u * u + v * v) continue;
        p[axis] = center[axis] + std::sqrt(radius * radius - u * u - v * v);
        if (p[axis] < 0 || p[axis] > 1) continue;
        points.push_back({p, (p - center).normalized(), 7});
      }
    }
    ASSERT_GE(points.size(), 3u);
    EXPECT_NEAR((placeVertex(points).p - center).norm(), radius,
                2e-3);  // the chord is 0.015 to 0.03 off
  }
}

TEST(CellVertex, FindsEdgeAndCorner) {
  const std::vector<SheetPoint> edge{{{0.3, 0, 0}, {1, 0, 0}, 1},
                                     {{0.3, 0, 1}, {1, 0, 0}, 1},
                                     {{1, 0.6, 0}, {0, 1, 0}, 2},
                                     {{1, 0.6, 1}, {0, 1, 0}, 2}};
  const Vec3 e = placeVertex(edge).p;
  EXPECT_NEAR(e.x(), 0.3, 1e-12);
  EXPECT_NEAR(e.y(), 0.6, 1e-12);
  EXPECT_NEAR(e.z(), 0.5, 1e-12);
  const std::vector<SheetPoint> corner{
      {{0.3, 0, 0}, {1, 0, 0}, 1}, {{0, 0.6, 0}, {0, 1, 0}, 2}, {{0, 0, 0.2}, {0, 0, 1}, 3}};
  EXPECT_NEAR((placeVertex(corner).p - Vec3(0.3, 0.6, 0.2)).norm(), 0, 1e-12);
}

TEST(CellVertex, FollowsAFeatureEdgeOutOfTheCell) {
  // The planes x = 0.05 - 0.4 z and y = 0.3 meet in a line that leaves the cell at z = 0.125; the mean of the
  // crossings is higher.
  const Vec3 n1 = Vec3(1, 0, 0.4).normalized(), n2(0, 1, 0);
  const std::vector<SheetPoint> points{{{0.05, 0, 0}, n1, 1},
                                       {{0, 0, 0.125}, n1, 1},
                                       {{1, 0.3, 0}, n2, 2},
                                       {{1, 0.3, 1}, n2, 2},
                                       {{0, 0.3, 1}, n2, 2}};
  const CellVertex v = placeVertex(points);
  EXPECT_TRUE(v.outside);
  EXPECT_NEAR(n1.dot(v.p - Vec3(0.05, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(v.p.y(), 0.3, 1e-12);
  EXPECT_NEAR((v.p - v.inside).cwiseAbs().maxCoeff(), 0, 0.6);
  // The alternative stays in the cell and on one of the planes.
  EXPECT_GE(v.inside.minCoeff(), 0);
  EXPECT_LE(v.inside.maxCoeff(), 1);
  EXPECT_NEAR(std::min(std::abs(n1.dot(v.inside - Vec3(0.05, 0, 0))), std::abs(v.inside.y() - 0.3)), 0, 1e-9);
}

TEST(CellVertex, FindsTheTipOfACone) {
  const Vec3 tip(0.4, 0.45, 0.8);
  const double c = std::cos(degToRad(30)), s = std::sin(degToRad(30));  // normals of a cone of 60 degrees
  std::vector<SheetPoint> points;
  for (const Vec2& d : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
    const Vec2 off = d - tip.head<2>();
    const Vec2 out = off.normalized();
    points.push_back({{d.x(), d.y(), tip.z() - off.norm() * c / s}, {out.x() * c, out.y() * c, s}, 3});
  }
  EXPECT_NEAR((placeVertex(points).p - tip).norm(), 0, 1e-9);
}

TEST(CellVertex, FollowsTheCurvatureOfFacesThatMeet) {
  // A cylinder of radius 5 along z and the plane y = 0.4; the feature edge is far from the cylinder's
  // crossings.
  const Vec3 axis(-4.5, 0.4, 0);
  const auto on = [&](double y, double z) {
    const Vec3 p(axis.x() + std::sqrt(25 - (y - 0.4) * (y - 0.4)), y, z);
    return SheetPoint{p, (p - Vec3(axis.x(), axis.y(), z)).normalized(), 1};
  };
  const std::vector<SheetPoint> points{on(-0.9, 0),
                                       on(-0.9, 1),
                                       on(-0.2, 0),
                                       on(-0.2, 1),
                                       {{0, 0.4, 0}, {0, 1, 0}, 2},
                                       {{0, 0.4, 1}, {0, 1, 0}, 2}};
  const Vec3 p = placeVertex(points).p;
  EXPECT_NEAR(p.y(), 0.4, 1e-4);
  EXPECT_NEAR(p.x(), 0.5, 2e-3);  // the tangent plane at the crossings' middle is 0.09 off
}

TEST(ToolOptions, ParsesEveryShapeAndRefusesTheRest) {
  EXPECT_EQ(parseToolOption("1=ball:3.175")->type, ToolType::kBall);
  EXPECT_DOUBLE_EQ(parseToolOption("2=bull:10:2")->corner_radius, 2);
  EXPECT_DOUBLE_EQ(parseToolOption("3=cone:6:0.2:60")->cone_angle_deg, 60);
  EXPECT_DOUBLE_EQ(parseToolOption("4=drill:5")->point_angle_deg, 118);
  for (const char* bad : {"",
                          "1",
                          "1=",
                          "=flat:3",
                          "x=flat:3",
                          "1=flat",
                          "1=flat:",
                          "1=flat:0",
                          "1=flat:-3",
                          "1=flat:nan",
                          "1=flat:inf",
                          "1=flat:3:4",
                          "1=flat:3mm",
                          "1=ball:1e9",
                          "1=bull:10",
                          "1=bull:10:6",
                          "1=cone:6:6:60",
                          "1=cone:6:0:180",
                          "1=drill:5:0",
                          "1=star:3",
                          "-1=flat:3"}) {
    EXPECT_FALSE(parseToolOption(bad).ok()) << bad;
  }
}

}  // namespace
}  // namespace proveout
