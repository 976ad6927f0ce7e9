// Two bodies in closed form against each other: largest deviation, root mean square and 95 % of the area, of
// both surfaces, to a micrometre.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "core/mesh/mesh_placement.h"
#include "removal/compare/compare.h"
#include "removal/compare/deviation_statistics.h"
#include "shapes.h"

namespace proveout {
namespace {

constexpr double kMicrometre = 1e-3;

struct Figures {
  double least = 0.0, most = 0.0, rms = 0.0, p95 = 0.0;
};

/// Of a deviation over a surface that is given by places with their areas: a sum so fine that it is the
/// integral.
class Integral {
 public:
  void add(double deviation, double area) {
    values_.emplace_back(std::abs(deviation), area);
    squares_ += area * deviation * deviation;
    area_ += area;
    least_ = std::min(least_, deviation);
    most_ = std::max(most_, deviation);
  }
  Figures figures() {
    std::sort(values_.begin(), values_.end());
    double sum = 0.0;
    const auto at = std::find_if(values_.begin(), values_.end(), [&](const auto& v) {
      sum += v.second;
      return sum >= 0.95 * area_;
    });
    return {least_, most_, std::sqrt(squares_ / area_), at->first};
  }

 private:
  std::vector<std::pair<double, double>> values_;
  double squares_ = 0.0, area_ = 0.0, least_ = 0.0, most_ = 0.0;
};

Comparison compared(const TriMesh& machined, const TriMesh& nominal, double resolution_mm) {
  CompareOptions options;
  options.gouge_mm = options.excess_mm = 5.0;
  options.resolution_mm = resolution_mm;
  Progress progress;
  Result<Comparison> out = compareToNominal(machined, nominal, options, progress);
  EXPECT_TRUE(out) << out.error().message;
  return std::move(*out);
}

/// Deviations of the machined surface count as they are; at the nominal's a point within the part is excess.
void expectFigures(const DeviationFigures& found, const Figures& wanted, const char* side) {
  EXPECT_NEAR(found.rms_mm, wanted.rms, kMicrometre) << side;
  EXPECT_NEAR(found.p95_mm, wanted.p95, kMicrometre) << side;
  const std::string name = side;
  testing::Test::RecordProperty(name + "_rms_off_nm",
                                static_cast<int>(1e6 * std::abs(found.rms_mm - wanted.rms)));
  testing::Test::RecordProperty(name + "_p95_off_nm",
                                static_cast<int>(1e6 * std::abs(found.p95_mm - wanted.p95)));
}
void expectLargest(const Comparison& found, const Figures& machined, const Figures& nominal) {
  EXPECT_NEAR(found.max_excess_mm, std::max(machined.most, nominal.most), kMicrometre);
  EXPECT_NEAR(found.max_gouge_mm, -std::min(machined.least, nominal.least), kMicrometre);
}

/// A ball of radius r whose centre is off by s: at an angle with cosine u to the shift its surface is
/// sqrt(r^2 + 2 r s u + s^2) - r from the nominal's. Areas go with u evenly (Archimedes).
TEST(AnalyticDeviation, ShiftedSphere) {
  constexpr double kRadius = 10.0, kShift = 0.3;
  const Vec3 shift = kShift * Vec3(2, -1, 2) / 3.0;
  const TriMesh nominal = shapes::sphere({0, 0, 0}, kRadius, 7), machined = shapes::sphere(shift, kRadius, 7);
  const Comparison found = compared(machined, nominal, 0.2);
  Integral on_machined, on_nominal;
  constexpr int kSteps = 200'000;
  for (int k = 0; k < kSteps; ++k) {
    const double u = -1.0 + 2.0 * (k + 0.5) / kSteps;
    on_machined.add(std::sqrt(kRadius * kRadius + 2.0 * kRadius * kShift * u + kShift * kShift) - kRadius,
                    1.0);
    on_nominal.add(kRadius - std::sqrt(kRadius * kRadius - 2.0 * kRadius * kShift * u + kShift * kShift),
                   1.0);
  }
  const Figures machined_wanted = on_machined.figures(), nominal_wanted = on_nominal.figures();
  // In closed form: the mean of (sqrt(a + b u) - r)^2 over u, with a = r^2 + s^2 and b = 2 r s.
  const double a = kRadius * kRadius + kShift * kShift, b = 2.0 * kRadius * kShift;
  const double root = (std::pow(a + b, 1.5) - std::pow(a - b, 1.5)) / (3.0 * b);
  EXPECT_NEAR(machined_wanted.rms, std::sqrt(a + kRadius * kRadius - 2.0 * kRadius * root), 1e-6);
  EXPECT_NEAR(machined_wanted.most, kShift, 1e-5);
  expectFigures(found.machined, machined_wanted, "machined");
  expectFigures(found.nominal, nominal_wanted, "nominal");
  expectLargest(found, machined_wanted, nominal_wanted);
}

/// Signed distance of a box about the origin, with half sizes `h`.
double boxDistance(const Vec3& p, const Vec3& h) {
  const Vec3 q = p.cwiseAbs() - h;
  return q.cwiseMax(Vec3::Zero()).norm() + std::min(0.0, q.maxCoeff());
}

/// A box turned about its middle against another of the same size: each face's places are measured to the
/// other box, and both sides see the same but for the sign.
TEST(AnalyticDeviation, RotatedBox) {
  const Vec3 half(6, 5, 4);
  const RigidTransform turn{rotationXyzDeg({1.5, -1.0, 2.0}), Vec3::Zero()};
  const TriMesh nominal = shapes::box(-half, half);
  TriMesh machined = nominal;
  moveMesh(turn, machined);
  const Comparison found = compared(machined, nominal, 0.04);
  Integral on_machined, on_nominal;
  constexpr int kSteps = 700;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double area = 4.0 * half[u] * half[v] / (kSteps * kSteps);
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
          Vec3 p;
          p[axis] = side * half[axis];
          p[u] = half[u] * (2.0 * (i + 0.5) / kSteps - 1.0);
          p[v] = half[v] * (2.0 * (j + 0.5) / kSteps - 1.0);
          on_machined.add(boxDistance(turn(p), half), area);
          on_nominal.add(-boxDistance(turn.inverse()(p), half), area);
        }
      }
    }
  }
  Figures machined_wanted = on_machined.figures(), nominal_wanted = on_nominal.figures();
  // The corners are where a box sticks out most: eight closed forms.
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                 corner & 4 ? half.z() : -half.z());
    machined_wanted.most = std::max(machined_wanted.most, boxDistance(turn(p), half));
    nominal_wanted.least = std::min(nominal_wanted.least, -boxDistance(turn.inverse()(p), half));
  }
  expectFigures(found.machined, machined_wanted, "machined");
  expectFigures(found.nominal, nominal_wanted, "nominal");
  expectLargest(found, machined_wanted, nominal_wanted);
}

