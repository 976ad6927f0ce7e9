// Meshes of several bodies: taken apart, joined, or refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/shells.h"
#include "removal/compare/compare.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using shapes::box;
using shapes::together;
using testing::HasSubstr;

/// Each as files bring it: triangles without common vertices.
TriMesh soup(const TriMesh& m) {
  TriMesh s;
  for (const auto& t : m.triangles) {
    const auto n = static_cast<std::uint32_t>(s.positions.size());
    for (const auto v : t) s.positions.push_back(m.positions[v]);
    s.triangles.push_back({n, n + 1, n + 2});
  }
  return s;
}

PreparedMesh prepared(const TriMesh& mesh) {
  auto r = prepareNominal(soup(mesh), "part.stl");
  EXPECT_TRUE(r.ok()) << r.error().message;
  if (!r) return {};
  EXPECT_TRUE(analyseTopology(r->mesh).closedManifold());
  return std::move(r).value();
}

/// No excess where bodies meet, and none of the outside is lost.
void expectEqualTo(const TriMesh& bodies, const TriMesh& whole) {
  const PreparedMesh p = prepared(bodies);
  EXPECT_NEAR(meshVolume(p.mesh), meshVolume(whole), 1e-4 * meshVolume(whole));
  Progress progress;
  const auto c = compareToNominal(prepared(whole).mesh, p.mesh, {.resolution_mm = 0.5}, progress);
  ASSERT_TRUE(c.ok()) << c.error().message;
  EXPECT_TRUE(c->pass());
  EXPECT_LT(c->max_excess_mm, 1e-3);
  EXPECT_LT(c->max_gouge_mm, 1e-3);
}

/// The same, but for `mm` on either side.
void expectWithin(const TriMesh& bodies, const TriMesh& whole, double mm) {
  const PreparedMesh p = prepared(bodies);
  EXPECT_LE(std::abs(meshVolume(p.mesh) - meshVolume(whole)), 2.0 * mm * meshArea(whole));
  Progress progress;
  const auto c = compareToNominal(prepared(whole).mesh, p.mesh, {.resolution_mm = 0.5}, progress);
  ASSERT_TRUE(c.ok()) << c.error().message;
  EXPECT_LT(c->max_excess_mm, 2.0 * mm + 1e-3);
  EXPECT_LT(c->max_gouge_mm, 2.0 * mm + 1e-3);
}

TEST(Bodies, ShellsComeApartAtCommonFacesEdgesAndVertices) {
  const TriMesh a = box({0, 0, 0}, {10, 10, 10});
  for (const TriMesh& other : {box({10, 2, 2}, {15, 8, 8}), box({10, 10, 0}, {15, 15, 10}),
                               box({10, 10, 10}, {15, 15, 15}), box({20, 0, 0}, {25, 5, 5})}) {
    const Shells shells = splitShells(weldVertices(soup(together(a, other))));
    ASSERT_EQ(shells.count, 2u);
    EXPECT_TRUE(analyseTopology(shells.mesh).closedManifold());
    EXPECT_NEAR(meshVolume(shellMeshes(shells)[0]), 1000.0, 1e-3);
    EXPECT_NEAR(meshVolume(shellMeshes(shells)[1]), meshVolume(other), 1e-3);
  }
}

TEST(Bodies, FaceToFaceIsJoined) {
  expectEqualTo(together(box({0, 0, 0}, {20, 20, 20}), box({20, 0, 0}, {40, 20, 20})),
                box({0, 0, 0}, {40, 20, 20}));
  // A smaller face on a larger one, and a third body on both.
  const auto step = [](int i, int j, int) { return i == 0 || j == 0; };
  expectEqualTo(together(box({0, 0, 0}, {20, 20, 10}), box({20, 0, 0}, {40, 8, 10})),
                shapes::blocks({0, 20, 40}, {0, 8, 20}, {0, 10}, step));
  EXPECT_THAT(prepared(together(box({0, 0, 0}, {20, 20, 20}), box({20, 0, 0}, {40, 20, 10}))).notes,
              testing::ElementsAre(HasSubstr("2 bodies that touch or overlap were joined")));
}

