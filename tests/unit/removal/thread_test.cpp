// Threads of a turned part against their own formula: at an angle the tool stands at whole leads from where
// it was at that angle first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "tests/unit/removal/turned_parts.h"

namespace proveout {
namespace {

using test::body;
using test::Made;
using test::shapeOf;

constexpr double kLead = 2.5, kRadius = 10.0, kDepth = 1.534, kTip = 0.3125, kHigh = 2.2;
const double kTan30 = std::tan(kPi / 6), kCos30 = std::cos(kPi / 6);

/// A tooth of 60 degrees that points to the axis, its flat tip at the control point; kHigh deep.
std::shared_ptr<ConvexOutline> flatTooth() {
  const double tip = 0.5 * kTip, top = tip + kHigh * kTan30;
  const std::vector<Vec2> corners{{0, tip}, {0, -tip}, {kHigh, -top}, {kHigh, top}};
  std::vector<OutlineSide> sides(4);
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i].from = corners[i];
    sides[i].to = corners[(i + 1) % 4];
  }
  return std::make_shared<ConvexOutline>(sides);
}

/// The same with a round tip.
constexpr double kNose = 0.36;
std::shared_ptr<ConvexOutline> roundTooth() {
  const double top = kHigh - kNose * 0.5;  // r from where the flanks begin
  const double half = kNose * kCos30;
  std::vector<OutlineSide> sides(4);
  sides[0].arc = true;
  sides[0].center = {kNose, 0};
  sides[0].radius = kNose;
  sides[0].from = {0.5 * kNose, half};
  sides[0].to = {0.5 * kNose, -half};
  sides[1].from = sides[0].to;
  sides[1].to = {kHigh, -half - top * kTan30};
  sides[2].from = sides[1].to;
  sides[2].to = {kHigh, half + top * kTan30};
  sides[3].from = sides[2].to;
  sides[3].to = sides[0].from;
  return std::make_shared<ConvexOutline>(sides);
}

double flatValue(double r, double z) {
  return std::max({-r, r - kHigh, (std::abs(z) - 0.5 * kTip - r * kTan30) * kCos30});
}
double roundValue(double r, double z) {
  const double flank = (std::abs(z) - kNose * kCos30 - (r - 0.5 * kNose) * kTan30) * kCos30;
  // Below the flanks the tip's circle, as seen from its centre.
  const bool tip = r - kNose < -std::abs(z) * kTan30;
  return tip ? std::hypot(r - kNose, z) - kNose : std::max(flank, r - kHigh);
}

/// A bar of radius 10 with flat ends from z = -length to 0.
std::shared_ptr<TurnedShape> bar(double length) {
  return shapeOf({body({{0, -length}, {kRadius, -length}, {kRadius, 0}, {0, 0}})});
}

ThreadSweep& addThread(TurnedShape& shape, const Vec2& from, const Vec2& to, double turns,
                       std::shared_ptr<ConvexOutline> outline = flatTooth()) {
  shape.outlines.push_back(std::move(outline));
  ThreadSweep s;
  s.outline = shape.outlines.back().get();
  s.from = from;
  s.to = to;
  s.turns = turns;
  s.motion = 100 + static_cast<MotionId>(shape.threads.size());
  shape.threads.push_back(s);
  return shape.threads.back();
}

/// Largest distance of vertices between the heights from the surface bar less tooth. `at`: control point at
/// an angle on its turn k; the tool stands there or not.
using ControlPoint = std::function<std::optional<Vec2>(double phi, int k)>;
double worstVertex(const TriMesh& mesh, double low, double high, const ControlPoint& at,
                   double (*tooth)(double, double) = flatValue) {
  double most = 0.0;
  for (const auto& f : mesh.positions) {
    const Vec3 p = f.cast<double>();
    if (p.z() < low || p.z() > high) continue;
    const double r = std::hypot(p.x(), p.y()), phi = std::atan2(p.y(), p.x());
    double value = r - kRadius;
    for (int k = -40; k <= 40; ++k) {
      if (const auto tool = at(phi, k)) value = std::max(value, -tooth(r - tool->x(), p.z() - tool->y()));
    }
    most = std::max(most, std::abs(value));
  }
  return most;
}

