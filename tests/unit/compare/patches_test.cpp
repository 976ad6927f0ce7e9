// Regions of known depth, area and volume.
#include <gtest/gtest.h>

#include "removal/compare/compare.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using shapes::blocks;

Comparison compared(const TriMesh& machined, const TriMesh& nominal, const CompareOptions& options) {
  Progress progress;
  auto result = compareToNominal(machined, nominal, options, progress);
  EXPECT_TRUE(result.ok()) << result.error().message;
  return std::move(result).value();
}

/// Plate 20 x 16 x 15 with its top at z = 0, and a feature x 8..12, y 6..9 that reaches from z = `low` to
/// `high`.
TriMesh plate(double low, double high, bool pit, bool boss) {
  return blocks({0, 8, 12, 20}, {0, 6, 9, 16}, {-15, low, 0, high}, [=](int i, int j, int k) {
    const bool feature = i == 1 && j == 1;
    return k == 0 || (k == 1 && !(pit && feature)) || (k == 2 && boss && feature);
  });
}

TEST(Patches, PlantedPitIsFoundWithItsDepthAreaVolumeAndMotion) {
  TriMesh machined = plate(-0.5, 1, true, false);
  for (const auto& t : machined.triangles) {
    const Vec3 c =
        (machined.positions[t[0]] + machined.positions[t[1]] + machined.positions[t[2]]).cast<double>() / 3;
    const bool in_pit =
        c.x() > 7.9 && c.x() < 12.1 && c.y() > 5.9 && c.y() < 9.1 && c.z() < -0.1 && c.z() > -0.6;
    machined.motion.push_back(!in_pit ? 3 : c.z() < -0.4 ? 7 : 8);
  }
  const Comparison c = compared(machined, plate(-0.5, 1, false, false), {.resolution_mm = 0.25});
  ASSERT_EQ(c.patches.size(), 1u);
  const DeviationPatch& p = c.patches[0];
  EXPECT_EQ(p.kind, DeviationKind::kGouge);
  EXPECT_NEAR(p.depth_mm, 0.5, 1e-6);
  EXPECT_NEAR(p.where.z(), -0.5, 1e-6);
  EXPECT_NEAR(p.area_mm2, 12.0 + 14.0 * (0.5 - 0.02), 0.01);  // floor, and walls below the tolerance
  EXPECT_NEAR(p.volume_mm3, 6.0, 0.001);
  EXPECT_EQ(p.maker.motion, 7u);
  EXPECT_EQ(p.makers[0].maker.motion, 7u);
  EXPECT_NEAR(p.makers[0].share, 12.0 / (12.0 + 14.0 * 0.48), 1e-3);
  EXPECT_FALSE(p.from_nominal_only);
  EXPECT_NEAR(p.bounds.min.x(), 8, 1e-6);
  EXPECT_NEAR(p.bounds.max.y(), 9, 1e-6);
  EXPECT_NEAR(c.max_gouge_mm, 0.5, 1e-6);
  EXPECT_NEAR(c.max_excess_mm, 0.0, 1e-6);
  EXPECT_FALSE(c.pass());
}

TEST(Patches, AGougeIsBlamedOnAMotionEvenWhereTheBlankSharesIt) {
  // The floor of the pit is the blank's, its walls are cut: the deepest point lies on triangles of both.
  TriMesh machined = plate(-0.5, 1, true, false);
  for (const auto& t : machined.triangles) {
    const Vec3 c =
        (machined.positions[t[0]] + machined.positions[t[1]] + machined.positions[t[2]]).cast<double>() / 3;
    const bool wall =
        c.z() < -0.1 && c.z() > -0.4 && c.x() > 7.9 && c.x() < 12.1 && c.y() > 5.9 && c.y() < 9.1;
    machined.motion.push_back(wall ? 8 : kNoMotion);
  }
  const Comparison c = compared(machined, plate(-0.5, 1, false, false), {.resolution_mm = 0.25});
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_EQ(c.patches[0].maker.motion, 8u);
  EXPECT_EQ(c.patches[0].makers[0].maker.motion, 8u);
}

TEST(Patches, MissingBossIsAGougeAsHighAsTheBoss) {
  const Comparison c =
      compared(plate(-5, 3, false, false), plate(-5, 3, false, true), {.resolution_mm = 0.25});
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_EQ(c.patches[0].kind, DeviationKind::kGouge);
  EXPECT_NEAR(c.patches[0].depth_mm, 3.0, 1e-6);
  EXPECT_NEAR(c.patches[0].where.z(), 3.0, 1e-6);
  EXPECT_NEAR(c.patches[0].volume_mm3, 4 * 3 * 3.0, 0.05);
  EXPECT_FALSE(c.patches[0].from_nominal_only);
  // The rim is within tolerance of the walls. What is missing shows on the nominal.
  EXPECT_NEAR(c.patches[0].machined_area_mm2, (4 - 0.04) * (3 - 0.04), 0.02);
  EXPECT_NEAR(c.patches[0].nominal_area_mm2, 4 * 3 + 14 * (3 - 0.02), 0.02);
  EXPECT_EQ(c.patches[0].area_mm2, c.patches[0].nominal_area_mm2);
}

TEST(Patches, UncutPocketIsExcessToItsFloor) {
  const Comparison c =
      compared(plate(-5, 3, false, false), plate(-5, 3, true, false), {.resolution_mm = 0.25});
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_EQ(c.patches[0].kind, DeviationKind::kExcess);
  EXPECT_NEAR(c.patches[0].depth_mm, 5.0, 1e-6);
  EXPECT_NEAR(c.patches[0].where.z(), -5.0, 1e-6);
  EXPECT_NEAR(c.patches[0].volume_mm3, 4 * 3 * 5.0, 0.05);
  EXPECT_NEAR(c.max_excess_mm, 5.0, 1e-6);
}

