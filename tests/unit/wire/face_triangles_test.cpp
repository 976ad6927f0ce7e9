// Faces with hollows: as many triangles as there must be, that cover the face once.
#include "removal/wire/section/face_triangles.h"

#include <gtest/gtest.h>

#include "core/geometry/ears.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

void expectCovered(const Loops& loops) {
  std::vector<Vec2> points;
  double area2 = 0.0, covered2 = 0.0;
  for (const auto& loop : loops) {
    points.insert(points.end(), loop.begin(), loop.end());
    area2 += signedArea2(loop);
  }
  const auto triangles = faceTriangles(loops);
  EXPECT_EQ(triangles.size(), points.size() + 2 * loops.size() - 4);
  for (const auto& [a, b, c] : triangles) {
    const double twice = cross2(points[b] - points[a], points[c] - points[a]);
    EXPECT_GE(twice, 0.0);
    covered2 += twice;
  }
  EXPECT_NEAR(covered2, area2, 1e-9 * area2);
}

std::vector<Vec2> polygon(const Vec2& center, double radius, int count, bool hollow) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.push_back(center + turnedBy({radius, 0}, (hollow ? -2.0 : 2.0) * kPi * i / count));
  return points;
}

TEST(FaceTriangles, ConvexAndStar) {
  expectCovered({polygon({1, 2}, 3, 3, false)});
  expectCovered({polygon({1, 2}, 3, 100, false)});
  std::vector<Vec2> star;
  for (int i = 0; i < 60; ++i) star.push_back(turnedBy({i % 2 == 0 ? 5.0 : 2.0, 0}, 2 * kPi * i / 60));
  expectCovered({star});
}

TEST(FaceTriangles, ManyHollows) {
  Loops loops = {{{0, 0}, {40, 0}, {40, 40}, {0, 40}}};
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 10; ++k) loops.push_back(polygon({2 + 4.0 * i, 2 + 4.0 * k}, 1.5, 24, true));
  }
  expectCovered(loops);
}

TEST(FaceTriangles, PointsOnStraightSides) {
  std::vector<Vec2> square;
  for (int i = 0; i < 10; ++i) square.emplace_back(i, 0);
  for (int i = 0; i < 10; ++i) square.emplace_back(10, i);
  for (int i = 0; i < 10; ++i) square.emplace_back(10 - i, 10);
  for (int i = 0; i < 10; ++i) square.emplace_back(0, 10 - i);
  expectCovered({square});
  expectCovered({square, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}});
}

}  // namespace
}  // namespace proveout
