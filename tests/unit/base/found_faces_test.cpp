// Faces that are found in facets: bodies whose surfaces are known, tessellated here.
#include "core/mesh/faces/found_faces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "core/mesh/faces/coordinate_rounding.h"

namespace proveout {
namespace {

using Profile = std::vector<Eigen::Vector2d>;  ///< radius and height, mm

/// Points of an arc from angle to angle, rad, both ends included, whose chords leave it by no more than that.
Profile arc(const Eigen::Vector2d& centre, double radius, double from, double to, double chord) {
  const double step = 2.0 * std::acos(1.0 - chord / radius);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
  Profile out;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    out.emplace_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return out;
}

Profile operator+(Profile a, const Profile& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The closed outline turned about Z; it goes counter-clockwise seen with the radius to the right.
TriMesh turned(const Profile& outline, int sectors) {
  TriMesh mesh;
  std::map<std::pair<int, int>, std::uint32_t> known;
  const auto vertex = [&](int i, int s) {
    const Eigen::Vector2d& p = outline[static_cast<std::size_t>(i)];
    const bool on_axis = p.x() < 1e-9;
    const auto [it, is_new] =
        known.try_emplace({i, on_axis ? 0 : s % sectors}, static_cast<std::uint32_t>(mesh.positions.size()));
    const double angle = 2.0 * kPi * s / sectors;
    if (is_new)
      mesh.positions.push_back(Vec3(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()).cast<float>());
    return it->second;
  };
  const int count = static_cast<int>(outline.size());
  for (int i = 0; i < count; ++i) {
    for (int s = 0; s < sectors; ++s) {
      const int j = (i + 1) % count;
      const std::uint32_t a = vertex(i, s), b = vertex(i, s + 1), c = vertex(j, s + 1), d = vertex(j, s);
      if (a != b) mesh.triangles.push_back({a, b, c == d ? d : c});
      if (c != d) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A prism over a convex outline.
TriMesh prism(const Profile& outline, double height) {
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.0, height})
    for (const auto& p : outline) mesh.positions.push_back(Vec3(p.x(), p.y(), z).cast<float>());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (i > 0 && j > 0) {
      mesh.triangles.push_back({0, j, i});
      mesh.triangles.push_back({n, n + i, n + j});
    }
  }
  return mesh;
}

Profile polygon(int corners, double radius) {
  Profile out;
  for (int i = 0; i < corners; ++i)
    out.emplace_back(radius * std::cos(2.0 * kPi * i / corners), radius * std::sin(2.0 * kPi * i / corners));
  return out;
}

TriMesh moved(TriMesh mesh, const Eigen::Affine3d& by) {
  for (auto& p : mesh.positions) p = (by * p.cast<double>()).cast<float>();
  return mesh;
}
Eigen::Affine3d skew() {
  return Eigen::Translation3d(12.3, -4.56, 7.89) * Eigen::AngleAxisd(0.7, Vec3(0.3, -0.5, 0.8).normalized());
}

TriMesh rounded(TriMesh mesh, double step) {
  for (auto& p : mesh.positions)
    for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(std::round(p[k] / step) * step);
  return mesh;
}

std::map<SurfaceKind, int> kindsOf(const FoundFaces& found) {
  std::map<SurfaceKind, int> out;
  for (const CadFace& face : found.faces.faces) ++out[face.kind];
  return out;
}

const CadFace& only(const FoundFaces& found, SurfaceKind kind) {
  static const CadFace kNone;
  const CadFace* out = nullptr;
  for (const CadFace& face : found.faces.faces) {
    if (face.kind != kind) continue;
    EXPECT_EQ(out, nullptr) << "several of a kind";
    out = &face;
  }
  EXPECT_NE(out, nullptr);
  return out == nullptr ? kNone : *out;
}

void expectAllKnown(const TriMesh& mesh, const FoundFaces& found) {
  ASSERT_EQ(found.faces.of_triangle.size(), mesh.triangles.size());
  for (const std::uint32_t face : found.faces.of_triangle) ASSERT_LT(face, found.faces.faces.size());
  for (const CadFace& face : found.faces.faces) EXPECT_LE(face.residual_mm, found.near_mm);
}

constexpr double kChord = 0.02;
int sectorsFor(double radius) { return static_cast<int>(std::ceil(kPi / std::acos(1.0 - kChord / radius))); }

TEST(FoundFaces, OfACylinder) {
  for (const double radius : {0.3, 0.5, 2.0, 25.0}) {
    const TriMesh mesh = turned({{0, 0}, {radius, 0}, {radius, 12}, {0, 12}}, sectorsFor(radius));
    const FoundFaces found = findFaces(mesh);
    expectAllKnown(mesh, found);
    EXPECT_EQ(kindsOf(found),
              (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 2}, {SurfaceKind::kCylinder, 1}}));
    const CadFace& face = only(found, SurfaceKind::kCylinder);
    EXPECT_NEAR(face.radius, radius, 1e-5);
    EXPECT_FALSE(face.hollow);
    EXPECT_EQ(std::abs(face.axis.z()), 1.0);
    EXPECT_NEAR(face.turn_rad, 2.0 * kPi, 1e-9);
    EXPECT_LE(found.chord_mm, kChord + 1e-4);
    EXPECT_GT(found.chord_mm, 0.3 * kChord);
  }
}

/// Of a body in a skew place everything is found as it lies.
TEST(FoundFaces, OfAStepInASkewPlace) {
  const TriMesh mesh = moved(turned({{4, 0}, {10, 0}, {10, 8}, {6, 8}, {6, 20}, {4, 20}}, 60), skew());
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found),
            (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 3}, {SurfaceKind::kCylinder, 3}}));
  const Vec3 axis = skew().linear() * Vec3::UnitZ(), on = skew() * Vec3::Zero();
  std::vector<double> radii;
  for (const CadFace& face : found.faces.faces) {
    EXPECT_LT(face.axis.cross(axis).norm(), 1e-6);
    if (face.kind != SurfaceKind::kCylinder) continue;
    EXPECT_LT((face.origin - on).cross(axis).norm(), 1e-5);
    EXPECT_EQ(face.hollow, face.radius < 5.0);
    radii.push_back(face.radius);
  }
  std::sort(radii.begin(), radii.end());
  EXPECT_NEAR(radii[0], 4.0, 1e-5);
  EXPECT_NEAR(radii[1], 6.0, 1e-5);
  EXPECT_NEAR(radii[2], 10.0, 1e-5);
}