TEST(Patches, NarrowUndrilledHoleIsSeenFromTheNominalSide) {
  const auto part = [](bool drilled) {
    return blocks({0, 8.03, 8.13, 20}, {0, 6.47, 6.57, 16}, {-15, -4, 0},
                  [=](int i, int j, int k) { return !(drilled && i == 1 && j == 1 && k == 1); });
  };
  // The machined plate has no vertex near the mouth of the hole and its samples are coarser than the hole.
  const Comparison c = compared(shapes::box({0, 0, -15}, {20, 16, 0}), part(true), {.resolution_mm = 2.0});
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_TRUE(c.patches[0].from_nominal_only);
  EXPECT_EQ(c.patches[0].kind, DeviationKind::kExcess);
  EXPECT_NEAR(c.patches[0].depth_mm, 4.0, 1e-6);
  EXPECT_NEAR(c.patches[0].volume_mm3, 0.1 * 0.1 * 4, 1e-4);
  EXPECT_TRUE(compared(part(true), part(true), {.resolution_mm = 2.0}).pass());
}

TEST(Patches, SeparateFaultsStaySeparateAndAreSortedByDepth) {
  const auto part = [](bool faulty) {
    return blocks({0, 4, 6, 10, 13, 20}, {0, 5, 8, 20}, {-10, -2, -0.4, 0, 0.3}, [=](int i, int j, int k) {
      if (faulty && i == 1 && j == 1) return k <= 0;  // pit 2 deep
      if (faulty && i == 3 && j == 1) return k <= 3;  // burr 0.3 high
      if (faulty && i == 2 && j == 1) return k <= 2;
      return k <= 2;
    });
  };
  const Comparison c = compared(part(true), part(false), {.resolution_mm = 0.5});
  ASSERT_EQ(c.patches.size(), 2u);
  EXPECT_EQ(c.patches[0].kind, DeviationKind::kGouge);
  EXPECT_NEAR(c.patches[0].depth_mm, 2.0, 1e-6);
  EXPECT_NEAR(c.patches[0].volume_mm3, 2 * 3 * 2.0, 0.02);
  EXPECT_EQ(c.patches[1].kind, DeviationKind::kExcess);
  EXPECT_NEAR(c.patches[1].depth_mm, 0.3, 1e-6);
  EXPECT_NEAR(c.patches[1].volume_mm3, 3 * 3 * 0.3, 0.01);
}

TEST(Patches, SphereTooSmallIsOneGougeAllOver) {
  const TriMesh machined = shapes::sphere({3, -2, 5}, 9.9, 6), nominal = shapes::sphere({3, -2, 5}, 10, 6);
  const Comparison c = compared(machined, nominal, {.resolution_mm = 0.5});
  ASSERT_EQ(c.patches.size(), 1u);
  const double area = 4 * kPi * 9.9 * 9.9;
  EXPECT_NEAR(c.patches[0].depth_mm, 0.1, 0.002);
  EXPECT_NEAR(c.patches[0].machined_area_mm2 / area, 1.0, 0.002);
  EXPECT_NEAR(c.patches[0].nominal_area_mm2 / (4 * kPi * 100), 1.0, 0.002);
  EXPECT_NEAR(c.patches[0].volume_mm3 / (4.0 / 3.0 * kPi * (1000 - 9.9 * 9.9 * 9.9)), 1.0, 0.002);
  EXPECT_NEAR(c.rms_mm, 0.1, 0.002);
  EXPECT_NEAR(c.p95_mm, 0.1, 0.002);
  double chord = 0.0;
  for (const auto& t : nominal.triangles) {
    Vec3 middle = Vec3::Zero();
    for (const auto v : t) middle += nominal.positions[v].cast<double>() / 3.0;
    chord = std::max(chord, 10.0 - (middle - Vec3(3, -2, 5)).norm());
  }
  EXPECT_NEAR(c.nominal_chord_mm / chord, 1.0, 0.1);
}

TEST(Patches, FiguresCountWhatOnlyTheNominalHas) {
  // A lost rib: no sample of the part is far off, all of the rib's are.
  const TriMesh plate = shapes::box({0, 0, 0}, {40, 30, 10});
  const TriMesh ribbed = shapes::blocks({0, 19, 21, 40}, {0, 30}, {0, 10, 18},
                                        [](int i, int, int k) { return k == 0 || i == 1; });
  Progress progress;
  const auto c = compareToNominal(plate, ribbed, {.resolution_mm = 0.5}, progress);
  ASSERT_TRUE(c.ok());
  const double sides = 2 * 30 * 8 + 2 * 2 * 8, top = 2 * 30, all = meshArea(ribbed);
  // Distances from the rib to the plate: its walls' heights, and 8 on the top. The worse surface is told.
  const double squares = sides * 8.0 * 8.0 / 3.0 + top * 8.0 * 8.0;
  EXPECT_NEAR(c->rms_mm, std::sqrt(squares / all), 0.03 * std::sqrt(squares / all));
  // What is left out counts nowhere.
  CompareOptions ignoring{.resolution_mm = 0.5};
  ignoring.ignored.push_back({"rib", {{18, -1, 9.9}, {22, 31, 19}}});
  const auto left_out = compareToNominal(plate, ribbed, ignoring, progress);
  ASSERT_TRUE(left_out.ok());
  EXPECT_TRUE(left_out->pass());
  EXPECT_LT(left_out->rms_mm, 1e-3);
}

}  // namespace
}  // namespace proveout
