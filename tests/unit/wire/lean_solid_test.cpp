// What leaning wires leave, against closed forms and against the distance to the wire in space.
#include "removal/wire/lean/lean_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>

#include "core/geometry/plane.h"
#include "core/mesh/intersections.h"
#include "removal/wire/falls/body_exit.h"
#include "removal/wire/section/wire_stretch.h"
#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

constexpr HeightSpan kSpan{0.0, 20.0};
constexpr double kTolerance = 5e-4;
const std::vector<PlaneLoop> kPlate = {rectangleLoop({-20, -20}, {20, 20})};

WireTrack lineTrack(const Vec2& from, const Vec2& to) {
  WireTrack track;
  track.from = from;
  track.to = to;
  return track;
}

WireTrack arcTrack(const Vec2& center, double radius, double start, double sweep) {
  const auto at = [&](double angle) {
    return Vec2(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  };
  return {at(start), at(start + sweep), center, sweep};
}

std::vector<LeanStretch> stretchesOf(const std::vector<WireSweep>& sweeps, double radius) {
  std::vector<LeanStretch> out;
  for (MotionId i = 0; i < sweeps.size(); ++i) addLeanStretches(sweeps[i], kSpan, radius, kTolerance, i, out);
  return out;
}

LeanSolid solidOf(const std::vector<WireSweep>& sweeps, double radius) {
  Progress progress;
  Result<LeanSolid> solid = leanSolid(kPlate, kSpan, stretchesOf(sweeps, radius), kTolerance, progress);
  EXPECT_TRUE(solid) << solid.error().message;
  return solid ? std::move(*solid) : LeanSolid{};
}

std::vector<WireSweep> polygons(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper) {
  std::vector<WireSweep> sweeps;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t k = (i + 1) % lower.size();
    sweeps.push_back({kSpan.low, kSpan.high, lineTrack(lower[i], lower[k]), lineTrack(upper[i], upper[k])});
  }
  return sweeps;
}

std::vector<Vec2> square(double half) { return {{half, -half}, {half, half}, {-half, half}, {-half, -half}}; }

void expectSound(const LeanSolid& solid) {
  for (const LeanBody& body : solid.bodies) {
    const MeshTopology topology = analyseTopology(body.mesh);
    EXPECT_TRUE(topology.closedManifold()) << topology.first_defect.transpose();
    EXPECT_EQ(topology.components, 1u);
    EXPECT_NEAR(meshVolume(body.mesh), body.volume_mm3, 1e-4 * body.volume_mm3 + 0.05);
  }
}

/// Points of a mesh near a height leave a curve by no more.
double farthestAt(const TriMesh& mesh, double z, const std::function<double(const Vec2&)>& off) {
  double most = 0.0;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions[t[k]].cast<double>(), b = mesh.positions[t[(k + 1) % 3]].cast<double>();
      if ((a.z() - z) * (b.z() - z) > 0.0 || a.z() == b.z()) continue;
      const Vec3 p = a + (b - a) * ((z - a.z()) / (b.z() - a.z()));
      most = std::max(most, std::abs(off(p.head<2>())));
    }
  }
  return most;
}

TEST(LeanSolid, FrustumOfASquare) {
  const double low = 5.0, high = 6.5, rho = 0.135;
  const LeanSolid solid = solidOf(polygons(square(low), square(high)), rho);
  ASSERT_EQ(solid.bodies.size(), 2u);
  expectSound(solid);
  const double tan = (high - low) / kSpan.length(), off = rho * std::sqrt(1.0 + tan * tan);
  const auto side = [&](double w) { return 2.0 * (low + w * (high - low) - off); };
  const double volume =
      kSpan.length() / 6.0 * (side(0) * side(0) + 4.0 * side(0.5) * side(0.5) + side(1) * side(1));
  const LeanBody& punch = solid.bodies[1];
  EXPECT_NEAR(punch.volume_mm3, volume, 1e-6 * volume);
  EXPECT_NEAR(meshVolume(punch.mesh), volume, 1e-5 * volume);
  EXPECT_LE(punch.mesh.triangles.size(), 100u);
  for (const double z : {0.0, 7.3, 10.0, 20.0}) {
    EXPECT_LE(farthestAt(punch.mesh,
                         z == 0.0    ? 1e-4
                         : z == 20.0 ? 19.9999
                                     : z,
                         [&](const Vec2& p) { return p.cwiseAbs().maxCoeff() - 0.5 * side(z / 20.0); }),
              1e-5);
  }
}

