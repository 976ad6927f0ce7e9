#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "removal/compare/compare.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const TriMesh kBox = shapes::box({0, 0, 0}, {10, 10, 10});

std::string refusal(const TriMesh& mesh) {
  const auto r = prepareNominal(mesh, "part.stl");
  return r.ok() ? "accepted" : r.error().message;
}

PreparedMesh prepared(const TriMesh& mesh) {
  auto r = prepareNominal(mesh, "part.stl");
  EXPECT_TRUE(r.ok()) << r.error().message;
  EXPECT_EQ(analyseTopology(r->mesh).boundary_edges, 0u);
  EXPECT_EQ(analyseTopology(r->mesh).misoriented_edges, 0u);
  return std::move(r).value();
}

TriMesh soup(const TriMesh& m, float noise) {
  TriMesh s;
  for (const auto& t : m.triangles) {
    const auto n = static_cast<std::uint32_t>(s.positions.size());
    for (const auto v : t) s.positions.push_back(m.positions[v] + Eigen::Vector3f::Constant(noise * (n % 5)));
    s.triangles.push_back({n, n + 1, n + 2});
  }
  return s;
}

TEST(Prepare, GoodMeshPassesWithoutNotes) {
  EXPECT_THAT(prepared(kBox).notes, ElementsAre());
  EXPECT_DOUBLE_EQ(meshVolume(prepared(kBox).mesh), 1000.0);
}

TEST(Prepare, FacetsOfAnStlAreWelded) {
  EXPECT_THAT(prepared(soup(kBox, 0.0f)).notes, ElementsAre());
  EXPECT_EQ(prepared(soup(kBox, 0.0f)).mesh.positions.size(), 8u);
}

TEST(Prepare, TinyGapsAreClosedWithANote) {
  const PreparedMesh p = prepared(soup(kBox, 1e-5f));
  EXPECT_THAT(p.notes, ElementsAre(HasSubstr("cracks of up to")));
  EXPECT_NEAR(meshVolume(p.mesh), 1000.0, 0.1);
}

TEST(Prepare, AHoleIsRefusedWithItsPlace) {
  TriMesh m = kBox;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {  // a triangle of the face x = 10
    const auto& v = m.triangles[t];
    if (m.positions[v[0]].x() + m.positions[v[1]].x() + m.positions[v[2]].x() < 29) continue;
    m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    break;
  }
  const std::string text = refusal(m);
  EXPECT_THAT(text, StartsWith("part.stl: the mesh is not closed"));
  EXPECT_THAT(text, HasSubstr("X10.000"));
  EXPECT_THAT(text, HasSubstr("3 open edges"));
  EXPECT_THAT(text, HasSubstr("export it again"));
}

TEST(Prepare, InsideOutIsTurnedWithANote) {
  const PreparedMesh p = prepared(shapes::insideOut(kBox));
  EXPECT_THAT(p.notes, ElementsAre(HasSubstr("inside out")));
  EXPECT_DOUBLE_EQ(meshVolume(p.mesh), 1000.0);
}

TEST(Prepare, MixedFacetsAreMadeConsistent) {
  TriMesh m = kBox;
  std::swap(m.triangles[2][0], m.triangles[2][1]);
  std::swap(m.triangles[9][0], m.triangles[9][1]);
  const PreparedMesh p = prepared(m);
  EXPECT_THAT(p.notes, ElementsAre(HasSubstr("mixed orientation")));
  EXPECT_DOUBLE_EQ(meshVolume(p.mesh), 1000.0);
}

/// Of some facets of a box, whole or turned.
TriMesh withFacets(const TriMesh& mesh, const std::vector<std::uint32_t>& facets, bool turned) {
  TriMesh m = mesh;
  for (const std::uint32_t t : facets) {
    auto v = m.triangles[t];
    if (turned) std::swap(v[1], v[2]);
    m.triangles.push_back(v);
  }
  return m;
}

