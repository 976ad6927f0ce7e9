#include "core/mesh/tri_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>

namespace proveout {
namespace {

using Tri = std::array<std::uint32_t, 3>;

TriMesh box(const Vec3& lo, const Vec3& hi) {
  TriMesh m;
  for (int i = 0; i < 8; ++i) {
    m.positions.push_back(
        Vec3(i & 1 ? hi.x() : lo.x(), i & 2 ? hi.y() : lo.y(), i & 4 ? hi.z() : lo.z()).cast<float>());
  }
  m.triangles = {Tri{0, 2, 1}, Tri{1, 2, 3}, Tri{4, 5, 6}, Tri{5, 7, 6}, Tri{0, 1, 4}, Tri{1, 5, 4},
                 Tri{2, 6, 3}, Tri{3, 6, 7}, Tri{0, 4, 2}, Tri{2, 4, 6}, Tri{1, 3, 5}, Tri{3, 7, 5}};
  return m;
}

TriMesh torus(int n, int k) {
  TriMesh m;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < k; ++j) {
      const double a = 2 * kPi * i / n, b = 2 * kPi * j / k, r = 10 + 3 * std::cos(b);
      m.positions.push_back(Vec3(r * std::cos(a), r * std::sin(a), 3 * std::sin(b)).cast<float>());
      const auto at = [&](int p, int q) { return static_cast<std::uint32_t>((p % n) * k + q % k); };
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return m;
}

TriMesh soup(const TriMesh& m) {
  TriMesh s;
  for (const auto& t : m.triangles) {
    const auto n = static_cast<std::uint32_t>(s.positions.size());
    for (const auto v : t) s.positions.push_back(m.positions[v]);
    s.triangles.push_back({n, n + 1, n + 2});
  }
  return s;
}

TriMesh together(const TriMesh& a, const TriMesh& b) {
  TriMesh m = a;
  const auto n = static_cast<std::uint32_t>(a.positions.size());
  m.positions.insert(m.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles) m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return m;
}

TEST(TriMesh, BoxIsClosedWithItsVolumeAreaAndBounds) {
  const TriMesh m = box({1, 2, 3}, {4, 6, 8});
  const MeshTopology t = analyseTopology(m);
  EXPECT_TRUE(t.closedManifold());
  EXPECT_EQ(t.components, 1u);
  EXPECT_DOUBLE_EQ(meshVolume(m), 60.0);
  EXPECT_DOUBLE_EQ(meshArea(m), 2.0 * (12 + 15 + 20));
  EXPECT_EQ(meshBounds(m).max, Vec3(4, 6, 8));
}

TEST(TriMesh, VolumeHoldsFarFromTheOrigin) {
  const TriMesh m = box({1048576, -2097152, 524288}, {1048577, -2097151, 524289});
  EXPECT_DOUBLE_EQ(meshVolume(m), 1.0);
}

TEST(TriMesh, TorusVolume) {
  const TriMesh m = torus(400, 200);
  EXPECT_TRUE(analyseTopology(m).closedManifold());
  EXPECT_NEAR(meshVolume(m) / (2 * kPi * kPi * 10 * 9), 1.0, 3e-4);
  EXPECT_NEAR(meshArea(m) / (4 * kPi * kPi * 10 * 3), 1.0, 3e-4);
}

TEST(TriMesh, FindsAHole) {
  TriMesh m = box({0, 0, 0}, {2, 2, 2});
  m.triangles.erase(m.triangles.begin() + 10);  // on the face x = 2
  const MeshTopology t = analyseTopology(m);
  EXPECT_EQ(t.boundary_edges, 3u);
  EXPECT_FALSE(t.closedManifold());
  EXPECT_DOUBLE_EQ(t.first_defect.x(), 2.0);
}

TEST(TriMesh, FindsAFlippedTriangle) {
  TriMesh m = box({0, 0, 0}, {1, 1, 1});
  std::swap(m.triangles[3][0], m.triangles[3][1]);
  const MeshTopology t = analyseTopology(m);
  EXPECT_EQ(t.misoriented_edges, 3u);
  EXPECT_EQ(t.boundary_edges + t.non_manifold_edges + t.non_manifold_vertices, 0u);
}

TEST(TriMesh, FindsAnEdgeOfFour) {
  // Two boxes that share the edge x = 1, y = 1 once welded.
  const TriMesh m = weldVertices(together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})));
  const MeshTopology t = analyseTopology(m);
  EXPECT_EQ(t.non_manifold_edges, 1u);
  EXPECT_EQ(t.boundary_edges, 0u);
  EXPECT_LT((t.first_defect - Vec3(1, 1, 0.5)).norm(), 1e-9);
}