/// About Z: a ring of radius R with a tube of radius r, whose middle is at `center`.
TriMesh torus(const Vec3& center, double ring, double tube, int around, int across) {
  TriMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2.0 * kPi * i / around, b = 2.0 * kPi * j / across, rho = ring + tube * std::cos(b);
      mesh.positions.push_back(
          (center + Vec3(rho * std::cos(a), rho * std::sin(a), tube * std::sin(b))).cast<float>());
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A thicker tube lies off by the same everywhere.
TEST(AnalyticDeviation, OffsetTorus) {
  constexpr double kOffset = 0.25;
  const TriMesh nominal = torus({0, 0, 0}, 15, 4, 900, 240),
                machined = torus({0, 0, 0}, 15, 4 + kOffset, 900, 240);
  const Comparison found = compared(machined, nominal, 0.5);
  const Figures wanted{0.0, kOffset, kOffset, kOffset};
  expectFigures(found.machined, wanted, "machined");
  expectFigures(found.nominal, wanted, "nominal");
  EXPECT_NEAR(found.max_excess_mm, kOffset, kMicrometre);
  EXPECT_EQ(found.max_gouge_mm, 0.0);
}

/// Moved along its axis by s: at an angle b of the tube the surface is sqrt(r^2 + 2 r s sin b + s^2) - r from
/// the nominal's, over an area that goes with R + r cos b.
TEST(AnalyticDeviation, ShiftedTorus) {
  constexpr double kRing = 15.0, kTube = 4.0, kShift = 0.2;
  const TriMesh nominal = torus({0, 0, 0}, kRing, kTube, 900, 240),
                machined = torus({0, 0, kShift}, kRing, kTube, 900, 240);
  const Comparison found = compared(machined, nominal, 0.5);
  Integral on_machined, on_nominal;
  constexpr int kSteps = 200'000;
  for (int k = 0; k < kSteps; ++k) {
    const double b = 2.0 * kPi * (k + 0.5) / kSteps, area = kRing + kTube * std::cos(b),
                 sum = kTube * kTube + kShift * kShift;
    on_machined.add(std::sqrt(sum + 2.0 * kTube * kShift * std::sin(b)) - kTube, area);
    on_nominal.add(kTube - std::sqrt(sum - 2.0 * kTube * kShift * std::sin(b)), area);
  }
  const Figures machined_wanted = on_machined.figures(), nominal_wanted = on_nominal.figures();
  expectFigures(found.machined, machined_wanted, "machined");
  expectFigures(found.nominal, nominal_wanted, "nominal");
  expectLargest(found, machined_wanted, nominal_wanted);
}

/// One triangle whose deviations are 0, 0 and 1: its square has the mean 1/6, and a share (1 - t)^2 lies
/// above t.
TEST(DeviationStatistics, ATriangleIsIntegratedExactly) {
  const DeviationFigures ramp = figuresOf({{3.0, {0.0f, 1.0f, 0.0f}}});
  EXPECT_DOUBLE_EQ(ramp.area_mm2, 3.0);
  EXPECT_NEAR(ramp.rms_mm, std::sqrt(1.0 / 6.0), 1e-12);
  EXPECT_NEAR(ramp.p95_mm, 1.0 - std::sqrt(0.05), 1e-8);
  // From -1 to 1 along a strip of two triangles the absolute value is spread evenly.
  const DeviationFigures through = figuresOf({{1.0, {-1.0f, 1.0f, 1.0f}}, {1.0, {-1.0f, 1.0f, -1.0f}}});
  EXPECT_NEAR(through.rms_mm, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(through.p95_mm, 0.95, 1e-8);
  // Points: as many as are needed for 95 %.
  const DeviationFigures points =
      figuresOf({{94.0, {0.1f, 0.1f, 0.1f}}, {4.0, {-0.5f, -0.5f, -0.5f}}, {2.0, {2.0f, 2.0f, 2.0f}}});
  EXPECT_NEAR(points.p95_mm, 0.5, 1e-8);
  EXPECT_EQ(figuresOf({}).rms_mm, 0.0);
}

TEST(DeviationStatistics, TheHistogramHoldsAllOfTheArea) {
  Comparison out;
  out.gouge_tolerance_mm = out.excess_tolerance_mm = 0.25;
  addToHistogram({{2.0, {-1.0f, 1.0f, 1.0f}}, {2.0, {-1.0f, 1.0f, -1.0f}}, {1.0, {3.0f, 3.0f, 3.0f}}}, 0.5,
                 out);
  ASSERT_EQ(out.histogram.area_mm2.size(), 24u);
  for (std::size_t k = 0; k + 1 < 24; ++k) EXPECT_NEAR(out.histogram.area_mm2[k], 2.0 / 24.0, 1e-9) << k;
  EXPECT_NEAR(out.histogram.area_mm2[23], 2.0 / 24.0 + 0.5, 1e-9);
}

}  // namespace
}  // namespace proveout