TEST(Prepare, ShellsFaceAsTheyAreInTheFile) {
  const TriMesh ball = shapes::sphere({5, 5, 5}, 2, 3), hollow_ball = shapes::insideOut(ball);
  EXPECT_THAT(prepared(shapes::together(kBox, hollow_ball)).notes, ElementsAre());
  EXPECT_NEAR(meshVolume(prepared(shapes::together(kBox, hollow_ball)).mesh), 1000.0 - meshVolume(ball),
              1e-3);
  const PreparedMesh within = prepared(shapes::together(kBox, ball));
  EXPECT_THAT(within.notes, ElementsAre(HasSubstr("a body lies within the material"), HasSubstr("2 bodies")));
  EXPECT_EQ(within.mesh.triangles.size(), 12u);
  // All of it inside out.
  const PreparedMesh turned = prepared(shapes::insideOut(shapes::together(kBox, hollow_ball)));
  EXPECT_THAT(turned.notes, ElementsAre(HasSubstr("2 shells were inside out")));
  EXPECT_NEAR(meshVolume(turned.mesh), 1000.0 - meshVolume(ball), 1e-3);
  // A body that is inside out beside one that is not.
  const PreparedMesh two =
      prepared(shapes::together(kBox, shapes::insideOut(shapes::box({20, 0, 0}, {21, 1, 1}))));
  EXPECT_THAT(two.notes, ElementsAre(HasSubstr("a shell was inside out")));
  EXPECT_NEAR(meshVolume(two.mesh), 1001.0, 1e-3);
}

TEST(Prepare, BodiesInBodiesInBodiesAreOne) {
  const auto nested = [](const std::vector<bool>& outward) {
    TriMesh all;
    double low = 0.0;
    for (const bool out : outward) {
      const TriMesh one = shapes::box(Vec3::Constant(low), Vec3::Constant(20.0 - low));
      all = shapes::together(all, out ? one : shapes::insideOut(one));
      low += 3.0;
    }
    return meshVolume(prepared(all).mesh);
  };
  const double whole = 8000.0, second = 14.0 * 14 * 14, third = 512.0;
  EXPECT_NEAR(nested({true, true, true}), whole, 1e-2);
  EXPECT_NEAR(nested({true, false, true}), whole - second + third, 1e-2);
  EXPECT_NEAR(nested({true, true, false}), whole, 1e-2);  // the void of a body that the outer one fills
  EXPECT_NEAR(nested({true, false, false}), whole - second + third, 1e-2);  // a body in the void, inside out
}

TEST(Prepare, AShellThatCannotBeToldABodyOrAVoidIsRefused) {
  TriMesh inner = shapes::box({3, 3, 3}, {7, 7, 7});
  for (std::size_t t = 0; t < 6; ++t) std::swap(inner.triangles[t][1], inner.triangles[t][2]);
  EXPECT_THAT(refusal(shapes::together(kBox, inner)), HasSubstr("face both ways"));
  // One facet is none to doubt of.
  inner = shapes::insideOut(shapes::box({3, 3, 3}, {7, 7, 7}));
  std::swap(inner.triangles[0][1], inner.triangles[0][2]);
  EXPECT_NEAR(meshVolume(prepared(shapes::together(kBox, inner)).mesh), 1000.0 - 64.0, 1e-3);
}

TEST(Prepare, FacetsThatAFileHasTwiceCountOnceWhicheverWayTheyFace) {
  for (const bool turned : {false, true}) {
    const PreparedMesh p = prepared(withFacets(kBox, {4, 5, 9}, turned));
    EXPECT_THAT(p.notes, testing::Contains(HasSubstr("dropped 3 doubled")));
    EXPECT_NEAR(meshVolume(p.mesh), 1000.0, 1e-3);
  }
}

TEST(Prepare, FacetsOfNoAreaAreNobodysBusiness) {
  const auto withCorners = [](const std::vector<Eigen::Vector3f>& corners) {
    TriMesh m = kBox;
    const auto first = static_cast<std::uint32_t>(m.positions.size());
    m.positions.insert(m.positions.end(), corners.begin(), corners.end());
    for (std::uint32_t i = 2; i < corners.size(); ++i)
      m.triangles.push_back({first, first + i - 1, first + i});
    return m;
  };
  for (const TriMesh& mesh :
       {withCorners({{5, 5, 10}, {6, 6, 10}, {7, 7, 10}}), withCorners({{5, 5, 10}, {5, 5, 10}, {7, 7, 10}}),
        withCorners({{0, 0, 10}, {5, 0, 10}, {10, 0, 10}}),
        withCorners({{20, 0, 0}, {30, 0, 0}, {25, 0, 1e-5f}}),
        withCorners({{1, 1, 10}, {2, 2, 10}, {3, 3, 10}, {4, 4, 10}, {5, 5, 10}})}) {
    EXPECT_THAT(prepared(weldVertices(mesh)).notes, ElementsAre());
    EXPECT_NEAR(meshVolume(prepared(weldVertices(mesh)).mesh), 1000.0, 1e-3);
  }
}

