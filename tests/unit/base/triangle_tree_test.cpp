#include "core/mesh/triangle_tree.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/geometry/to_float.h"

namespace proveout {
namespace {

/// Triangles of all sizes at random, some of them flat or equal.
SurfaceMesh randomSoup(int triangles, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&](double reach) {
    return Vec3(reach * Vec3(unit(random), unit(random), unit(random)));
  };
  SurfaceMesh mesh;
  for (int t = 0; t < triangles; ++t) {
    const Vec3 at = point(50.0);
    const double size = std::pow(10.0, 2.0 * unit(random) - 1.0);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(at);
    mesh.points.push_back(at + point(size));
    mesh.points.push_back(t % 17 == 0 ? at : Vec3(at + point(size)));  // no extent
    mesh.triangles.push_back({first, first + 1, first + 2});
    if (t % 23 == 0) mesh.triangles.push_back(mesh.triangles.back());  // twice
  }
  return mesh;
}

TriangleTree::Nearest bruteForce(const SurfaceMesh& mesh, const Vec3& p) {
  TriangleTree::Nearest best;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const TrianglePoint at = nearestOfTriangle(p, mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
    const double squared = (at.point - p).squaredNorm();
    if (squared < best.squared) best = {squared, t, at.part, at.point};
  }
  return best;
}

/// With points as files bring them: the tree keeps the corners of such a mesh itself.
SurfaceMesh inSinglePrecision(SurfaceMesh mesh) {
  for (Vec3& p : mesh.points) p = toFloat(p).cast<double>();
  return mesh;
}

void expectNearest(const SurfaceMesh& mesh) {
  const TriangleTree tree(mesh);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-80.0, 80.0);
  for (int i = 0; i < 600; ++i) {
    const Vec3 p = i % 5 == 0 ? mesh.points[random() % mesh.points.size()]
                              : Vec3(unit(random), unit(random), unit(random));
    const TriangleTree::Nearest expected = bruteForce(mesh, p);
    for (const std::uint32_t hint :
         {TriangleTree::kNone, static_cast<std::uint32_t>(random() % mesh.triangles.size())}) {
      const TriangleTree::Nearest found = tree.nearest(p, hint);
      ASSERT_EQ(found.triangle, expected.triangle) << i;
      ASSERT_EQ(found.squared, expected.squared);
      ASSERT_EQ(found.part, expected.part);
    }
    const double distance = std::sqrt(expected.squared);
    if (distance < 1e-3) continue;
    EXPECT_EQ(tree.nearest(p, TriangleTree::kNone, 0.999 * distance).triangle, TriangleTree::kNone);
    EXPECT_EQ(tree.nearest(p, TriangleTree::kNone, 1.001 * distance).triangle, expected.triangle);
  }
}

TEST(TriangleTree, FindsTheNearestPointWithAnyHint) {
  expectNearest(randomSoup(3000, 5));
  expectNearest(inSinglePrecision(randomSoup(3000, 5)));
}

TEST(BoxTree, ShortBoxesHoldTheBoxesThatTheyStandFor) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1e3, 1e3);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 p(unit(random), unit(random), unit(random));
    const ShortBox box = ShortBox::around({p, p});
    EXPECT_TRUE((box.min.cast<double>().array() <= p.array()).all() &&
                (box.max.cast<double>().array() >= p.array()).all());
    const Vec3 low = box.min.cast<double>();  // single precision holds it: nothing is rounded
    EXPECT_EQ(ShortBox::around({low, low}).max.cast<double>(), low);
  }
}

TEST(TriangleTree, VisitsWhatTouchesABox) {
  const SurfaceMesh mesh = randomSoup(2000, 8);
  const TriangleTree tree(mesh);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-50.0, 50.0);
  for (int i = 0; i < 50; ++i) {
    const Vec3 at(unit(random), unit(random), unit(random));
    const Box3 box{at, at + Vec3::Constant(0.2 * std::abs(unit(random)))};
    std::multiset<std::uint32_t> expected, found;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      Box3 own;
      for (const auto v : mesh.triangles[t]) own.extend(mesh.points[v]);
      if (own.overlaps(box)) expected.insert(t);
    }
    tree.forEachIn(box, [&](std::uint32_t t) { found.insert(t); });
    EXPECT_EQ(found, expected);
  }
}