TEST(Bodies, OverlapsAreJoinedInChains) {
  TriMesh chain = box({0, 0, 0}, {10, 10, 10});
  for (int i = 1; i < 6; ++i) chain = together(chain, box({8.0 * i, 0, 0}, {8.0 * i + 10, 10, 10}));
  expectEqualTo(chain, box({0, 0, 0}, {50, 10, 10}));
  EXPECT_THAT(prepared(chain).notes, testing::ElementsAre(HasSubstr("6 bodies")));
  // A pin through a plate.
  const auto cross = [](int i, int j, int k) { return k == 1 || (i == 1 && j == 1); };
  expectEqualTo(together(box({0, 0, 0}, {30, 30, 5}), box({10, 10, -8}, {20, 20, 12})),
                shapes::blocks({0, 10, 20, 30}, {0, 10, 20, 30}, {-8, 0, 5, 12}, cross));
}

/// The triangle beside the first edge of the first one in two, and one without area between them.
TriMesh withFlatTriangle(TriMesh mesh) {
  const auto [u, v, w] = mesh.triangles[0];
  const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(0.5f * (mesh.positions[u] + mesh.positions[v]));
  for (std::size_t t = 1; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.triangles[t][i] != v || mesh.triangles[t][(i + 1) % 3] != u) continue;
      const std::uint32_t x = mesh.triangles[t][(i + 2) % 3];
      mesh.triangles[t] = {v, middle, x};
      mesh.triangles.push_back({middle, u, x});
      mesh.triangles.push_back({v, u, middle});
      return mesh;
    }
  }
  ADD_FAILURE() << "the mesh is open";
  return mesh;
}

TEST(Bodies, TrianglesWithoutAreaAreNoObstacle) {
  const TriMesh a = withFlatTriangle(box({0, 0, 0}, {20, 20, 20})),
                b = withFlatTriangle(box({10, 0, 0}, {40, 20, 20}));
  for (const TriMesh& other : {b, box({10, 0, 0}, {40, 20, 20})}) {
    const auto both = prepareNominal(together(a, other), "part.stl");
    ASSERT_TRUE(both.ok()) << both.error().message;
    EXPECT_NEAR(meshVolume(both->mesh), 16000.0, 1e-2);
  }
  EXPECT_NEAR(meshVolume(prepared(together(a, box({30, 0, 0}, {40, 20, 20}))).mesh), 12000.0, 1e-2);
}

/// Of faces with four corners each.
TriMesh ofQuads(std::vector<Eigen::Vector3f> positions,
                const std::vector<std::array<std::uint32_t, 4>>& quads) {
  TriMesh mesh;
  mesh.positions = std::move(positions);
  for (const auto& [a, b, c, d] : quads) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

TEST(Bodies, OneThatCutsAnotherAlongAnEdgeOfItsFaceDoesNotHang) {
  const std::vector<std::array<std::uint32_t, 4>> sides = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  const TriMesh
      wedge = ofQuads(
          {{0, 0, 0}, {0, 0, 1}, {0, 2, 0}, {0, 2, 1}, {3, 0, 0.1f}, {3, 0, 1}, {3, 0.1f, 0}, {0, 2, 1}},
          sides),
      block = ofQuads(
          {{3, 0, 0}, {2, 0, 1}, {3, 2, 0}, {3, 2, 1}, {4, 0, 0}, {4, 0, 1}, {4, 2, 0}, {4, 2, 1}}, sides);
  // CGAL's union walks on without an end, and no middle of a face lies in the other body.
  EXPECT_NEAR(meshVolume(wedge) + meshVolume(block), 3.05 + 7.0 / 3.0, 1e-6);
  const auto both = prepareNominal(together(wedge, block), "part.stl");
  ASSERT_TRUE(both.ok()) << both.error().message;
  EXPECT_NEAR(meshVolume(both->mesh), 5.3, 1e-3);  // by rays 1/150 apart
}

TEST(Bodies, ManyLooseBodiesAreReadInTimeThatGrowsWithTheirNumber) {
  TriMesh all;
  constexpr int kSide = 24;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const Vec3 at(2.0 * (i % kSide), 2.0 * (i / kSide % kSide), 2.0 * (i / kSide / kSide));
    append(all, box(at, at + Vec3::Constant(1)));
  }
  const PreparedMesh p = prepared(all);
  EXPECT_NEAR(meshVolume(p.mesh), kSide * kSide * kSide, 1.0);
  EXPECT_TRUE(p.notes.empty());
}