/// Wider above: it leaves upwards. Turned about its axis on the way: not at all.
TEST(LeanSolid, WhichWaySlugsLeave) {
  const LeanSolid wedge = solidOf(polygons(square(5), square(6)), 0.1);
  ASSERT_EQ(wedge.bodies.size(), 2u);
  const BodyExit up = exitOf(wedge, 1, wedge, 0);
  EXPECT_TRUE(up.up);
  EXPECT_FALSE(up.down);
  // By less than the kerf either way.
  const LeanSolid passing = solidOf(polygons(square(5), square(5.1)), 0.1);
  const BodyExit both = exitOf(passing, 1, passing, 0);
  EXPECT_TRUE(both.up && both.down);
  std::vector<Vec2> turned;
  for (const Vec2& p : square(5)) turned.push_back(turnedBy(p, 0.2));
  const LeanSolid locked = solidOf(polygons(square(5), turned), 0.1);
  const BodyExit none = exitOf(locked, 1, locked, 0);
  EXPECT_FALSE(none.up || none.down);
}

/// Digest wedm EX-16: a rounded square of 20 with taper 2.5 degrees outwards, kerf radius 0.1.
TEST(LeanSolid, RoundedSquareWithTaper) {
  const double q = 20.0 * std::tan(2.5 * kPi / 180.0);
  std::vector<WireSweep> sweeps;
  const double in = 6.0, out = 10.0;
  for (int k = 0; k < 4; ++k) {
    const double turn = 0.5 * kPi * k;
    const auto at = [&](double x, double y) { return turnedBy(Vec2(x, y), turn); };
    sweeps.push_back(
        {0.0, 20.0, lineTrack(at(out, -in), at(out, in)), lineTrack(at(out + q, -in), at(out + q, in))});
    sweeps.push_back({0.0, 20.0, arcTrack(at(in, in), 4.0, turn, 0.5 * kPi),
                      arcTrack(at(in, in), 4.0 + q, turn, 0.5 * kPi)});
  }
  const LeanSolid solid = solidOf(sweeps, 0.1);
  ASSERT_EQ(solid.bodies.size(), 2u);
  expectSound(solid);
  const LeanBody& punch = solid.bodies[1];
  EXPECT_NEAR(punch.volume_mm3, 8228.6214, 1e-5 * 8228.6214);
  EXPECT_NEAR(meshVolume(punch.mesh), 8228.6214, 1e-5 * 8228.6214);
  const double off = 0.1 / std::cos(2.5 * kPi / 180.0);
  for (const double z : {0.5, 10.0, 19.5}) {
    const double radius = 4.0 + q * z / 20.0 - off;
    EXPECT_LE(farthestAt(punch.mesh, z,
                         [&](const Vec2& p) {
                           const Vec2 d = (p.cwiseAbs() - Vec2(in, in)).cwiseMax(0.0);
                           return d.norm() - radius;
                         }),
              2e-3);
  }
}

/// Above 0 in the material: from the wire in space, by many places along each motion.
double materialAt(const std::vector<WireSweep>& sweeps, double rho, const Vec3& p) {
  double least = 20.0 - p.head<2>().cwiseAbs().maxCoeff();
  for (const WireSweep& sweep : sweeps) {
    const auto off = [&](double t) {
      const auto on = [&](const WireTrack& track) { return pointOnTrack(track, t); };
      const Vec2 low = on(sweep.lower), high = on(sweep.upper);
      const Vec2 lean = (high - low) / (sweep.z_high - sweep.z_low);
      const Vec2 d = p.head<2>() - low - lean * (p.z() - sweep.z_low);
      return std::sqrt(
          std::max(0.0, d.squaredNorm() - std::pow(d.dot(lean), 2) / (1.0 + lean.squaredNorm())));
    };
    constexpr int kPlaces = 200;
    int best = 0;
    for (int k = 1; k <= kPlaces; ++k)
      if (off(1.0 * k / kPlaces) < off(1.0 * best / kPlaces)) best = k;
    double a = std::max(0.0, (best - 1.0) / kPlaces), b = std::min(1.0, (best + 1.0) / kPlaces);
    for (int k = 0; k < 60; ++k) {
      const double c = a + 0.382 * (b - a), d = a + 0.618 * (b - a);
      (off(c) < off(d) ? b : a) = off(c) < off(d) ? d : c;
    }
    least = std::min(least, off(0.5 * (a + b)) - rho);
  }
  return least;
}