/// A torus as quads in two triangles.
SurfaceMesh torus(double major, double minor, int rings, int sides) {
  SurfaceMesh mesh;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const double a = 2 * kPi * i / rings, b = 2 * kPi * j / sides, r = major + minor * std::cos(b);
      mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i % rings * sides + j % sides); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(TriangleTree, WindsOnceRoundWhatIsInside) {
  constexpr double kMajor = 20.0, kMinor = 6.0;
  const SurfaceMesh mesh = torus(kMajor, kMinor, 160, 60);
  const TriangleTree tree(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-30.0, 30.0);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(unit(random), unit(random), 0.3 * unit(random));
    const double off = std::hypot(std::hypot(p.x(), p.y()) - kMajor, p.z()) - kMinor;
    if (std::abs(off) < 0.05) continue;  // chords
    EXPECT_NEAR(tree.windingNumber(p), off < 0.0 ? 1.0 : 0.0, 0.1) << p.transpose();
  }
}

TEST(TriangleTree, CrossingsOfARayAreTheWindingNumber) {
  // Two tori one in the other, the inner one's facets as they are: there it goes round twice.
  SurfaceMesh mesh = torus(20.0, 6.0, 90, 30);
  const SurfaceMesh inner = torus(20.0, 3.0, 90, 30);
  const auto shift = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& t : inner.triangles) mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const TriangleTree tree(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-30.0, 30.0);
  std::array<int, 3> seen{};
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(unit(random), unit(random), 0.3 * unit(random));
    const double off = std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z());
    if (std::abs(off - 6.0) < 0.05 || std::abs(off - 3.0) < 0.05) continue;  // chords
    const int rounds = (off < 6.0) + (off < 3.0);
    const std::optional<int> crossings = tree.crossings(p);
    ASSERT_TRUE(crossings) << p.transpose();
    EXPECT_EQ(*crossings, rounds) << p.transpose();
    ++seen[static_cast<std::size_t>(rounds)];
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(TriangleTree, ARayThroughAnEdgeOrACornerSaysNothingWrong) {
  // Points from which the first ray, or all, meet corners and edges of a box.
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1 ? 3 : -3, i & 2 ? 4 : -4, i & 4 ? 5 : -5);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const TriangleTree tree(mesh);
  const Vec3 ray(0.2718, 0.3142, 0.9097);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int told = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto& t = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
    const double share = i % 3 == 0 ? 0.0 : unit(random);
    const Vec3 target = (1.0 - share) * mesh.points[t[0]] + share * mesh.points[t[1]],
               p = target - 8.0 * unit(random) * ray;
    const bool inside = std::abs(p.x()) < 3 && std::abs(p.y()) < 4 && std::abs(p.z()) < 5;
    const Vec3 gap(3 - std::abs(p.x()), 4 - std::abs(p.y()), 5 - std::abs(p.z()));
    if (gap.cwiseAbs().minCoeff() < 1e-6) continue;  // on it
    const std::optional<int> crossings = tree.crossings(p);
    if (!crossings) continue;
    ++told;
    EXPECT_EQ(*crossings, inside ? 1 : 0) << p.transpose();
  }
  EXPECT_GT(told, 3000);
}

TEST(TriangleTree, HoldsOneTriangleAndMany) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_DOUBLE_EQ(TriangleTree(mesh).nearest({0.2, 0.2, 3.0}).squared, 9.0);
  // All at one place: the tree has nothing to halve them by.
  mesh.triangles.assign(5000, {0, 1, 2});
  EXPECT_EQ(TriangleTree(mesh).nearest({0.2, 0.2, 3.0}).triangle, 0u);
}

}  // namespace
}  // namespace proveout