/// Heights at which the line parallel to Z at (r, phi) runs through the mesh.
std::vector<double> heightsAt(const TriMesh& mesh, double r, double phi) {
  std::vector<double> out;
  const double x = r * std::cos(phi), y = r * std::sin(phi);
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    const auto area = [&](const Vec3& p, const Vec3& q) {
      return (p.x() - x) * (q.y() - y) - (p.y() - y) * (q.x() - x);
    };
    const double u = area(b, c), v = area(c, a), w = area(a, b), sum = u + v + w;
    if (sum == 0.0 || u / sum < 0.0 || v / sum < 0.0 || w / sum < 0.0) continue;
    out.push_back((u * a.z() + v * b.z() + w * c.z()) / sum);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// z of the tool at an angle on turn k where it falls by the lead with each turn against +X to +Y.
double heightOf(double start_z, double lead, double phi, int k) {
  return start_z + lead * (phi / (2.0 * kPi) + k);
}

/// On a grid of 0.1 mm, and from half sections with facets within a micrometre.
class Thread : public testing::TestWithParam<bool> {
 protected:
  static Made make(const std::shared_ptr<TurnedShape>& shape) {
    return GetParam() ? test::makeFromSlices(shape, 1e-3) : test::make(shape, 0.1);
  }
};

INSTANTIATE_TEST_SUITE_P(Surface, Thread, testing::Bool(),
                         [](const auto& made) { return made.param ? "Slices" : "Grid"; });

TEST_P(Thread, M20HasItsLeadAndDepth) {
  const auto shape = bar(12);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -17.5}, -9);
  const Made made = make(shape);
  const auto at = [](double phi, int k) { return Vec2(kRadius - kDepth, heightOf(5, kLead, phi, k)); };
  EXPECT_LT(worstVertex(made.surface.mesh, -11.8, -0.2, at), 2e-3);
  double least = 100, most = 0;
  for (const auto& p : made.surface.mesh.positions) {
    if (p.z() < -10 || p.z() > -2) continue;
    const double r = std::hypot(double{p.x()}, double{p.y()});
    least = std::min(least, r);
    most = std::max(most, r);
  }
  EXPECT_NEAR(least, kRadius - kDepth, 2e-3);
  EXPECT_NEAR(most, kRadius, 2e-3);
  for (const double phi : {0.3, 2.1, -1.4}) {
    const std::vector<double> z = heightsAt(made.surface.mesh, kRadius - 0.5 * kDepth, phi);
    ASSERT_GE(z.size(), 8u);
    // Without the ends of the bar: flanks in turn.
    for (std::size_t i = 1; i + 3 < z.size(); ++i) EXPECT_NEAR(z[i + 2] - z[i], kLead, 2e-3);
    // Right-handed: it climbs with the angle. The middle of a groove stands at the tool's height.
    const double first = heightOf(5, kLead, phi, -4);
    const auto above = std::find_if(z.begin(), z.end(), [&](double h) { return h > first; });
    ASSERT_TRUE(above != z.begin() && above != z.end());
    EXPECT_NEAR(0.5 * (*above + *(above - 1)), first, 2e-3);
  }
}

TEST_P(Thread, RoundTip) {
  const auto shape = bar(8);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -15}, -8, roundTooth());
  const auto at = [](double phi, int k) { return Vec2(kRadius - kDepth, heightOf(5, kLead, phi, k)); };
  EXPECT_LT(worstVertex(make(shape).surface.mesh, -7.8, -0.2, at, roundValue), 2e-3);
}

