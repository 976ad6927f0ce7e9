// Meshes of several bodies: taken apart, joined, or refused.
#include "removal/compare/bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(Bodies, ShellsComeApartAtCommonFacesEdgesAndVertices) {
  const TriMesh a = box({0, 0, 0}, {10, 10, 10});
  for (const TriMesh& other : {box({10, 2, 2}, {15, 8, 8}), box({10, 10, 0}, {15, 15, 10}),
                               box({10, 10, 10}, {15, 15, 15}), box({20, 0, 0}, {25, 5, 5})}) {
    const Shells shells = splitShells(weldVertices(soup(together(a, other))));
    ASSERT_EQ(shells.count, 2u);
    EXPECT_TRUE(analyseTopology(shells.mesh).closedManifold());
    EXPECT_NEAR(meshVolume(shellMesh(shells, 0)), 1000.0, 1e-3);
    EXPECT_NEAR(meshVolume(shellMesh(shells, 1)), meshVolume(other), 1e-3);
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

TEST(Bodies, GapsAsWideAsRoundingAreClosed) {
  for (const double gap : {-2e-5, 1e-5, 4e-5}) {
    SCOPED_TRACE(gap);
    expectEqualTo(together(box({0, 0, 0}, {20, 20, 20}), box({20 + gap, 0, 0}, {40, 20, 20})),
                  box({0, 0, 0}, {40, 20, 20}));
  }
  // A real gap stays one.
  const PreparedMesh apart =
      prepared(together(box({0, 0, 0}, {20, 20, 20}), box({20.01, 0, 0}, {40, 20, 20})));
  EXPECT_TRUE(apart.notes.empty());
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
  EXPECT_THAT(r.error().message, HasSubstr("bent.stl: the surface runs through itself"));
  EXPECT_THAT(r.error().message, HasSubstr("X"));
}

}  // namespace
}  // namespace proveout