TEST(FoundFaces, OfACountersinkAndACone) {
  // A bush: outside a cone that narrows upwards, inside a hole with a countersink of 90 degrees on top.
  const double slope = std::tan(degToRad(10.0));
  const TriMesh mesh = turned({{3, 0}, {15, 0}, {15 - 10 * slope, 10}, {5, 10}, {3, 8}}, sectorsFor(15));
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found),
            (std::map<SurfaceKind, int>{
                {SurfaceKind::kPlane, 2}, {SurfaceKind::kCylinder, 1}, {SurfaceKind::kCone, 2}}));
  for (const CadFace& face : found.faces.faces) {
    if (face.kind != SurfaceKind::kCone) continue;
    EXPECT_NEAR(face.half_angle_rad, degToRad(face.hollow ? 45.0 : 10.0), 1e-5);
    EXPECT_EQ(face.axis.z(), face.hollow ? 1.0 : -1.0) << "towards the wide end";
    EXPECT_NEAR(face.turn_rad, 2.0 * kPi, 1e-9);
    EXPECT_NEAR(
        face.distance(Vec3(face.hollow ? 4.0 : 0.0, face.hollow ? 0.0 : 15.0, face.hollow ? 9.0 : 0.0)), 0.0,
        1e-5);
  }
}

TEST(FoundFaces, OfADrilledHoleWithItsTip) {
  const double tip = 3.0 / std::tan(degToRad(59.0));
  const TriMesh mesh = turned({{0, 0}, {12, 0}, {12, 20}, {3, 20}, {3, 8}, {0, 8 - tip}}, sectorsFor(12));
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  const CadFace& cone = only(found, SurfaceKind::kCone);
  EXPECT_TRUE(cone.hollow);
  EXPECT_NEAR(cone.half_angle_rad, degToRad(59.0), 1e-5);
}