TEST(TriMesh, FindsATouchingCorner) {
  const TriMesh m = weldVertices(together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})));
  const MeshTopology t = analyseTopology(m);
  EXPECT_EQ(t.non_manifold_vertices, 1u);
  EXPECT_EQ(t.components, 2u);
  EXPECT_EQ(t.first_defect, Vec3(1, 1, 1));
}

TEST(TriMesh, FindsBadTrianglesAndPositions) {
  TriMesh m = box({0, 0, 0}, {1, 1, 1});
  m.triangles.push_back({3, 3, 5});
  m.triangles.push_back({3, 4, 99});
  m.positions.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 7});
  const MeshTopology t = analyseTopology(m);
  EXPECT_EQ(t.degenerate_triangles, 2u);
  EXPECT_EQ(t.non_finite_positions, 1u);
  EXPECT_TRUE(t.first_defect.allFinite());
  EXPECT_DOUBLE_EQ(meshVolume(m), 1.0);
  EXPECT_DOUBLE_EQ(meshArea(m), 6.0);
}

TEST(TriMesh, EmptyMeshIsNothing) {
  EXPECT_EQ(analyseTopology({}).components, 0u);
  EXPECT_EQ(meshVolume({}), 0.0);
  EXPECT_TRUE(meshBounds({}).empty());
  EXPECT_TRUE(weldVertices({}).triangles.empty());
}

TEST(TriMesh, NumbersComponentsByFirstTriangle) {
  const TriMesh two = together(box({0, 0, 0}, {1, 1, 1}), box({3, 0, 0}, {4, 1, 1}));
  std::uint32_t count = 0;
  const auto component = meshComponents(two, count);
  ASSERT_EQ(count, 2u);
  for (std::size_t t = 0; t < component.size(); ++t) EXPECT_EQ(component[t], t < 12 ? 0u : 1u);
}

TEST(TriMesh, WeldingClosesASoup) {
  const TriMesh m = torus(40, 20);
  TriMesh s = soup(m);
  s.motion.resize(s.triangles.size());
  for (std::uint32_t t = 0; t < s.motion.size(); ++t) s.motion[t] = t;
  s.positions.push_back({-0.0f, 0, 1});
  s.positions.push_back({0.0f, -0.0f, 1});
  s.positions.push_back({5, 5, 5});
  const auto n = static_cast<std::uint32_t>(s.positions.size());
  s.triangles.insert(s.triangles.begin(), {n - 3, n - 2, n - 1});  // collapses
  s.motion.insert(s.motion.begin(), 7777);
  s.triangles.push_back({0, n + 5, n + 9});
  s.motion.push_back(8888);
  const TriMesh w = weldVertices(s);
  EXPECT_EQ(w.positions.size(), m.positions.size() + 2);
  EXPECT_EQ(w.triangles.size(), m.triangles.size() + 1);
  EXPECT_EQ(w.motion.front(), 0u);
  EXPECT_EQ(w.motion.back(), 8888u);
  EXPECT_EQ(analyseTopology(w).degenerate_triangles, 1u);
  EXPECT_EQ(analyseTopology(w).boundary_edges, 0u);
  EXPECT_EQ(analyseTopology(w).components, 2u);  // the bad triangle counts as one
}

TEST(TriMesh, HalfAMillionTrianglesTakeAMoment) {
  const TriMesh m = torus(700, 400);
  const std::clock_t begin = std::clock();  // of the processor: a busy machine does not add to it
  EXPECT_TRUE(analyseTopology(m).closedManifold());
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LT(seconds, 5.0);  // 0.1 s when optimised; the bound is for sanitizers
}

/// What analyseTopology says, by definition and by brute force.
struct Reference {
  bool closed = true;
  std::vector<std::uint32_t> component;
};

/// Joins numbers that `linked` links, by relaxing until nothing changes; returns the smallest of each set.
template <typename Linked>
std::vector<std::uint32_t> smallestReachable(std::size_t n, const Linked& linked) {
  std::vector<std::uint32_t> least(n);
  for (std::uint32_t i = 0; i < n; ++i) least[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        if (least[j] < least[i] && linked(i, j)) least[i] = least[j], changed = true;
      }
    }
  }
  return least;
}

