// Removed volume against closed forms on a 0.25 mm grid that no feature is aligned with.
#include <cmath>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.25;
const BoxShape kBlank{{-40, -30, -20}, {60, 30, 0}};

/// Checks the removed volume: that of the facets to 0.05 % plus the cost of faceting (chords lie h^2 / 8r off
/// a wall of radius r and area `curved`), the integrated one to `exact` relative.
void expectRemoved(const Cut& c, double expected, double curved_area, double radius, double exact = 1e-4) {
  const double facets = c.initial - c.mesh_volume, integrated = c.initial - c.volume;
  const double faceting = radius > 0 ? curved_area * kGrid * kGrid / (8 * radius) : 0.0;
  ::testing::Test::RecordProperty("facets_relative_error", std::to_string(facets / expected - 1));
  ::testing::Test::RecordProperty("integrated_relative_error", std::to_string(integrated / expected - 1));
  EXPECT_NEAR(facets, expected, 5e-4 * expected + faceting);
  EXPECT_NEAR(integrated, expected, exact * expected);
}

TEST(BlankVolume, Box) {
  const Cut c = cut(kBlank, Toolpath{}, {}, kGrid);
  EXPECT_NEAR(c.mesh_volume, 120000.0, 1e-6 * 120000);
  EXPECT_NEAR(c.volume, 120000.0, 1e-6 * 120000);
}

TEST(BlankVolume, CylinderAndTube) {
  CylinderShape round;
  round.base = {3, 4, -10};
  round.radius = 12;
  round.length = 17.3;
  Cut c = cut(round, Toolpath{}, {}, kGrid);
  EXPECT_NEAR(c.volume, kPi * 144 * 17.3, 3e-5 * c.initial);
  round.inner_radius = 5;
  round.axis = 0;
  c = cut(round, Toolpath{}, {}, kGrid);
  EXPECT_NEAR(c.volume, kPi * (144 - 25) * 17.3, 3e-5 * c.initial);
}

TEST(Slot, Flat) {
  const Cut c =
      cut(kBlank, PathMaker().line({-10.3, 1.1, -5}, {30.2, 1.1, -5}).path(), {tool("1=flat:10")}, kGrid);
  expectRemoved(c, 40.5 * 10 * 5 + kPi * 25 * 5, kPi * 10 * 5, 5);
}

TEST(Slot, Ball) {
  const double r = 4;
  const Cut c =
      cut(kBlank, PathMaker().line({-10.3, 1.1, -6}, {30.2, 5.1, -6}).path(), {tool("1=ball:8")}, kGrid);
  const double length = std::hypot(40.5, 4.0);
  expectRemoved(c, length * (kPi * r * r / 2 + 2 * r * 2) + 2.0 / 3 * kPi * r * r * r + kPi * r * r * 2,
                length * kPi * r, r);
}

TEST(Slot, Bull) {
  const double R = 5, rc = 1.5, depth = 4, length = 33.3;
  const Cut c = cut(kBlank, PathMaker().line({-10.3, 1.1, -depth}, {-10.3 + length, 1.1, -depth}).path(),
                    {tool("1=bull:10:1.5")}, kGrid);
  const double section = 2 * R * depth - 2 * rc * rc * (1 - kPi / 4);
  double rim = 0;  // what the rounded rim leaves of the turned ends, by shells
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double z = rc * (i + 0.5) / n, r = R - rc + std::sqrt(rc * rc - (rc - z) * (rc - z));
    rim += kPi * (R * R - r * r) * rc / n;
  }
  expectRemoved(c, length * section + kPi * R * R * depth - rim, length * kPi * rc, rc);
}

TEST(Slot, Cone) {
  const double tip = 0.5, R = 5, depth = 4, length = 33.3;
  const Cut c = cut(kBlank, PathMaker().line({-10.3, 1.1, -depth}, {-10.3 + length, 1.1, -depth}).path(),
                    {tool("1=cone:10:1:60")}, kGrid);
  const double top = tip + depth * std::tan(degToRad(30));
  ASSERT_LT(top, R);
  expectRemoved(c, length * depth * (tip + top) + kPi * depth / 3 * (tip * tip + tip * top + top * top),
                kPi * 2 * depth * 2, 1);
}

TEST(Plunge, Drill) {
  const double R = 4.25, depth = 11;
  const Cut c = cut(kBlank, PathMaker().line({10.3, 1.1, 3}, {10.3, 1.1, -depth}).path(),
                    {tool("1=drill:8.5:118")}, kGrid);
  const double tip = R / std::tan(degToRad(59));
  expectRemoved(c, kPi * R * R * (depth - tip) + kPi * R * R * tip / 3, 2 * kPi * R * depth, R);
}

TEST(SlantedSlot, FlatWithinBlank) {
  // A flat end mill of radius R along (L, 0, -D): prism of the sheared cylinder; from z = 0 down. Volume by
  // integration of the lower envelope over the plane: depth at x is reached by the lowest position whose disc
  // covers (x, y).
  const double R = 3, L = 20, D = 8;
  const Cut c =
      cut(kBlank, PathMaker().line({-5.2, 1.3, 0}, {-5.2 + L, 1.3, -D}).path(), {tool("1=flat:6")}, kGrid);
  double expected = 0;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double y = R * (2.0 * (i + 0.5) / n - 1), w = std::sqrt(R * R - y * y), dy = 2 * R / n;
    // position s in [0, L] covers x in [s - w, s + w]; depth D s / L; deepest s is min(L, x + w).
    // integral over x from -w to L + w: ramp from s=0..L over length L, then flat D over 2w.
    expected += dy * (D * L / 2 + D * 2 * w);
  }
  expectRemoved(c, expected, kPi * R * (L + D), R, 3e-4);
}