TEST(FoundFaces, OfABallAndOfASeat) {
  const TriMesh ball = turned(arc({0, 0}, 6, -kPi / 2, kPi / 2, kChord), sectorsFor(6));
  const FoundFaces found = findFaces(ball);
  expectAllKnown(ball, found);
  EXPECT_EQ(kindsOf(found), (std::map<SurfaceKind, int>{{SurfaceKind::kSphere, 1}}));
  EXPECT_NEAR(only(found, SurfaceKind::kSphere).radius, 6.0, 1e-5);
  EXPECT_LT(only(found, SurfaceKind::kSphere).origin.norm(), 1e-5);
  const Profile seat = Profile{{0, 0}, {20, 0}, {20, 15}} + arc({0, 15}, 6, 0, -kPi / 2, kChord);
  const TriMesh block = moved(turned(seat, sectorsFor(20)), skew());
  const FoundFaces in_block = findFaces(block);
  expectAllKnown(block, in_block);
  EXPECT_TRUE(only(in_block, SurfaceKind::kSphere).hollow);
  EXPECT_NEAR(only(in_block, SurfaceKind::kSphere).radius, 6.0, 2e-5);
}

TEST(FoundFaces, OfAFilletAndAGroove) {
  // A shaft with a groove of radius 2 around it and a round of 1.5 at its upper edge.
  const Profile outline = Profile{{0, 0}, {10, 0}} + arc({10, 8}, 2, -kPi / 2, -1.5 * kPi, kChord) +
                          arc({8.5, 18.5}, 1.5, 0, kPi / 2, kChord) + Profile{{0, 20}};
  const TriMesh mesh = turned(outline, sectorsFor(12));
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found),
            (std::map<SurfaceKind, int>{
                {SurfaceKind::kPlane, 2}, {SurfaceKind::kCylinder, 2}, {SurfaceKind::kTorus, 2}}));
  for (const CadFace& face : found.faces.faces) {
    if (face.kind != SurfaceKind::kTorus) continue;
    EXPECT_NEAR(face.tube_radius, face.hollow ? 2.0 : 1.5, 1e-5);
    EXPECT_NEAR(face.radius, face.hollow ? 10.0 : 8.5, 1e-5);
    EXPECT_NEAR(face.origin.z(), face.hollow ? 8.0 : 18.5, 1e-5);
  }
}

TEST(FoundFaces, OfAPlateWithRoundedCorners) {
  Profile outline;
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 || k == 3 ? 20.0 : -20.0, y = k < 2 ? 10.0 : -10.0;
    outline = outline + arc({x, y}, 4.0, k * kPi / 2, (k + 1) * kPi / 2, kChord);
  }
  const TriMesh mesh = moved(prism(outline, 6.0), skew());
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found),
            (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 6}, {SurfaceKind::kCylinder, 4}}));
  for (const CadFace& face : found.faces.faces) {
    if (face.kind != SurfaceKind::kCylinder) continue;
    EXPECT_NEAR(face.radius, 4.0, 5e-5);
    EXPECT_NEAR(face.turn_rad, kPi / 2, degToRad(1.0));
  }
}

/// Where a boolean cut the flat strips of a round it left corners on them that are off the round by the
/// chord.
TEST(FoundFaces, OfFacetsThatWereCut) {
  Profile outline;
  const Profile corners = polygon(sectorsFor(5.0), 5.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    outline.push_back(a);
    outline.emplace_back(a + 0.3 * (b - a));
    if (i % 3 == 0) outline.emplace_back(a + 0.8 * (b - a));
  }
  const TriMesh mesh = moved(prism(outline, 8.0), skew());
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found),
            (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 2}, {SurfaceKind::kCylinder, 1}}));
  EXPECT_NEAR(only(found, SurfaceKind::kCylinder).radius, 5.0, 2e-5);
}

/// A cone so fine that a few of its facets could be of many a face.
TEST(FoundFaces, OfAFineCone) {
  const double slope = std::tan(degToRad(10.0));
  Profile outline = {{0, 0}, {10, 0}};
  for (int i = 1; i <= 40; ++i) outline.emplace_back(10 - 0.25 * i * slope, 0.25 * i);
  outline.emplace_back(0, 10);
  const TriMesh mesh = turned(outline, 500);
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  EXPECT_EQ(kindsOf(found), (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 2}, {SurfaceKind::kCone, 1}}));
  EXPECT_NEAR(only(found, SurfaceKind::kCone).half_angle_rad, degToRad(10.0), 1e-5);
}

/// Flats stay flats: nobody writes a round with so few facets.
TEST(FoundFaces, OfPolygonsArePlanes) {
  for (const int corners : {3, 4, 5, 6, 8}) {
    const FoundFaces found = findFaces(prism(polygon(corners, 5.0), 8.0));
    EXPECT_EQ(kindsOf(found), (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, corners + 2}})) << corners;
  }
  // Twelve flats of a large nut lie too far off any round.
  EXPECT_EQ(kindsOf(findFaces(prism(polygon(12, 30.0), 8.0))),
            (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 14}}));
}

