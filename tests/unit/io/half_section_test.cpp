#include "io/report/half_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "profile_fixtures.h"

namespace proveout {
namespace {

using io_test::gougedLoop;
using io_test::shaftLoop;
using io_test::turned;

double area(const std::vector<Vec2>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

std::vector<SectionSegment> segmentsOf(const std::vector<Vec2>& loop) {
  std::vector<SectionSegment> segments;
  for (std::size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return segments;
}

TEST(HalfSection, SegmentsLieOnTheProfile) {
  const TriMesh mesh = turned(shaftLoop(), 48);
  ASSERT_TRUE(analyseTopology(mesh).closedManifold());
  ASSERT_GT(meshVolume(mesh), 0.0);
  double length = 0;
  for (const auto& [a, b] : halfSection(mesh)) {
    length += (b - a).norm();
    for (const Vec2& p : {a, b}) {
      EXPECT_GE(p.x(), 0.0);
      const bool on_wall = std::abs(p.x() - (p.y() < 20 ? 10 : 15)) < 1e-5;
      const bool on_face = std::min({std::abs(p.y()), std::abs(p.y() - 20), std::abs(p.y() - 40)}) < 1e-5;
      EXPECT_TRUE(on_wall || on_face) << p.transpose();
    }
  }
  EXPECT_NEAR(length, 10 + 20 + 5 + 20 + 15, 1e-4);  // without the axis
}

TEST(HalfSection, LoopsEncloseTheSection) {
  const TriMesh shaft = turned(shaftLoop(), 48);
  const auto loops = halfSectionLoops(shaft);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(std::abs(area(loops[0])), 10 * 20 + 15 * 20, 1e-3);
  // A ring: two loops in the plane, one in the half plane.
  const auto ring = halfSectionLoops(turned({{6, 0}, {10, 0}, {10, 5}, {6, 5}}, 36));
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_NEAR(std::abs(area(ring[0])), 20, 1e-4);
}

TEST(HalfSection, OfNothingIsNothing) {
  TriMesh mesh;
  EXPECT_TRUE(halfSection(mesh).empty());
  EXPECT_TRUE(halfSectionLoops(mesh).empty());
  mesh.positions = {{1, 1, 0}, {2, 1, 0}, {1, 2, std::numeric_limits<float>::quiet_NaN()}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 7}};  // not finite; out of range
  EXPECT_TRUE(halfSection(mesh).empty());
  EXPECT_TRUE(halfSectionLoops(mesh).empty());
}

TEST(ProfileDeviations, FindsTheGougeAndItsPlace) {
  const ProfileDeviations found = profileDeviations({gougedLoop()}, segmentsOf(shaftLoop()));
  EXPECT_NEAR(found.largest_gouge_mm, 0.05, 1e-12);
  EXPECT_NEAR(found.gouge_at.x(), 9.95, 1e-12);
  EXPECT_NEAR(found.gouge_at.y(), 12.0, 0.05);  // the middle of the groove
  EXPECT_NEAR(found.largest_excess_mm, 0.0, 1e-12);
  EXPECT_LE(found.samples.size(), kMaxProfileSamples);
  EXPECT_GE(found.samples.size(), kMaxProfileSamples * 9 / 10);
}

TEST(ProfileDeviations, NominalFromAMeshGivesTheSame) {
  const ProfileDeviations found = profileDeviations({gougedLoop()}, halfSection(turned(shaftLoop(), 64)));
  EXPECT_NEAR(found.largest_gouge_mm, 0.05, 1e-5);
  EXPECT_NEAR(found.largest_excess_mm, 0.0, 1e-5);
}

TEST(ProfileDeviations, ExcessIsPositiveForEitherDirection) {
  std::vector<Vec2> thick = shaftLoop();
  for (Vec2& p : thick) p.x() += p.x() > 12 ? 0.125 : 0.0;
  for (const bool clockwise : {false, true}) {
    if (clockwise) std::reverse(thick.begin(), thick.end());
    const ProfileDeviations found = profileDeviations({thick}, segmentsOf(shaftLoop()));
    EXPECT_NEAR(found.largest_excess_mm, 0.125, 1e-12);
    EXPECT_NEAR(found.largest_gouge_mm, 0.0, 1e-12);
    for (const SectionSample& sample : found.samples) {
      if (sample.at.y() < 20.5 || sample.at.y() > 39.5) continue;
      EXPECT_NEAR(sample.deviation_mm, 0.125, 1e-12);
      EXPECT_NEAR((sample.nearest - Vec2(15, sample.at.y())).norm(), 0.0, 1e-12);
    }
  }
}

TEST(ProfileDeviations, BoresThatAreTooLargeAreGouged) {
  const std::vector<Vec2> outer{{5, 0}, {20, 0}, {20, 30}, {5, 30}};
  const std::vector<Vec2> hollow{{10, 10}, {15, 10}, {15, 20}, {10, 20}};
  std::vector<Vec2> larger = hollow;
  larger[1].x() = larger[2].x() = 15.03;
  std::vector<SectionSegment> nominal = segmentsOf(outer);
  for (const SectionSegment& s : segmentsOf(hollow)) nominal.push_back(s);
  const ProfileDeviations found = profileDeviations({outer, larger}, nominal);
  EXPECT_NEAR(found.largest_gouge_mm, 0.03, 1e-12);
  EXPECT_NEAR(found.largest_excess_mm, 0.0, 1e-12);
  EXPECT_NEAR(found.gouge_at.x(), 15.03, 1e-12);
}

TEST(ProfileDeviations, ManyCornersAreSampledEvenly) {
  std::vector<Vec2> ball{{0, 0}};
  for (int i = 0; i <= 5000; ++i) {
    const double a = kPi * i / 5000 - 0.5 * kPi;
    ball.emplace_back(10.02 * std::cos(a), 10.02 * std::sin(a));
  }
  ball.front() = ball.back() = Vec2(0, 10.02);
  ball[1] = Vec2(0, -10.02);
  ball.erase(ball.begin());
  std::vector<SectionSegment> nominal;
  for (int i = 0; i < 1000; ++i) {
    const auto at = [](int k) {
      return Vec2(10 * std::cos(kPi * k / 1000 - 0.5 * kPi), 10 * std::sin(kPi * k / 1000 - 0.5 * kPi));
    };
    nominal.push_back({at(i), at(i + 1)});
  }
  const ProfileDeviations found = profileDeviations({ball}, nominal);
  EXPECT_LE(found.samples.size(), kMaxProfileSamples);
  EXPECT_GE(found.samples.size(), kMaxProfileSamples - 10);
  EXPECT_NEAR(found.largest_excess_mm, 0.02, 2e-5);  // chords of the nominal
  EXPECT_EQ(found.largest_gouge_mm, 0.0);
}

TEST(ProfileDeviations, NoneWithoutInput) {
  EXPECT_TRUE(profileDeviations({}, segmentsOf(shaftLoop())).samples.empty());
  EXPECT_TRUE(profileDeviations({shaftLoop()}, {}).samples.empty());
  EXPECT_TRUE(profileDeviations({{Vec2(1, 1)}}, segmentsOf(shaftLoop())).samples.empty());
  std::vector<Vec2> broken = shaftLoop();
  broken[2].y() = std::nan("");
  EXPECT_TRUE(profileDeviations({broken}, segmentsOf(shaftLoop())).samples.empty());
}

}  // namespace
}  // namespace proveout
