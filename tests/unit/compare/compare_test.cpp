#include "removal/compare/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using testing::HasSubstr;

Comparison compared(const TriMesh& machined, const TriMesh& nominal, const CompareOptions& options) {
  Progress progress;
  auto result = compareToNominal(machined, nominal, options, progress);
  EXPECT_TRUE(result.ok()) << result.error().message;
  return std::move(result).value();
}

const TriMesh kNominalBox = shapes::box({0, 0, 0}, {10, 10, 10});

TEST(Compare, EqualMeshesPass) {
  const Comparison c = compared(kNominalBox, kNominalBox, {});
  EXPECT_TRUE(c.pass());
  EXPECT_NEAR(c.max_gouge_mm, 0, 1e-9);
  EXPECT_NEAR(c.max_excess_mm, 0, 1e-9);
  EXPECT_NEAR(c.rms_mm, 0, 1e-9);
  EXPECT_EQ(c.nominal_chord_mm, 0.0);
  EXPECT_EQ(c.vertex_deviation.size(), kNominalBox.positions.size());
  EXPECT_GT(c.machined_samples, 6 * 33 * 33u);
}

TEST(Compare, ShiftedBoxIsExcessAheadAndGougeBehind) {
  const TriMesh machined = shapes::box({0.1, 0, 0}, {10.1, 10, 10});
  const Comparison c = compared(machined, kNominalBox, {.resolution_mm = 0.5});
  ASSERT_EQ(c.patches.size(), 2u);
  for (const DeviationPatch& p : c.patches) {
    EXPECT_NEAR(p.depth_mm, 0.1, 1e-6);
    // Towards the rim of the face the nearest nominal point is on the side: samples are 0.75 mm apart there.
    EXPECT_NEAR(p.volume_mm3, 10.0, 0.5);
    EXPECT_GT(p.area_mm2, 94.0);
    EXPECT_LT(p.area_mm2, 100 + 4 * 10 * 0.5);  // the rim of the side faces, as wide as a sample at most
    EXPECT_NEAR(p.where.x(), p.kind == DeviationKind::kExcess ? 10.1 : p.from_nominal_only ? 0.0 : 0.1, 0.11);
  }
  EXPECT_NE(c.patches[0].kind, c.patches[1].kind);
  for (std::size_t i = 0; i < machined.positions.size(); ++i) {
    EXPECT_NEAR(c.vertex_deviation[i], machined.positions[i].x() > 5 ? 0.1 : 0.0, 1e-6);
  }
}

TEST(Compare, IgnoredRegionsAreLeftOutAndTold) {
  const TriMesh machined = shapes::box({0.1, 0, 0}, {10.1, 10, 10});
  IgnoredRegion right, left;
  right.box.min.x() = 9.0;
  CompareOptions options{.resolution_mm = 0.5};
  options.ignored = {right};
  const Comparison half = compared(machined, kNominalBox, options);
  ASSERT_EQ(half.patches.size(), 1u);
  EXPECT_EQ(half.patches[0].kind, DeviationKind::kGouge);
  EXPECT_LT(half.max_excess_mm, 0.001);
  ASSERT_EQ(half.ignored_mm2.size(), 1u);
  // The end face, and of the sides, whose two triangles each reach far beyond, what lies in the region.
  EXPECT_NEAR(half.ignored_mm2[0], 100.0 + 4 * 10 * 1.1, 6.0);
  for (std::size_t i = 0; i < machined.positions.size(); ++i)
    EXPECT_EQ(std::isnan(half.vertex_deviation[i]), machined.positions[i].x() > 9.0f);
  // By radius: everything nearer to the axis than 5.
  left.outer_radius = 20.0;
  options.ignored = {right, left};
  EXPECT_TRUE(compared(machined, kNominalBox, options).pass());
}

TEST(Compare, WithinToleranceIsNoPatch) {
  const TriMesh machined = shapes::box({0.015, 0, 0}, {10.015, 10, 10});
  const Comparison c =
      compared(machined, kNominalBox, {.gouge_mm = 0.02, .excess_mm = 0.05, .resolution_mm = 0.5});
  EXPECT_TRUE(c.pass());
  EXPECT_NEAR(c.max_excess_mm, 0.015, 1e-6);
}

TEST(Compare, HistogramHoldsTheWholeArea) {
  const TriMesh machined = shapes::box({-0.03, 0, 0}, {10.03, 10, 10});
  const Comparison c = compared(machined, kNominalBox, {.resolution_mm = 0.5});
  ASSERT_EQ(c.histogram.edges_mm.size(), c.histogram.area_mm2.size() + 1);
  EXPECT_TRUE(std::is_sorted(c.histogram.edges_mm.begin(), c.histogram.edges_mm.end()));
  EXPECT_NEAR(std::accumulate(c.histogram.area_mm2.begin(), c.histogram.area_mm2.end(), 0.0),
              0.5 * (meshArea(machined) + meshArea(kNominalBox)), 1e-3);
  double at_003 = 0.0;
  for (std::size_t i = 0; i < c.histogram.area_mm2.size(); ++i) {
    if (c.histogram.edges_mm[i] < 0.03 && c.histogram.edges_mm[i + 1] > 0.03)
      at_003 = c.histogram.area_mm2[i];
  }
  EXPECT_GT(at_003, 199.0);
  EXPECT_NEAR(c.p95_mm, 0.03, 1e-6);  // a third of the surface is off by 0.03
  EXPECT_NEAR(c.rms_mm, 0.03 * std::sqrt(200 / meshArea(machined)), 0.002);
}

