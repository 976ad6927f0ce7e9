// Scans of bodies whose deviations are known.
#include "removal/compare/fit/scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "shapes.h"

namespace proveout {
namespace {

using testing::HasSubstr;

const Vec3 kLow(0, 0, 0), kHigh(40, 30, 10);
constexpr double kStep = 0.25;

/// Points in a square grid on the faces of a box; `take` says which, and moves them.
template <typename Take>
std::vector<Vec3> gridOf(const Take& take) {
  std::vector<Vec3> out;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool up : {false, true}) {
      for (double a = kLow[u] + 0.5 * kStep; a < kHigh[u]; a += kStep) {
        for (double b = kLow[v] + 0.5 * kStep; b < kHigh[v]; b += kStep) {
          Vec3 p, n = Vec3::Zero();
          n[axis] = up ? 1.0 : -1.0;
          p[axis] = up ? kHigh[axis] : kLow[axis];
          p[u] = a;
          p[v] = b;
          if (take(p, n)) out.push_back(p);
        }
      }
    }
  }
  return out;
}

ScanOptions options() {
  ScanOptions out;
  out.compare.gouge_mm = 0.02;
  out.compare.excess_mm = 0.05;
  out.compare.resolution_mm = 0.5;
  return out;
}

ScanComparison compared(const std::vector<Vec3>& points, const ScanOptions& with = options()) {
  Progress progress;
  Result<ScanComparison> out = compareScan(points, shapes::box(kLow, kHigh), with, progress);
  EXPECT_TRUE(out) << out.error().message;
  return out ? std::move(*out) : ScanComparison();
}

TEST(Scan, ARightPartPassesAndIsCovered) {
  const ScanComparison found = compared(gridOf([](Vec3& p, const Vec3& n) {
    p += 0.01 * n;
    return true;
  }));
  EXPECT_TRUE(found.comparison.pass());
  EXPECT_EQ(found.off, 0u);
  EXPECT_NEAR(found.spacing_mm, kStep, 0.2 * kStep);
  EXPECT_NEAR(found.reach_mm, 2.0 * found.spacing_mm, 1e-12);
  EXPECT_NEAR(found.coverage, 1.0, 1e-3);
  EXPECT_NEAR(found.comparison.rms_mm, 0.01, 1e-6);
  EXPECT_NEAR(found.comparison.p95_mm, 0.01, 1e-6);
  EXPECT_NEAR(found.comparison.max_excess_mm, 0.01, 1e-6);
  EXPECT_EQ(found.comparison.max_gouge_mm, 0.0);
}

TEST(Scan, OneFaceAloneIsCoveredByItsShareAndNoMore) {
  const ScanComparison found = compared(gridOf([](Vec3&, const Vec3& n) { return n.z() > 0.5; }));
  const double top = 40 * 30, all = 2.0 * (40 * 30 + 40 * 10 + 30 * 10);
  // Samples on the edges stand for a narrow strip of the side faces, too.
  EXPECT_NEAR(found.coverage, top / all, 140 * 0.25 / all);
  EXPECT_TRUE(found.comparison.pass());
  // The rest says nothing: neither a figure nor a colour.
  EXPECT_NEAR(found.comparison.machined.area_mm2, found.coverage * all, 1e-6 * all);
  const auto& of_vertex = found.comparison.vertex_deviation;
  EXPECT_EQ(std::count_if(of_vertex.begin(), of_vertex.end(), [](float d) { return std::isnan(d); }), 4);
  EXPECT_TRUE(std::isnan(found.comparison.field->at({20, 15, 0})));
  EXPECT_EQ(found.comparison.field->at({20, 15, 10}), 0.0f);
}

TEST(Scan, GougesAndExcessAreFoundAtTheirDeepestPoints) {
  const ScanComparison found = compared(gridOf([](Vec3& p, const Vec3& n) {
    if (n.z() > 0.5 && (p - Vec3(10, 10, 10)).norm() < 3.0)
      p.z() -= 0.1 - 0.02 * (p - Vec3(10, 10, 10)).norm();
    if (n.x() > 0.5 && std::abs(p.y() - 15) < 2.0 && std::abs(p.z() - 5) < 2.0) p.x() += 0.3;
    return true;
  }));
  const auto& patches = found.comparison.patches;
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches[0].kind, DeviationKind::kExcess);
  EXPECT_NEAR(patches[0].depth_mm, 0.3, 1e-6);
  EXPECT_NEAR(patches[0].where.x(), 40.3, 1e-5);
  EXPECT_NEAR(patches[0].area_mm2, 16.0, 5.0);
  EXPECT_EQ(patches[1].kind, DeviationKind::kGouge);
  EXPECT_NEAR(patches[1].depth_mm, 0.1, 0.005);
  EXPECT_LT((patches[1].where - Vec3(10, 10, 9.9)).norm(), 0.3);
  EXPECT_GT(patches[1].normal.z(), 0.99);
  EXPECT_EQ(patches[1].allowed_mm, 0.02);
  EXPECT_NEAR(found.comparison.max_excess_mm, 0.3, 1e-6);
}

