// What is told of differences, against booleans of the same meshes by CGAL.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "removal/compare/compare.h"
#include "tests/support/lofts.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

/// What "a without b" is: its volume, and how much of a's surface bounds it.
struct Difference {
  double volume = 0.0, area = 0.0;
};
Difference differenceOf(const TriMesh& a, const TriMesh& b) {
  const TriMesh rest = booleanOf(a, b, BooleanKind::kDifference).value(),
                common = booleanOf(a, b, BooleanKind::kIntersection).value();
  // The rest is bounded by a's surface outside of b and b's inside of a; the common part by the other pieces.
  return {meshVolume(rest), 0.5 * (meshArea(rest) + meshArea(a) - meshArea(common))};
}

TriMesh moved(TriMesh mesh, const Eigen::Matrix3d& turn, const Vec3& shift) {
  for (auto& p : mesh.positions) p = (turn * p.cast<double>() + shift).cast<float>();
  return mesh;
}

/// Parts of about 20 mm with faces of all kinds.
TriMesh randomPart(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto between = [&](double a, double b) { return a + (b - a) * unit(random); };
  constexpr double kChord = 0.002;
  switch (random() % 4) {
    case 0:
      return shapes::box({-10, -8, -5}, {between(5, 12), between(4, 9), between(3, 8)});
    case 1:
      return shapes::sphere({0, 0, 0}, between(7, 10), 5);
    case 2:
      return lofts::solid(lofts::Profile().line(between(2, 5), -6).line(between(2, 5), between(2, 6)),
                          {between(3, 8), between(0.5, 6)}, kChord);
    default:
      return lofts::plateWith(shapes::box({-12, -9, -6}, {12, 9, 6}),
                              {{lofts::Profile().line(between(2, 4), -8).line(between(2, 4), 8),
                                {between(-4, 4), between(-2, 2)},
                                {between(0.0, 3.0), 0.0}}},
                              kChord);
  }
}

TEST(Difference, VolumesAndAreasAreThoseOfBooleans) {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> unit(-1, 1);
  Progress progress;
  constexpr int kPairs = 20;
  int pairs = 0;
  for (int attempt = 0; pairs < kPairs && attempt < 2 * kPairs; ++attempt) {
    const TriMesh a = randomPart(random);
    // Half of the pairs: the same part a little shifted or turned; the others: different parts.
    const bool same = attempt % 2 == 0;
    const Vec3 axis(unit(random), unit(random), unit(random)),
        shift(unit(random), unit(random), unit(random));
    const double size = same ? 0.3 : 2.0;
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.05 * size * unit(random), axis.normalized()));
    const TriMesh b = moved(same ? a : randomPart(random), turn, size * shift);
    Difference left, missing;
    try {
      left = differenceOf(a, b);
      missing = differenceOf(b, a);
    } catch (const std::exception&) {
      continue;  // no manifold: another pair
    }
    ++pairs;
    SCOPED_TRACE(attempt);
    const auto c =
        compareToNominal(a, b, {.gouge_mm = 2e-4, .excess_mm = 2e-4, .resolution_mm = 0.2}, progress);
    ASSERT_TRUE(c.ok()) << c.error().message;
    Difference told[2];
    for (const DeviationPatch& p : c->patches) {
      const bool excess = p.kind == DeviationKind::kExcess;
      told[excess].volume += p.volume_mm3;
      told[excess].area += excess ? p.machined_area_mm2 : p.nominal_area_mm2;
    }
    const double part = meshVolume(b), skin = meshArea(b);
    // Of the difference, and of what nobody looks at: a thousandth of the part.
    EXPECT_NEAR(told[1].volume, left.volume, 0.01 * left.volume + 1e-4 * part);
    EXPECT_NEAR(told[0].volume, missing.volume, 0.01 * missing.volume + 1e-4 * part);
    EXPECT_NEAR(told[1].area, left.area, 0.01 * left.area + 1e-3 * skin);
    EXPECT_NEAR(told[0].area, missing.area, 0.01 * missing.area + 1e-3 * skin);
    EXPECT_NEAR(told[1].volume - told[0].volume, meshVolume(a) - part,
                0.01 * (left.volume + missing.volume) + 1e-4 * part);
  }
  EXPECT_EQ(pairs, kPairs);
}

TEST(Difference, MissingFeaturesHaveTheirWholeVolume) {
  const TriMesh plate = shapes::box({-20, -15, -10}, {20, 15, 0});
  Progress progress;
  const auto volumeOf = [&](const TriMesh& machined, const TriMesh& nominal) {
    const auto c = compareToNominal(machined, nominal, {.resolution_mm = 0.4}, progress);
    EXPECT_TRUE(c.ok());
    double sum = 0.0;
    for (const DeviationPatch& p : c->patches) sum += p.volume_mm3;
    return sum;
  };
  const TriMesh drilled =
      lofts::plateWith(plate, {{lofts::Profile().line(3.4, -12).line(3.4, 2), {5, 2}, {0, 0}}}, 0.002);
  const double hole = meshVolume(plate) - meshVolume(drilled);
  EXPECT_NEAR(volumeOf(plate, drilled), hole, 0.005 * hole);  // a through hole that was not drilled
  EXPECT_NEAR(volumeOf(drilled, plate), hole, 0.005 * hole);
  const TriMesh ball = shapes::insideOut(shapes::sphere({0, 0, -5}, 3.5, 5));
  const TriMesh hollow = shapes::together(plate, ball);
  EXPECT_NEAR(volumeOf(plate, hollow), -meshVolume(ball), -0.005 * meshVolume(ball));  // a cavity
  const TriMesh rib =
      booleanOf(plate, shapes::box({-20, -0.1, -1}, {20, 0.1, 8}), BooleanKind::kUnion).value();
  EXPECT_NEAR(volumeOf(plate, rib), 40 * 0.2 * 8, 0.01 * 40 * 0.2 * 8);
}

}  // namespace
}  // namespace proveout