/// As files with few decimals have them.
TEST(FoundFaces, HoldWhereCoordinatesAreRounded) {
  const TriMesh exact = turned({{4, 0}, {10, 0}, {10, 8}, {6, 8}, {6, 20}, {5, 20}, {4, 19}}, 90);
  const FoundFaces of_exact = findFaces(exact);
  for (const double step : {1e-3, 1e-4}) {
    const TriMesh mesh = rounded(exact, step);
    EXPECT_NEAR(coordinateRounding(mesh), 0.5 * step, 1e-12);
    const Eigen::Affine3d shift(Eigen::Translation3d(1.23456, 0.0, -9.87654));
    EXPECT_NEAR(coordinateRounding(moved(mesh, shift)), 0.5 * step, 1e-12);
    const FoundFaces found = findFaces(mesh);
    expectAllKnown(mesh, found);
    EXPECT_EQ(found.faces.of_triangle, of_exact.faces.of_triangle);
    for (std::size_t f = 0; f < found.faces.faces.size(); ++f) {
      EXPECT_EQ(found.faces.faces[f].kind, of_exact.faces.faces[f].kind);
      EXPECT_NEAR(found.faces.faces[f].radius, of_exact.faces.faces[f].radius, step);
    }
  }
}

TEST(FoundFaces, AreTheSameEveryTime) {
  const TriMesh mesh =
      moved(turned({{4, 0}, {10, 0}, {10, 8}, {6, 8}, {6, 20}, {5, 20}, {4, 19}}, 90), skew());
  const FoundFaces a = findFaces(mesh), b = findFaces(mesh);
  EXPECT_EQ(a.faces.of_triangle, b.faces.of_triangle);
  ASSERT_EQ(a.faces.faces.size(), b.faces.faces.size());
  for (std::size_t f = 0; f < a.faces.faces.size(); ++f) {
    EXPECT_EQ(a.faces.faces[f].origin, b.faces.faces[f].origin);
    EXPECT_EQ(a.faces.faces[f].axis, b.faces.faces[f].axis);
    EXPECT_EQ(a.faces.faces[f].radius, b.faces.faces[f].radius);
  }
}

/// A scan's noise leaves no round faces, but no wrong ones either.
TEST(FoundFaces, AreNoneInNoise) {
  TriMesh mesh = turned({{4, 0}, {10, 0}, {10, 8}, {6, 8}, {6, 20}, {4, 20}}, 60);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-5e-3f, 5e-3f);
  for (auto& p : mesh.positions) p += Eigen::Vector3f(noise(random), noise(random), noise(random));
  const FoundFaces found = findFaces(mesh);
  expectAllKnown(mesh, found);
  for (const CadFace& face : found.faces.faces)
    EXPECT_TRUE(face.kind == SurfaceKind::kPlane || face.kind == SurfaceKind::kOther);
}

TEST(FoundFaces, AreNoneInAFreeForm) {
  TriMesh egg = turned(arc({0, 0}, 10, -kPi / 2, kPi / 2, 0.05), 80);
  for (auto& p : egg.positions)
    p = Eigen::Vector3f(p.x() * (1.0f + 0.02f * p.z()), 0.8f * p.y(), 1.3f * p.z());
  const FoundFaces found = findFaces(egg);
  expectAllKnown(egg, found);
  EXPECT_EQ(kindsOf(found), (std::map<SurfaceKind, int>{{SurfaceKind::kOther, 1}}));
}

TEST(FoundFaces, OfMeshesThatAreHardlyAny) {
  EXPECT_TRUE(findFaces({}).faces.faces.empty());
  TriMesh one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  EXPECT_EQ(findFaces(one).faces.of_triangle.size(), 1u);
  one.positions[2] = {2, 0, 0};  // no area
  EXPECT_EQ(findFaces(one).faces.of_triangle.size(), 1u);
  one.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(findFaces(one).faces.of_triangle.size(), 1u);
  TriMesh tetrahedron;
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(kindsOf(findFaces(tetrahedron)), (std::map<SurfaceKind, int>{{SurfaceKind::kPlane, 4}}));
}

}  // namespace
}  // namespace proveout