TEST(SlantedSlot, BallCapsule) {
  // Deep under the surface the ball's sweep is half a capsule plus a flank; compare with the lower envelope
  // integrated numerically.
  const double R = 3, L = 20, D = 6, z0 = -4;
  const Cut c = cut(kBlank, PathMaker().line({-5.2, 1.3, z0}, {-5.2 + L, 1.3, z0 - D}).path(),
                    {tool("1=ball:6")}, kGrid);
  double expected = 0;
  const int n = 1500;
  for (int i = 0; i < n; ++i) {
    const double y = R * (2.0 * (i + 0.5) / n - 1), w = std::sqrt(R * R - y * y);
    const double x0 = -w, x1 = L + w, dx = (x1 - x0) / n;
    for (int j = 0; j < n; ++j) {
      const double x = x0 + (j + 0.5) * dx;
      // minimise z0 - D s / L + R - sqrt(w^2 - (x - s)^2) over s: stationary at x - s = -w * k with slope D /
      // L
      const double k = D / L, q = w * k / std::sqrt(1 + k * k);
      double s = std::clamp(x + q, 0.0, L);
      s = std::clamp(s, x - w, x + w);
      const double under = std::max(0.0, w * w - (x - s) * (x - s));
      expected -= dx * (2 * R / n) * (z0 - D * s / L + R - std::sqrt(under));
    }
  }
  expectRemoved(c, expected, kPi * R * L, R, 3e-4);
}

/// How deep, mm, the deepest vertex is in a ball of radius `r` on the way through `centers`.
double deepestInBall(const TriMesh& mesh, const std::vector<Vec3>& centers, double r) {
  double deepest = 0.0;
  for (const auto& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    for (std::size_t i = 1; i < centers.size(); ++i) {
      const Vec3 way = centers[i] - centers[i - 1];
      const double along = std::clamp((p - centers[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      deepest = std::max(deepest, r - (p - centers[i - 1] - along * way).norm());
    }
  }
  return deepest;
}

/// Two grooves leave a peak at the blank's wall; an earlier pass, whose surface is gone all around, took its
/// tip within one cell, where it meets no edge of the grid.
TEST(BallGrooves, NoTipStandsWhereAnEarlierPassTookIt) {
  const double R = 1.99635, grid = 0.3;
  const std::vector<Vec3> tips = {{-2.9096, -0.1499, -0.9602},
                                  {-2.6481, -4.1798, -2.9023},
                                  {-4.7659, -5.1584, -2.9023},
                                  {0.1658, -2.3426, -2.9023},
                                  {-3.0131, 0.5215, -2.9023}};
  PathMaker path;
  std::vector<Vec3> centers;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (i > 0) path.line(tips[i - 1], tips[i]);
    centers.push_back(tips[i] + R * Vec3::UnitZ());
  }
  const Cut c = cut(BoxShape{{-2.8134, -4.3012, -4.0}, {4.4682, 0.5843, -0.8161}}, path.path(),
                    {tool("1=ball:3.9927")}, grid);
  EXPECT_LT(deepestInBall(c.mesh, centers, R), 0.5 * grid);
}

TEST(Ring, FlatFullCircle) {
  const Cut c = cut(kBlank, PathMaker().arc({22, 2, -3}, {10, 2, -3}, {0, 0, 1}, 360).path(),
                    {tool("1=flat:5")}, kGrid);
  expectRemoved(c, kPi * (14.5 * 14.5 - 9.5 * 9.5) * 3, 2 * kPi * 24 * 3, 9.5);
}

TEST(Bore, Helix) {
  PathMaker path;
  path.arc({16.3, 1.7, 0}, {10.3, 1.7, 0}, {0, 0, 1}, 360 * 4, -12);
  path.arc({16.3, 1.7, -12}, {10.3, 1.7, -12}, {0, 0, 1}, 360);
  const Cut c = cut(kBlank, path.path(), {tool("1=flat:8")}, kGrid);
  // Outer radius 10, core of radius 2 stays.
  expectRemoved(c, kPi * (100 - 4) * 12, 2 * kPi * 12 * 12, 2);
}

TEST(Pocket, Flat10) {
  // 40 x 30 x 5 with corners of radius 5: 40*30*5 - (4 - pi) * 25 * 5 = 5892.70
  PathMaker path;
  Vec3 at;
  const auto go = [&](double x, double y) {
    path.line(at, {x, y, -5});
    at = {x, y, -5};
  };
  const double x0 = -15.1, y0 = -10.3;
  at = {x0, y0, -5};
  go(x0 + 30, y0), go(x0 + 30, y0 + 20), go(x0, y0 + 20), go(x0, y0);
  for (double y = y0 + 4; y < y0 + 20; y += 4) go(at.x(), y), go(at.x() > 0 ? x0 : x0 + 30, y);
  const Cut c = cut(kBlank, path.path(), {tool("1=flat:10")}, kGrid);
  expectRemoved(c, 6000 - (4 - kPi) * 125, 2 * kPi * 5 * 5, 5, 1e-5);
}

}  // namespace
}  // namespace proveout::test