TEST(Bodies, GapsAsWideAsRoundingAreClosed) {
  for (const double gap : {-2e-5, 1e-5, 4e-5}) {
    SCOPED_TRACE(gap);
    expectEqualTo(together(box({0, 0, 0}, {20, 20, 20}), box({20 + gap, 0, 0}, {40, 20, 20})),
                  box({0, 0, 0}, {40, 20, 20}));
  }
  // One that may be meant stays, and is told; a wide one is nobody's business.
  const PreparedMesh near =
      prepared(together(box({0, 0, 0}, {20, 20, 20}), box({20.02, 0, 0}, {40, 20, 20})));
  EXPECT_THAT(near.notes,
              testing::ElementsAre(HasSubstr("there is a gap of 0.02 mm between bodies at X20.010")));
  EXPECT_NEAR(meshVolume(near.mesh), 8000.0 + 400 * 19.98, 0.01);
  const PreparedMesh apart =
      prepared(together(box({0, 0, 0}, {20, 20, 20}), box({20.1, 0, 0}, {40, 20, 20})));
  EXPECT_TRUE(apart.notes.empty());
}

TEST(Bodies, GapsFarBelowAnyToleranceAreClosedAndTold) {
  for (const double gap : {3e-4, 1e-3, 4e-3}) {
    SCOPED_TRACE(gap);
    const TriMesh block = box({0, 0, 0}, {20, 20, 20});
    // Face to face, a small one on a large one, and side by side with an offset.
    expectWithin(together(block, box({20 + gap, 0, 0}, {40, 20, 20})), box({0, 0, 0}, {40, 20, 20}), gap);
    const auto boss = [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); };
    expectWithin(together(block, box({5, 6, 20 + gap}, {12, 13, 30})),
                 shapes::blocks({0, 5, 12, 20}, {0, 6, 13, 20}, {0, 20, 30}, boss), gap);
    const auto offset = [](int i, int j, int) { return i == 0 ? j < 2 : j > 0; };
    expectWithin(together(block, box({20 + gap, 8, 0}, {40, 28, 20})),
                 shapes::blocks({0, 20, 40}, {0, 8, 20, 28}, {0, 20}, offset), gap);
    EXPECT_THAT(prepared(together(block, box({20 + gap, 0, 0}, {40, 20, 20}))).notes,
                testing::Contains(HasSubstr("closed a gap of")));
  }
}

TEST(Bodies, OverlapsWithACommonEdgeCornerOrFaceAreJoined) {
  const TriMesh low = box({0, 0, 0}, {40, 30, 10});
  const auto volume = [&](const TriMesh& other) { return meshVolume(prepared(together(low, other)).mesh); };
  EXPECT_NEAR(volume(box({0, 0, 0}, {40, 10, 20})), 16000.0, 1e-2);   // an edge
  EXPECT_NEAR(volume(box({0, 0, 0}, {15, 10, 20})), 13500.0, 1e-2);   // a corner
  EXPECT_NEAR(volume(box({0, 0, 0}, {40, 30, 20})), 24000.0, 1e-2);   // the whole base
  EXPECT_NEAR(volume(box({10, 0, 0}, {30, 10, 20})), 14000.0, 1e-2);  // part of an edge
  // Three at one edge.
  const TriMesh three = together(together(low, box({0, 0, 0}, {40, 10, 20})), box({0, 0, 0}, {40, 5, 30}));
  EXPECT_NEAR(meshVolume(prepared(three).mesh), 18000.0, 1e-2);
  // One facet of them turned round.
  TriMesh turned = together(low, box({0, 0, 0}, {40, 10, 20}));
  std::swap(turned.triangles[3][1], turned.triangles[3][2]);
  const PreparedMesh p = prepared(turned);
  EXPECT_THAT(p.notes, testing::Contains(HasSubstr("mixed orientation")));
  EXPECT_NEAR(meshVolume(p.mesh), 16000.0, 1e-2);
}