TEST(Prepare, CracksAreToldWithTheirWidthAndPlace) {
  for (const double width : {2e-4, 0.004, 0.03}) {
    SCOPED_TRACE(width);
    TriMesh m = soup(kBox, 0.0f);  // the top stands off
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      bool top = true;
      for (const auto v : m.triangles[t]) top = top && m.positions[v].z() > 9.0f;
      for (const auto v : m.triangles[t]) m.positions[v].z() += top ? static_cast<float>(width) : 0.0f;
    }
    const std::string wide = "cracks of up to " + std::string(width < 1e-3   ? "0.0002"
                                                              : width < 0.01 ? "0.004"
                                                                             : "0.03");
    if (width > 1e-3) {
      EXPECT_THAT(refusal(m), HasSubstr(wide + " mm, the widest at X"));
    } else {
      const PreparedMesh p = prepared(m);
      EXPECT_THAT(p.notes, ElementsAre(HasSubstr(wide)));
      EXPECT_NEAR(meshVolume(p.mesh), 1000.0, 0.1);
    }
  }
}

TEST(Prepare, AHoleBesideCracksIsAHole) {
  TriMesh m = soup(kBox, 0.0f);
  for (std::size_t i = 0; i < 3; ++i) m.positions[i].z() += 0.01f;
  m.triangles.pop_back();
  EXPECT_THAT(refusal(m), HasSubstr("a hole or a wall"));
}

TEST(Prepare, CornersOnEdgesOfOthersAreClosed) {
  // A facet ends in the middle of another's edge: the two halves of its neighbour.
  TriMesh m = kBox;
  const auto [a, b, c] = m.triangles[0];
  const auto middle = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back(0.5f * (m.positions[a] + m.positions[b]));
  m.triangles[0] = {a, middle, c};
  m.triangles.push_back({middle, b, c});
  const PreparedMesh p = prepared(m);
  EXPECT_THAT(p.notes, ElementsAre(HasSubstr("1 facets split")));
  EXPECT_NEAR(meshVolume(p.mesh), 1000.0, 1e-3);
}

TEST(Prepare, DoubledTrianglesAreDropped) {
  TriMesh m = kBox;
  m.triangles.push_back(m.triangles[4]);
  const auto last = static_cast<std::uint32_t>(m.positions.size());
  m.positions.push_back({3, 3, 12});
  m.triangles.push_back({0, 1, last});  // a fin: two facets back to back
  m.triangles.push_back({1, 0, last});
  const PreparedMesh p = prepared(m);
  EXPECT_THAT(p.notes, ElementsAre(HasSubstr("dropped 3 doubled")));
  EXPECT_EQ(p.mesh.triangles.size(), 12u);
}

TEST(Prepare, BodiesThatShareAnEdgeAreAccepted) {
  const TriMesh m = shapes::together(kBox, shapes::box({10, 10, 0}, {20, 20, 10}));
  EXPECT_TRUE(prepareNominal(m, "part.stl").ok());
  Progress progress;
  const TriMesh nominal = prepareNominal(m, "part.stl")->mesh;
  const auto c = compareToNominal(m, nominal, {.resolution_mm = 1.0}, progress);
  ASSERT_TRUE(c.ok()) << c.error().message;
  EXPECT_TRUE(c->pass());
}

TEST(Prepare, BadInputIsRefused) {
  EXPECT_THAT(refusal({}), HasSubstr("no triangles"));
  TriMesh m = kBox;
  m.positions[3].y() = std::numeric_limits<float>::infinity();
  EXPECT_THAT(refusal(m), HasSubstr("not a finite number"));
  m = kBox;
  m.triangles[5] = {1, 2, 77};
  EXPECT_THAT(refusal(m), HasSubstr("triangle 6"));
  m = kBox;
  for (auto& p : m.positions) p.z() = 0.0f;  // flat: nothing left, or no volume
  EXPECT_NE(refusal(m), "accepted");
  // A surface with one side: five quads in a ring with a twist are open at their border as well.
  TriMesh strip;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * kPi * i / 5, h = a / 2;
    for (const double s : {-1.0, 1.0}) {
      const double r = 10 + s * std::cos(h);
      strip.positions.push_back(Vec3(r * std::cos(a), r * std::sin(a), s * std::sin(h)).cast<float>());
    }
  }
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t a = 2 * i, b = a + 1, c = i < 4 ? a + 2 : 1, d = i < 4 ? a + 3 : 0;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  EXPECT_THAT(refusal(strip), HasSubstr("not closed"));
}

}  // namespace
}  // namespace proveout
