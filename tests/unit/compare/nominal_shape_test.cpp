// Facets read as the curved faces that they stand for, against the faces themselves.
#include "removal/compare/shape/nominal_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "removal/compare/compare.h"
#include "tests/support/lofts.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using lofts::Profile;
using shapes::surface;

struct Reading {
  explicit Reading(const TriMesh& mesh) : points(surface(mesh)), distance(points), shape(points, distance) {}
  SurfaceMesh points;
  SignedDistance distance;
  NominalShape shape;
};

/// Largest difference between the read face and the true one over random points of the facets, mm; `off` is
/// the signed distance to the true solid.
double worst(const Reading& r, const std::function<double(const Vec3&)>& off) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  double most = 0.0;
  for (std::uint32_t t = 0; t < r.points.triangles.size(); ++t) {
    const auto& v = r.points.triangles[t];
    for (int i = 0; i < 4; ++i) {
      double a = unit(random), b = unit(random);
      if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
      const Vec3 p = r.points.points[v[0]] + a * (r.points.points[v[1]] - r.points.points[v[0]]) +
                     b * (r.points.points[v[2]] - r.points.points[v[0]]);
      most = std::max(most, std::abs(off(p) + r.shape.at(t, p)));
    }
  }
  return most;
}

TEST(NominalShape, ReadsCylindersWithTheirEnds) {
  for (const double radius : {0.5, 1.0, 3.4, 20.0}) {
    for (const double chord : {0.005, 0.02, 0.05}) {
      const Reading r(lofts::solid(Profile().line(radius, 0).line(radius, 7), {0, 0}, chord));
      const auto off = [&](const Vec3& p) {  // of the infinite cylinder where it is nearer than the ends
        const double wall = p.head<2>().norm() - radius, end = std::max(-p.z(), p.z() - 7.0);
        return std::abs(end) < 1e-5 ? 0.0 : wall;
      };
      EXPECT_LT(worst(r, off), 0.03 * chord) << radius << " " << chord;
      EXPECT_GT(r.shape.largest(), 0.5 * std::min(chord, radius * (1 - std::cos(kPi / 8))))
          << radius << " " << chord;
      EXPECT_LT(r.shape.largest(), 1.1 * chord);
    }
  }
}

TEST(NominalShape, ReadsRoundsThatTouchPlanes) {
  // A plate with rounded corners (upright rounds) and a fillet along its top.
  for (const double chord : {0.005, 0.02, 0.05}) {
    const double corner = 5.0, fillet = 2.0, height = 8.0, half_x = 20.0, half_y = 12.0;
    const TriMesh mesh = lofts::solid(Profile()
                                          .line(corner, 0)
                                          .line(corner, height - fillet)
                                          .arc(corner - fillet, height - fillet, fillet, 0, 90),
                                      {half_x, half_y}, chord);
    const Reading r(mesh);
    const auto off = [&](const Vec3& p) {
      const Vec2 to = (p.head<2>().cwiseAbs() - Vec2(half_x, half_y)).cwiseMax(Vec2::Zero());
      const double rho = to.norm();
      if (p.z() < 1e-6) return 0.0;                                          // the bottom
      if (p.z() <= height - fillet) return rho > 1e-6 ? rho - corner : 0.0;  // walls; flats lie on the facets
      const double from = std::hypot(std::max(rho - (corner - fillet), 0.0), p.z() - (height - fillet));
      return rho < corner - fillet + 1e-9 ? 0.0 : from - fillet;
    };
    EXPECT_LT(worst(r, off), 0.5 * chord) << chord;
    EXPECT_LT(r.shape.largest(), 2.2 * chord) << chord;  // chords both ways add up at the corners
    EXPECT_GT(r.shape.largest(), 0.5 * chord) << chord;
    // The large flat faces are flat.
    for (std::uint32_t t = 0; t < r.points.triangles.size(); ++t) {
      const Vec3 n = r.points.areaVector(t).normalized();
      const bool flat = n.cwiseAbs().maxCoeff() > 1 - 1e-9 && r.points.areaVector(t).norm() > 20.0;
      if (flat) {
        EXPECT_EQ(r.shape.at(t, r.points.middle(t)), 0.0);
      }
    }
  }
}

TEST(NominalShape, ReadsSpheresAndTori) {
  const Reading ball(shapes::sphere({1, 2, 3}, 8, 4));
  const auto off_ball = [](const Vec3& p) { return (p - Vec3(1, 2, 3)).norm() - 8.0; };
  EXPECT_LT(worst(ball, off_ball), 0.1 * ball.shape.largest());
  EXPECT_GT(ball.shape.largest(), 1e-3);
}