bool inside(const TriMesh& mesh, const Vec3& p) {
  bool in = false;
  for (const auto& t : mesh.triangles) {
    // A ray along +x against the triangle's shadow on the plane of y and z.
    std::array<Vec3, 3> c;
    for (int k = 0; k < 3; ++k) c[k] = mesh.positions[t[k]].cast<double>();
    const auto edge = [&](const Vec3& u, const Vec3& v) {
      return (v.y() - u.y()) * (p.z() - u.z()) - (v.z() - u.z()) * (p.y() - u.y());
    };
    const double w0 = edge(c[1], c[2]), w1 = edge(c[2], c[0]), w2 = edge(c[0], c[1]);
    if (!((w0 > 0 && w1 > 0 && w2 > 0) || (w0 < 0 && w1 < 0 && w2 < 0))) continue;
    const double x = (w0 * c[0].x() + w1 * c[1].x() + w2 * c[2].x()) / (w0 + w1 + w2);
    if (x > p.x()) in = !in;
  }
  return in;
}

void expectMaterial(const LeanSolid& solid, const std::vector<WireSweep>& sweeps, double rho, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20.5, 20.5), height(0.01, 19.99), near(-0.4, 0.4),
      share(0, 1);
  for (int i = 0; i < 400; ++i) {
    Vec3 p(place(random), place(random), height(random));
    if (i % 2 == 0) {  // close to the wire
      const WireSweep& s = sweeps[random() % sweeps.size()];
      const double w = p.z() / 20.0, t = share(random);
      const auto on = [&](const WireTrack& track) { return pointOnTrack(track, t); };
      p.head<2>() = (1 - w) * on(s.lower) + w * on(s.upper) + Vec2(near(random), near(random));
    }
    const double material = materialAt(sweeps, rho, p);
    if (std::abs(material) < 1.5e-3) continue;
    const bool in = std::any_of(solid.bodies.begin(), solid.bodies.end(),
                                [&](const LeanBody& body) { return inside(body.mesh, p); });
    ASSERT_EQ(in, material > 0.0) << p.transpose() << " off " << material;
  }
}

/// Round below, a diamond above (digest wedm EX-12 without its offset).
TEST(LeanSolid, CircleToDiamond) {
  std::vector<WireSweep> sweeps;
  const std::vector<Vec2> corner = {{10, 0}, {0, 10}, {-10, 0}, {0, -10}};
  for (int k = 0; k < 4; ++k)
    sweeps.push_back({0.0, 20.0, arcTrack({0, 0}, 10.0, 0.5 * kPi * k, 0.5 * kPi),
                      lineTrack(corner[k], corner[(k + 1) % 4])});
  const LeanSolid solid = solidOf(sweeps, 0.135);
  ASSERT_EQ(solid.bodies.size(), 2u);
  expectSound(solid);
  expectMaterial(solid, sweeps, 0.135, 3);
  // Without its kerf the body would have 256.269058 x T: what the wire's ellipse adds is of the second order.
  const LeanSolid thin = solidOf(sweeps, 1e-3);
  ASSERT_EQ(thin.bodies.size(), 2u);
  const double around = 0.5 * (2 * kPi * 10 + 4 * std::sqrt(200.0));  // about, half way less
  EXPECT_NEAR(thin.bodies[1].volume_mm3, 20.0 * (256.269058 - 1e-3 * around), 0.02);
}

/// Corners, middles and edges of triangles: how far they leave the surface, at most.
double farthestOff(const TriMesh& mesh, const std::vector<WireSweep>& sweeps, double rho, std::size_t step) {
  double most = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
    const auto& t = mesh.triangles[i];
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    if (a.z() == b.z() && b.z() == c.z()) continue;  // a face
    for (const Vec3& p : {a, Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3((a + b + c) / 3.0)})
      most = std::max(most, std::abs(materialAt(sweeps, rho, p)));
  }
  return most;
}