TEST_P(Thread, LeftHandedFromTheOtherEnd) {
  const auto shape = bar(8);
  addThread(*shape, {kRadius - kDepth, -12}, {kRadius - kDepth, 5.5}, -7);
  const auto at = [](double phi, int k) { return Vec2(kRadius - kDepth, heightOf(-12, -kLead, phi, k)); };
  EXPECT_LT(worstVertex(make(shape).surface.mesh, -7.8, -0.2, at), 2e-3);
}

TEST_P(Thread, TwoStarts) {
  const auto shape = bar(10);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -15}, -4);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -15}, -4).start_rad = kPi;
  const Made made = make(shape);
  const auto at = [](double phi, int k) { return Vec2(kRadius - kDepth, 5 + 5 * phi / (2 * kPi) + 2.5 * k); };
  EXPECT_LT(worstVertex(made.surface.mesh, -9.8, -0.2, at), 2e-3);
  bool first = false, second = false;
  for (const MotionId m : made.surface.mesh.motion) {
    first = first || m == 100;
    second = second || m == 101;
  }
  EXPECT_TRUE(first && second);
}

TEST_P(Thread, Taper) {
  const auto shape = bar(10);
  addThread(*shape, {8.2, 5}, {9.2, -15}, -8);  // shallower towards the chuck
  const auto at = [](double phi, int k) {
    const double z = heightOf(5, kLead, phi, k);
    return Vec2(8.2 + (5 - z) / 20, z);
  };
  EXPECT_LT(worstVertex(make(shape).surface.mesh, -9.8, -0.2, at), 2e-3);
}

/// Where the groove gets shallower than the grid its edges run between the samples.
TEST_P(Thread, RunsOutOfThePart) {
  const auto shape = bar(14);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -5}, -4);
  ThreadSweep& out = addThread(*shape, {kRadius - kDepth, -5}, {kRadius + 0.5, -6.25}, -0.5);
  out.start_rad = 0.0;
  const auto at = [](double phi, int k) -> std::optional<Vec2> {
    const double turns = -(phi / (2 * kPi) + k);
    if (turns < 0 || turns > 4.5) return std::nullopt;
    const double beyond = std::max(0.0, turns - 4) / 0.5;
    return Vec2(kRadius - kDepth + beyond * (kDepth + 0.5), 5 - kLead * turns);
  };
  EXPECT_LT(worstVertex(make(shape).surface.mesh, -13.8, -0.2, at), 4e-2);
}

TEST_P(Thread, GrowingLead) {
  const auto shape = bar(12);
  addThread(*shape, {kRadius - kDepth, 3}, {kRadius - kDepth, -15}, -6).bend = 0.3;
  const auto at = [](double phi, int k) -> std::optional<Vec2> {
    const double t = -(phi / (2 * kPi) + k) / 6;
    if (t < 0 || t > 1) return std::nullopt;
    return Vec2(kRadius - kDepth, 3 - 18 * (t + 0.3 * (t * t - t)));
  };
  EXPECT_LT(worstVertex(make(shape).surface.mesh, -11.8, -0.2, at), 3e-3);
}

/// A tool that stops in the part leaves a flat wall where it stood.
TEST_P(Thread, EndsInTheMaterial) {
  const auto shape = bar(12);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -5}, -4);
  const Made made = make(shape);
  const double groove = kDepth * (kTip + kDepth * kTan30);
  // The wall is the half of the tooth's cross section that stands in the half-plane y = 0, x > 0.
  double area = 0.0;
  for (const auto& t : made.surface.mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = made.surface.mesh.positions[t[i]].cast<double>();
    const bool on_wall = std::all_of(p.begin(), p.end(), [](const Vec3& q) {
      return std::abs(q.y()) < 1e-3 && q.x() > 8 && std::abs(q.z() + 5) < 1.5;
    });
    if (on_wall) area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  }
  EXPECT_NEAR(area, groove, 0.01 * groove);
}