TEST(NominalShape, ReadsConesWithTheirTipsAndProfilesWithCreases) {
  // A shaft: cylinder, cone, cylinder, and the tip of a drill from above. Generators are straight.
  for (const double chord : {0.005, 0.02, 0.05}) {
    const double tip = 4.0 / std::tan(degToRad(59.0));
    const TriMesh mesh = lofts::solid(Profile()
                                          .line(16, -40)
                                          .line(16, -35)
                                          .line(13, -20)
                                          .line(13, 0)
                                          .line(4, 0)
                                          .line(4, -9 + tip)
                                          .line(0, -9),
                                      {0, 0}, chord);
    const Reading r(mesh);
    const auto off = [&](const Vec3& p) {
      const double rho = p.head<2>().norm();
      if (p.z() < -40 + 1e-5 || (std::abs(p.z()) < 1e-5)) return 0.0;
      const bool hole = rho < 8;
      if (hole && p.z() > -9 + tip - 1e-5) return 4.0 - rho;
      if (hole) return (p.z() + 9 - rho / std::tan(degToRad(59.0))) * std::sin(degToRad(59.0));
      const double slope = 3.0 / 15.0, scale = 1.0 / std::sqrt(1 + slope * slope);
      return p.z() < -35 ? rho - 16 : p.z() > -20 ? rho - 13 : (rho - (13 - slope * (p.z() + 20))) * scale;
    };
    EXPECT_LT(worst(r, off), 0.15 * chord) << chord;
    EXPECT_LT(r.shape.largest(), 1.15 * chord) << chord;
  }
}

TEST(NominalShape, FlatFacedSolidsHaveNone) {
  EXPECT_EQ(Reading(shapes::box({0, 0, 0}, {30, 20, 10})).shape.largest(), 0.0);
  // A flat roof: two planes that meet at 10 degrees, and a prism that nobody takes for a cylinder.
  TriMesh roof = shapes::blocks({0, 20, 40}, {0, 30}, {0, 5}, [](int, int, int) { return true; });
  for (auto& p : roof.positions) {
    if (p.z() > 1 && p.x() > 1 && p.x() < 39) p.z() += 1.75f;
  }
  EXPECT_EQ(Reading(roof).shape.largest(), 0.0);
  EXPECT_EQ(Reading(lofts::prism(6, 5.0, 10.0)).shape.largest(), 0.0);
  EXPECT_EQ(Reading(lofts::prism(8, 12.0, 10.0)).shape.largest(), 0.0);
  EXPECT_EQ(Reading(lofts::prism(24, 60.0, 10.0)).shape.largest(), 0.0);
}

/// A plate with a bore, as its exact part and as a nominal with coarse facets.
TriMesh bored(double radius, double shift, double chord) {
  return lofts::plateWith(shapes::box({-20, -15, -10}, {20, 15, 0}),
                          {lofts::Hole{Profile().line(radius, -12).line(radius, 2), {shift, 0}, {0, 0}}},
                          chord);
}

TEST(NominalShape, CoarseNominalsNeitherFailNorHide) {
  Progress progress;
  for (const double chord : {0.005, 0.02, 0.05}) {
    const TriMesh nominal = bored(6.0, 0.0, chord);
    const auto run = [&](double radius, double shift) {
      auto c = compareToNominal(bored(radius, shift, 2e-4), nominal, {.resolution_mm = 0.5}, progress);
      EXPECT_TRUE(c.ok());
      return std::move(c).value();
    };
    const Comparison right = run(6.0, 0.0);
    EXPECT_TRUE(right.pass()) << chord << " " << right.max_gouge_mm << " " << right.max_excess_mm;
    EXPECT_LT(right.max_gouge_mm, 0.1 * chord + 5e-4);
    EXPECT_NEAR(right.nominal_chord_mm, chord, 0.5 * chord);
    // 0.01 mm beyond tolerance: an error where the chords leave that open no more, else undecided.
    const Comparison wide = run(6.03, 0.0);
    EXPECT_EQ(wide.patches.size(), chord < 0.01 ? 1u : 0u) << chord;
    const std::vector<DeviationPatch>& told = wide.patches.empty() ? wide.undecided : wide.patches;
    ASSERT_FALSE(told.empty()) << chord;
    EXPECT_EQ(told[0].kind, DeviationKind::kGouge);
    EXPECT_NEAR(told[0].depth_mm, 0.03, 0.15 * chord + 5e-4);
    const Comparison moved = run(6.0, 0.08);
    EXPECT_GE(moved.patches.size(), 1u) << chord;
    EXPECT_GE(moved.patches.size() + moved.undecided.size(), 2u) << chord;
    for (const DeviationPatch& p : moved.patches) EXPECT_NEAR(p.depth_mm, 0.08, 0.15 * chord + 5e-4);
  }
}

}  // namespace
}  // namespace proveout