bool hasVertex(const Tri& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

int sharedVertices(const Tri& a, const Tri& b) {
  return hasVertex(b, a[0]) + hasVertex(b, a[1]) + hasVertex(b, a[2]);
}

Reference reference(const TriMesh& m) {
  Reference r;
  const auto n = static_cast<std::uint32_t>(m.positions.size());
  std::vector<int> directed(n * n, 0);
  for (const Tri& t : m.triangles) {
    for (int c = 0; c < 3; ++c) ++directed[t[c] * n + t[(c + 1) % 3]];
  }
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = 0; b < n; ++b) {
      if (directed[a * n + b] > 1 || directed[a * n + b] != directed[b * n + a]) r.closed = false;
    }
  }
  const auto sharesEdge = [&](std::uint32_t i, std::uint32_t j) {
    return sharedVertices(m.triangles[i], m.triangles[j]) >= 2;
  };
  for (std::uint32_t v = 0; v < n && r.closed; ++v) {
    std::vector<Tri> fan;
    for (const Tri& t : m.triangles) {
      if (hasVertex(t, v)) fan.push_back(t);
    }
    const auto one = smallestReachable(fan.size(), [&](std::uint32_t i, std::uint32_t j) {
      for (std::uint32_t w = 0; w < n; ++w) {
        if (w != v && hasVertex(fan[i], w) && hasVertex(fan[j], w)) return true;
      }
      return false;
    });
    for (const std::uint32_t least : one) r.closed = r.closed && least == 0;
  }
  std::vector<std::uint32_t> number(m.triangles.size());
  std::uint32_t count = 0;
  const auto least = smallestReachable(m.triangles.size(), sharesEdge);
  for (std::uint32_t t = 0; t < least.size(); ++t) {
    number[t] = least[t] == t ? count++ : number[least[t]];
  }
  r.component = number;
  return r;
}

/// Two closed pieces with a random defect, or none: vertices merged, a triangle turned, dropped or doubled.
TriMesh damaged(std::mt19937& random) {
  TriMesh m = together(box({0, 0, 0}, {1, 1, 1}), torus(3, 3));
  std::shuffle(m.triangles.begin(), m.triangles.end(), random);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  const std::uint32_t kind = below(6), t = below(m.triangles.size());
  if (kind == 0) std::swap(m.triangles[t][0], m.triangles[t][1]);
  if (kind == 1) m.triangles.erase(m.triangles.begin() + t);
  if (kind == 2) m.triangles.push_back(m.triangles[t]);
  if (kind == 3) m.triangles.push_back({m.triangles[t][0], m.triangles[t][2], m.triangles[t][1]});
  if (kind == 4) {
    const std::uint32_t a = below(8), b = 8 + below(9);  // a box corner becomes a corner of the torus
    for (Tri& triangle : m.triangles) std::ranges::replace(triangle, a, b);
  }
  return m;
}

TEST(TriMesh, TopologyMatchesTheDefinitionOnDamagedMeshes) {
  std::mt19937 random(11);
  int closed = 0;
  for (int i = 0; i < 300; ++i) {
    const TriMesh m = damaged(random);
    const Reference expected = reference(m);
    closed += expected.closed;
    const MeshTopology topology = analyseTopology(m);
    ASSERT_EQ(topology.closedManifold(), expected.closed) << "round " << i;
    std::uint32_t count = 0;
    ASSERT_EQ(meshComponents(m, count), expected.component) << "round " << i;
    ASSERT_EQ(topology.components, count) << "round " << i;
  }
  EXPECT_GT(closed, 20);
  EXPECT_LT(closed, 150);
}

TEST(TriMesh, WideFansAreClosed) {
  for (const std::uint32_t n : {3u, 16u, 17u, 500u}) {  // two cones, base to base
    TriMesh m;
    m.positions = {{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = 2 * kPi * i / n;
      m.positions.push_back(Vec3(std::cos(a), std::sin(a), 0).cast<float>());
      const std::uint32_t p = 2 + i, q = 2 + (i + 1) % n;
      m.triangles.push_back({0, p, q});
      m.triangles.push_back({1, q, p});
    }
    EXPECT_TRUE(analyseTopology(m).closedManifold()) << n;
    EXPECT_EQ(analyseTopology(m).components, 1u) << n;
    std::swap(m.triangles[n][1], m.triangles[n][2]);
    EXPECT_EQ(analyseTopology(m).misoriented_edges, 3u) << n;
  }
}

}  // namespace
}  // namespace proveout