TEST(Scan, ASinglePointBeyondToleranceIsNotLost) {
  std::vector<Vec3> points = gridOf([](Vec3&, const Vec3&) { return true; });
  points.push_back({17.03, 11.07, 10.2});
  const ScanComparison found = compared(points);
  ASSERT_EQ(found.comparison.patches.size(), 1u);
  EXPECT_NEAR(found.comparison.patches[0].depth_mm, 0.2, 1e-6);
  EXPECT_LT((found.comparison.patches[0].where - Vec3(17.03, 11.07, 10.2)).norm(), 1e-9);
}

TEST(Scan, WhatIsFarOffIsCountedAndNotJudged) {
  std::vector<Vec3> points = gridOf([](Vec3&, const Vec3&) { return true; });
  for (int k = 0; k < 50; ++k) points.emplace_back(k, 60, -5);  // the table
  const ScanComparison found = compared(points);
  EXPECT_EQ(found.off, 50u);
  EXPECT_EQ(found.points, points.size() - 50);
  EXPECT_TRUE(found.comparison.pass());
}

TEST(Scan, TheOtherSideOfAThinWallIsNotShown) {
  const TriMesh sheet = shapes::box({0, 0, 0}, {20, 20, 0.1});
  std::vector<Vec3> points;
  for (double x = 0.125; x < 20; x += 0.25)
    for (double y = 0.125; y < 20; y += 0.25) points.emplace_back(x, y, 0.1);
  Progress progress;
  const Result<ScanComparison> found = compareScan(points, sheet, options(), progress);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->coverage, 0.5, 0.02);
}

TEST(Scan, IgnoredRegionsAreLeftOut) {
  ScanOptions with = options();
  with.compare.ignored.push_back({"top", {{-1, -1, 9}, {41, 31, 11}}});
  const ScanComparison found = compared(gridOf([](Vec3& p, const Vec3& n) {
                                          if (n.z() > 0.5) p.z() -= 0.5;
                                          return true;
                                        }),
                                        with);
  EXPECT_TRUE(found.comparison.pass());
  EXPECT_EQ(found.off, 0u);
  EXPECT_GT(found.coverage, 0.99);
}

TEST(Scan, AnOpenMeshGivesPointsOnItsTriangles) {
  TriMesh open;
  open.positions = {{0, 0, 10}, {40, 0, 10}, {40, 30, 10}, {0, 30, 10}};
  open.triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Vec3> points = scanPointsOf(open, 0.5);
  EXPECT_GT(points.size(), 4000u);
  const ScanComparison found = compared(points);
  EXPECT_TRUE(found.comparison.pass());
  EXPECT_GT(found.coverage, 0.3);
  EXPECT_LT(found.coverage, 0.36);
  open.triangles.clear();
  EXPECT_EQ(scanPointsOf(open, 0.5).size(), 4u);
}

TEST(Scan, DoesNotDependOnThreadsOrOrder) {
  const auto wave = [](Vec3& p, const Vec3& n) {
    p += 0.03 * std::sin(p.x()) * n;
    return true;
  };
  std::vector<Vec3> points = gridOf(wave);
  const ScanComparison many = compared(points);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const ScanComparison alone = compared(points);
  EXPECT_EQ(many.comparison.rms_mm, alone.comparison.rms_mm);
  EXPECT_EQ(many.comparison.patches.size(), alone.comparison.patches.size());
  EXPECT_EQ(many.coverage, alone.coverage);
  double squares = 0.0;
  for (const Vec3& p : points) {
    const double off = (p.cwiseMax(kLow).cwiseMin(kHigh) - p).norm();
    squares += off > 0.0 ? off * off : std::pow((p - kLow).cwiseMin(kHigh - p).minCoeff(), 2.0);
  }
  EXPECT_NEAR(many.comparison.rms_mm, std::sqrt(squares / static_cast<double>(points.size())), 1e-4);
}

TEST(Scan, BadInputIsRefused) {
  const auto messageOf = [](const std::vector<Vec3>& points, const TriMesh& nominal) {
    Progress progress;
    const Result<ScanComparison> out = compareScan(points, nominal, options(), progress);
    EXPECT_FALSE(out);
    return out ? std::string() : out.error().message;
  };
  const TriMesh box = shapes::box(kLow, kHigh);
  EXPECT_THAT(messageOf({}, box), HasSubstr("no points"));
  EXPECT_THAT(messageOf({{0, 0, std::numeric_limits<double>::quiet_NaN()}}, box), HasSubstr("not finite"));
  TriMesh open = box;
  open.triangles.pop_back();
  EXPECT_THAT(messageOf({{0, 0, 0}}, open), HasSubstr("not closed"));
}

TEST(Scan, FewPointsAreComparedAllTheSame) {
  const ScanComparison found = compared({{20, 15, 10.01}});
  EXPECT_EQ(found.points, 1u);
  EXPECT_TRUE(found.comparison.pass());
  EXPECT_LT(found.coverage, 0.01);
  EXPECT_NEAR(found.comparison.max_excess_mm, 0.01, 1e-6);
}

TEST(Scan, AStopIsHeeded) {
  Progress progress;
  progress.cancel();
  const Result<ScanComparison> out = compareScan({{0, 0, 0}}, shapes::box(kLow, kHigh), options(), progress);
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().kind, ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace proveout