/// A circle of 16 below and a square of 16 above. Two triangles that share the diagonal of a cell of a
/// twisted wall leave it by a fourth of what one side of the cell opens more than the other, or an eighth
/// where rows are shifted. Rows are powers of two and leave a fourth of the tolerance to the wall's bend: up
/// to 2.7 times as many cells as the whole opening asks for. Where pieces were as short as eight rows ask for
/// and levels went all round there were 3.3 million triangles.
TEST(LeanSolid, TwistedWallsHaveTheTrianglesThatTheirTwistAsksFor) {
  std::vector<WireSweep> sweeps;
  const double half = 8.0, sag = half / std::sqrt(2.0);
  for (int k = 0; k < 8; ++k) {
    const auto corner = [&](int i) {
      return turnedBy(i % 2 == 0 ? Vec2(half, 0) : Vec2(half, half), 0.5 * kPi * (i / 2));
    };
    sweeps.push_back(
        {0.0, 20.0, arcTrack({0, 0}, half, 0.25 * kPi * k, 0.25 * kPi), lineTrack(corner(k), corner(k + 1))});
  }
  std::size_t before = 0;
  for (const double tolerance : {5e-4, 5e-5}) {
    std::vector<LeanStretch> pieces;
    for (MotionId i = 0; i < sweeps.size(); ++i)
      addLeanStretches(sweeps[i], kSpan, 0.11, tolerance, i, pieces);
    Progress progress;
    const Result<LeanSolid> solid = leanSolid(kPlate, kSpan, pieces, tolerance, progress);
    ASSERT_TRUE(solid) << solid.error().message;
    ASSERT_EQ(solid->bodies.size(), 2u);
    expectSound(*solid);
    const double opening = 8 * 2.0 * (half - sag);
    std::size_t triangles = 0;
    for (const LeanBody& body : solid->bodies) {
      triangles += body.mesh.triangles.size();
      if (tolerance < 5e-4) continue;
      EXPECT_LE(farthestOff(body.mesh, sweeps, 0.11, body.mesh.triangles.size() / 300 + 1), tolerance + 3e-4)
          << "chords of arcs are off by 0.0002, those of round ends by 0.0001";
      const std::vector<std::uint8_t> all(body.mesh.positions.size(), 1);
      for (const auto& [s, t] : findIntersections(body.mesh, all))
        EXPECT_EQ(s, t) << "only needles of the level faces touch themselves, as lines";
    }
    const double cells = 2 * opening / (8.0 * tolerance);
    EXPECT_LE(triangles, 2.0 * 2.7 * cells + 10000.0) << tolerance;
    EXPECT_GT(triangles, before);
    before = triangles;
  }
}

/// Digest wedm EX-13: each height is a polygon.
TEST(LeanSolid, FourAxes) {
  const std::vector<Vec2> low = {{0, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}};
  const std::vector<Vec2> high = {{0, 0}, {10, 0}, {7, 6}, {5, 10}, {3, 6}};
  const std::vector<WireSweep> sweeps = polygons(low, high);
  const LeanSolid solid = solidOf(sweeps, 0.1);
  ASSERT_EQ(solid.bodies.size(), 2u);
  expectSound(solid);
  expectMaterial(solid, sweeps, 0.1, 5);
}

class LeanRandom : public testing::TestWithParam<unsigned> {};

/// Closed polygons with other corners above, convex or not.
TEST_P(LeanRandom, Polygons) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> share(-1, 1);
  const int n = 3 + static_cast<int>(random() % 8);
  std::vector<Vec2> low, high;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * kPi * k / n;
    low.push_back((11 + 4 * share(random)) * Vec2(std::cos(angle), std::sin(angle)));
    high.push_back(low.back() + 1.5 * Vec2(share(random), share(random)));
  }
  const std::vector<WireSweep> sweeps = polygons(low, high);
  const double rho = 0.05 + 0.1 * std::abs(share(random));
  const LeanSolid solid = solidOf(sweeps, rho);
  ASSERT_EQ(solid.bodies.size(), 2u);
  expectSound(solid);
  expectMaterial(solid, sweeps, rho, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Seeds, LeanRandom, testing::Range(1u, 25u));

/// Two cuts that cross in the plan only above: the bar between them is whole below and parted above.
TEST(LeanSolid, WallsThatMeet) {
  std::vector<WireSweep> sweeps;
  sweeps.push_back({0.0, 20.0, lineTrack({-25, 3}, {25, 3}), lineTrack({-25, -3}, {25, 4})});
  sweeps.push_back({0.0, 20.0, lineTrack({25, -3}, {-25, -3}), lineTrack({25, -3}, {-25, 0})});
  const LeanSolid solid = solidOf(sweeps, 0.2);
  expectSound(solid);
  expectMaterial(solid, sweeps, 0.2, 11);
}

/// Cuts that cross in any way at any height.
TEST_P(LeanRandom, Crossings) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  std::mt19937 random(1000 + GetParam());
  std::uniform_real_distribution<double> place(-12, 12), lean(-2, 2);
  const int n = 2 + static_cast<int>(random() % 5);
  std::vector<Vec2> low, high;
  for (int k = 0; k < n; ++k) {
    low.emplace_back(place(random), place(random));
    high.push_back(low.back() + Vec2(lean(random), lean(random)));
  }
  const std::vector<WireSweep> sweeps = polygons(low, high);
  const LeanSolid solid = solidOf(sweeps, 0.15);
  ASSERT_FALSE(solid.bodies.empty());
  expectSound(solid);
  expectMaterial(solid, sweeps, 0.15, GetParam());
}

}  // namespace
}  // namespace proveout