TEST_P(Thread, InsideABore) {
  // The tooth points away from the axis and is longer than the bore is wide: it reaches over the axis.
  std::vector<OutlineSide> sides(4);
  const std::vector<Vec2> corners{{0, -0.1}, {0, 0.1}, {-6, 3}, {-6, -3}};
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i].from = corners[i];
    sides[i].to = corners[(i + 1) % 4];
  }
  const auto shape = shapeOf({body({{4, -8}, {9, -8}, {9, 0}, {4, 0}})});
  addThread(*shape, {4.8, 3}, {4.8, -12}, -6, std::make_shared<ConvexOutline>(sides));
  const Made made = make(shape);
  double most = 0;
  for (const auto& p : made.surface.mesh.positions) {
    const double r = std::hypot(double{p.x()}, double{p.y()});
    if (p.z() > -6 && p.z() < -2 && r < 6) most = std::max(most, r);
  }
  EXPECT_NEAR(most, 4.8, 2e-3);
}

/// The section of the feather part at an angle: its corners with z >= -6.5, in order.
constexpr double kFeatherRoot = 8.5, kFeatherFlat = 0.2;
double featherRadius(double phi, double z) {
  const double turns = (z - 5) / kLead - phi / (2 * kPi), off = kLead * std::abs(turns - std::round(turns));
  return std::min({10.0, 8.0 - z, kFeatherRoot + std::max(0.0, off - kFeatherFlat) / kTan30});
}
std::vector<Vec2> featherSection(double phi) {
  std::vector<double> z{-6, -2, 0};
  for (int k = -8; k <= 2; ++k) {
    const double middle = heightOf(5, kLead, phi, k);
    for (const double side : {-1.0, 1.0}) {
      z.push_back(middle + side * kFeatherFlat);
      z.push_back(middle + side * (kFeatherFlat + (10 - kFeatherRoot) * kTan30));
      // Where root and flank meet the chamfer.
      z.push_back(8 - kFeatherRoot);
      z.push_back(((8 - kFeatherRoot) * kTan30 + kFeatherFlat + side * middle) / (side + kTan30));
    }
  }
  std::erase_if(z, [](double h) { return h < -6 || h > 0; });
  std::sort(z.begin(), z.end());
  std::vector<Vec2> out{{8, -6.5}, {8, -6}};
  for (const double h : z) out.push_back({featherRadius(phi, h), h});
  return out;
}

double distanceToChain(const std::vector<Vec2>& chain, const Vec2& p) {
  double least = 1e9;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec2 edge = chain[i] - chain[i - 1], from = p - chain[i - 1];
    const double share = std::clamp(edge.dot(from) / std::max(edge.squaredNorm(), 1e-30), 0.0, 1.0);
    least = std::min(least, (from - share * edge).norm());
  }
  return least;
}
double offFeather(const Vec3& p) {
  return distanceToChain(featherSection(std::atan2(p.y(), p.x())), {std::hypot(p.x(), p.y()), p.z()});
}

/// A thread that runs over a chamfer at one end and into the wall of an undercut at the other: at some angle
/// any two of their edges come as near to each other as can be, and the thread's ridges are cut to feathers.
std::shared_ptr<TurnedShape> featherPart() {
  const auto shape =
      shapeOf({body({{0, -10}, {11, -10}, {11, -9}, {8, -9}, {8, -6}, {10, -6}, {10, -2}, {8, 0}, {0, 0}})});
  const double top = kFeatherFlat + kHigh * kTan30;
  const std::vector<Vec2> corners{{0, kFeatherFlat}, {0, -kFeatherFlat}, {kHigh, -top}, {kHigh, top}};
  std::vector<OutlineSide> sides(4);
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i].from = corners[i];
    sides[i].to = corners[(i + 1) % 4];
  }
  addThread(*shape, {kFeatherRoot, 5}, {kFeatherRoot, -7.5}, -5, std::make_shared<ConvexOutline>(sides));
  return shape;
}