TEST(Compare, NearTheToleranceIsUndecidedAndSaysWhichGridDecides) {
  const TriMesh machined = shapes::box({0, 0, 0}, {10, 10, 10.048});
  CompareOptions options{.excess_mm = 0.05, .resolution_mm = 0.5, .uncertainty_mm = 0.01};
  const Comparison below = compared(machined, kNominalBox, options);
  EXPECT_TRUE(below.patches.empty());
  ASSERT_EQ(below.undecided.size(), 1u);
  EXPECT_FALSE(below.pass());
  EXPECT_NEAR(below.undecided[0].depth_mm, 0.048, 1e-6);
  const double grid = below.undecided[0].deciding_resolution_mm;
  EXPECT_GT(grid, 0.0);
  EXPECT_LT(options.uncertainty_mm * grid * grid / 0.25, 0.002);  // the error there is below the distance
  options.excess_mm = 0.046;
  const Comparison above = compared(machined, kNominalBox, options);
  EXPECT_TRUE(above.patches.empty());
  EXPECT_EQ(above.undecided.size(), 1u);
  options.excess_mm = 0.03;
  EXPECT_EQ(compared(machined, kNominalBox, options).patches.size(), 1u);
  options.excess_mm = 0.06;
  EXPECT_TRUE(compared(machined, kNominalBox, options).pass());
}

TEST(Compare, ErrorAboveTheToleranceNeverPasses) {
  const Comparison c =
      compared(kNominalBox, kNominalBox,
               {.gouge_mm = 0.001, .excess_mm = 0.05, .resolution_mm = 0.5, .uncertainty_mm = 0.003});
  EXPECT_TRUE(c.patches.empty());
  ASSERT_EQ(c.undecided.size(), 1u);
  EXPECT_EQ(c.undecided[0].kind, DeviationKind::kGouge);
  EXPECT_GT(c.undecided[0].deciding_resolution_mm, 0.0);
}

TEST(Compare, ThinWallHasTwoSides) {
  // A wall of 0.1 mm that is 0.04 too thick on one side and 0.04 too thin on the other.
  const TriMesh nominal = shapes::box({0, 0, 0}, {0.1, 10, 10});
  const TriMesh machined = shapes::box({0.04, 0, 0}, {0.14, 10, 10});
  const Comparison c =
      compared(machined, nominal, {.gouge_mm = 0.02, .excess_mm = 0.02, .resolution_mm = 0.3});
  ASSERT_EQ(c.patches.size(), 2u);
  EXPECT_NEAR(c.max_excess_mm, 0.04, 1e-6);
  EXPECT_NEAR(c.max_gouge_mm, 0.04, 1e-6);
  for (const DeviationPatch& p : c.patches) EXPECT_NEAR(p.volume_mm3, 4.0, 0.2);
}

TEST(Compare, ThreadsDoNotChangeAnyBit) {
  const TriMesh machined = shapes::sphere({0.03, 0.01, -0.02}, 10.01, 5),
                nominal = shapes::sphere({0, 0, 0}, 10, 5);
  CompareOptions options{.resolution_mm = 0.4};
  options.threads = 1;
  const Comparison one = compared(machined, nominal, options);
  for (const int threads : {2, 4}) {
    options.threads = threads;
    const Comparison more = compared(machined, nominal, options);
    ASSERT_EQ(more.vertex_deviation.size(), one.vertex_deviation.size());
    EXPECT_EQ(std::memcmp(more.vertex_deviation.data(), one.vertex_deviation.data(),
                          one.vertex_deviation.size() * sizeof(float)),
              0);
    EXPECT_EQ(more.rms_mm, one.rms_mm);
    EXPECT_EQ(more.histogram.area_mm2, one.histogram.area_mm2);
    ASSERT_EQ(more.patches.size(), one.patches.size());
    for (std::size_t i = 0; i < one.patches.size(); ++i) {
      EXPECT_EQ(more.patches[i].where, one.patches[i].where);
      EXPECT_EQ(more.patches[i].volume_mm3, one.patches[i].volume_mm3);
      EXPECT_EQ(more.patches[i].area_mm2, one.patches[i].area_mm2);
    }
  }
}

TEST(Compare, RefusesBadOptionsAndOpenMeshes) {
  Progress progress;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error = [&](const TriMesh& m, const TriMesh& n, const CompareOptions& o) {
    const auto r = compareToNominal(m, n, o, progress);
    return r.ok() ? std::string("accepted") : r.error().message;
  };
  EXPECT_THAT(error(kNominalBox, kNominalBox, {.gouge_mm = -1}), HasSubstr("gouge"));
  EXPECT_THAT(error(kNominalBox, kNominalBox, {.excess_mm = nan}), HasSubstr("excess"));
  EXPECT_THAT(error(kNominalBox, kNominalBox, {.resolution_mm = 0}), HasSubstr("spacing"));
  EXPECT_THAT(error(kNominalBox, kNominalBox, {.uncertainty_mm = nan}), HasSubstr("uncertainty"));
  TriMesh open = kNominalBox;
  open.triangles.pop_back();
  EXPECT_THAT(error(open, kNominalBox, {}), HasSubstr("machined mesh is not closed at X"));
  EXPECT_THAT(error(kNominalBox, open, {}), HasSubstr("nominal mesh is not closed at X"));
  EXPECT_THAT(error({}, kNominalBox, {}), HasSubstr("no triangles"));
  TriMesh bad = kNominalBox;
  bad.positions[0].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(error(bad, kNominalBox, {}), HasSubstr("not a finite number"));
  TriMesh one_motion = kNominalBox;
  one_motion.motion = {1};
  EXPECT_THAT(error(one_motion, kNominalBox, {}), HasSubstr("motion"));
}

TEST(Compare, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  const auto r = compareToNominal(kNominalBox, kNominalBox, {}, progress);
  ASSERT_FALSE(r.ok());
  EXPECT_EQ(r.error().kind, ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace proveout