TEST(Bodies, AVoidThatReachesTheSurfaceIsCutOut) {
  const PreparedMesh p =
      prepared(together(box({0, 0, 0}, {20, 20, 20}), shapes::insideOut(box({5, 5, 10}, {15, 15, 20}))));
  EXPECT_NEAR(meshVolume(p.mesh), 7000.0, 1e-2);
}

TEST(Bodies, RoundBodiesThatOverlapAreJoined) {
  const TriMesh a = shapes::sphere({0, 0, 0}, 10, 4), b = shapes::sphere({12, 1, 0}, 10, 4);
  const double d = std::hypot(12, 1), lens = kPi * (4 * 10 + d) * (2 * 10 - d) * (2 * 10 - d) / 12;
  const PreparedMesh p = prepared(together(a, b));
  EXPECT_NEAR(meshVolume(p.mesh) / (2 * meshVolume(a) - lens), 1.0, 0.003);
}

TEST(Bodies, VoidsStayVoids) {
  const TriMesh hollow =
      together(box({0, 0, 0}, {20, 20, 20}), shapes::insideOut(box({5, 5, 5}, {15, 15, 15})));
  EXPECT_NEAR(meshVolume(prepared(hollow).mesh), 7000.0, 1e-2);
  EXPECT_TRUE(prepared(hollow).notes.empty());
  // One in a body that is joined with another.
  const PreparedMesh joined = prepared(together(hollow, box({20, 0, 0}, {40, 20, 20})));
  EXPECT_NEAR(meshVolume(joined.mesh), 15000.0, 1e-2);
  // A part that lies loose in a void is a body of its own.
  const PreparedMesh loose = prepared(together(hollow, box({8, 8, 8}, {12, 12, 12})));
  EXPECT_NEAR(meshVolume(loose.mesh), 7064.0, 1e-2);
}

TEST(Bodies, ASurfaceThroughItselfIsRefusedWithItsPlace) {
  // A fork whose one prong is bent into the other: one shell.
  TriMesh m = shapes::blocks({0, 10, 30}, {0, 10, 20, 30}, {0, 10},
                             [](int i, int j, int) { return i == 0 || j != 1; });
  for (auto& p : m.positions) {
    if (p.x() > 15 && p.y() > 15) p.y() -= 15;
  }
  const auto r = prepareNominal(soup(m), "bent.stl");
  ASSERT_FALSE(r.ok());
  EXPECT_THAT(r.error().message, HasSubstr("bent.stl: the surface crosses itself at X"));
}

TEST(Bodies, ASpikeThroughTheOppositeWallIsRefusedWithItsPlace) {
  // A dent in the top, deeper than the body is thick.
  TriMesh m = shapes::blocks({0, 10, 11, 20}, {0, 10, 11, 20}, {0, 4, 5},
                             [](int i, int j, int k) { return k == 0 || i != 1 || j != 1; });
  for (auto& p : m.positions) {
    if (p.z() == 4.0f && std::abs(p.x() - 10.5f) < 1.0f && std::abs(p.y() - 10.5f) < 1.0f) p.z() = -0.5f;
  }
  const auto r = prepareNominal(soup(m), "dent.stl");
  ASSERT_FALSE(r.ok());
  EXPECT_THAT(r.error().message, HasSubstr("crosses itself: a face bounds no material at X1"));
}

}  // namespace
}  // namespace proveout