/// How far a triangle is from a point.
double distanceToTriangle(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  double least = 1e9;
  bool inside = n.squaredNorm() > 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i], from = p - t[i];
    const double share = std::clamp(edge.dot(from) / std::max(edge.squaredNorm(), 1e-30), 0.0, 1.0);
    least = std::min(least, (from - share * edge).norm());
    inside = inside && n.dot(edge.cross(from)) >= 0.0;
  }
  return inside ? std::abs(n.normalized().dot(p - t[0])) : least;
}

/// The largest distance of the section's corners from the mesh.
double mostMissed(const TriMesh& mesh) {
  constexpr int kSectors = 720;
  const auto sectorOf = [](double x, double y) {
    return static_cast<int>((std::atan2(y, x) / (2 * kPi) + 0.5) * kSectors) % kSectors;
  };
  std::vector<std::vector<std::array<Vec3, 3>>> near(kSectors);
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = mesh.positions[t[i]].cast<double>();
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3;
    const double top = std::max({c[0].z(), c[1].z(), c[2].z()});
    if (top < -6.2 || std::hypot(middle.x(), middle.y()) < 3.0) continue;
    near[static_cast<std::size_t>(sectorOf(middle.x(), middle.y()))].push_back(c);
  }
  double most = 0.0;
  for (int i = 0; i < 2 * kSectors; ++i) {
    const double phi = (i + 0.37) * kPi / kSectors;
    for (const Vec2& q : featherSection(phi)) {
      if (q.y() < -6) continue;
      const Vec3 p(q.x() * std::cos(phi), q.x() * std::sin(phi), q.y());
      double least = 1e9;
      for (int beside = -5; beside <= 5; ++beside) {
        const int sector = (sectorOf(p.x(), p.y()) + beside + kSectors) % kSectors;
        for (const auto& t : near[static_cast<std::size_t>(sector)]) {
          const auto [low, high] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
          if (low < p.z() + 0.5 && high > p.z() - 0.5) least = std::min(least, distanceToTriangle(t, p));
        }
      }
      most = std::max(most, least);
    }
  }
  return most;
}

TEST_P(Thread, FeatherEdgesAreSharp) {
  const TriMesh mesh = make(featherPart()).surface.mesh;
  double vertex = 0.0, edge = 0.0, center = 0.0;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> c;
    bool around = true;
    for (std::size_t i = 0; i < 3; ++i) {
      c[i] = mesh.positions[t[i]].cast<double>();
      around = around && c[i].z() > -6.4 && std::hypot(c[i].x(), c[i].y()) > 7.8 && c[i].z() < -0.01;
    }
    if (!around) continue;
    vertex = std::max(vertex, offFeather(c[0]));
    for (std::size_t i = 0; i < 3; ++i) edge = std::max(edge, offFeather(0.5 * (c[i] + c[(i + 1) % 3])));
    center = std::max(center, offFeather((c[0] + c[1] + c[2]) / 3.0));
  }
  EXPECT_LT(vertex, 2e-3);
  EXPECT_LT(edge, 10e-3);
  EXPECT_LT(center, 10e-3);
  EXPECT_LT(mostMissed(mesh), 20e-3);
}

TEST(ThreadOnGrid, SharpenedTheSameForAnyNumberOfThreads) {
  const TriMesh one = test::make(featherPart(), 0.2, 1).surface.mesh,
                three = test::make(featherPart(), 0.2, 3).surface.mesh;
  EXPECT_EQ(one.positions, three.positions);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.motion, three.motion);
}

TEST(ThreadOnGrid, SameForAnyNumberOfThreads) {
  const auto shape = bar(6);
  addThread(*shape, {kRadius - kDepth, 5}, {kRadius - kDepth, -5}, -4, roundTooth());
  const TriMesh one = test::make(shape, 0.2, 1).surface.mesh, three = test::make(shape, 0.2, 3).surface.mesh;
  ASSERT_GT(one.triangles.size(), 1000u);
  EXPECT_EQ(one.positions, three.positions);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.motion, three.motion);
}

}  // namespace
}  // namespace proveout
