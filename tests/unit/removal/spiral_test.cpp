// Spirals, and arcs that lean, as bodies: what they remove against closed forms and a slow search, whose the
// surface is, and what their shanks and holders touch against the same way as chords.
#include <algorithm>
#include <cmath>

#include "core/tool/tool_solid.h"
#include "removal/sweep/column_curve.h"
#include "removal/sweep/column_sweep.h"
#include "removal/sweep/column_way.h"
#include "removal/sweep/sweep.h"
#include "tests/support/golden_section.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.25;
constexpr double kVolume = 1e-5;  ///< of the removed volume, relative
/// The same where ridges, or sharp edges of a groove, run through cells: what the integral over the surface
/// makes of them.
constexpr double kRidges = 2e-4, kCreases = 5e-5;
const BoxShape kBlank{{-40.03, -40.07, -10.02}, {40.06, 40.01, 0}};
const Vec3 kCenter{0.317, -0.211, 0.0};

/// r = first + growth t for angles t up to way; the tip falls evenly.
struct Spiral {
  double first, growth;  ///< mm, mm a radian
  double way;            ///< rad
  double z, fall;        ///< of the tip at the start, and down to the end, mm
  double start = 0.7;    ///< direction of the start, rad

  double radius(double t) const { return first + growth * t; }
  Vec3 at(double t) const {
    const double a = start + t;
    return kCenter + Vec3(radius(t) * std::cos(a), radius(t) * std::sin(a), z - fall * t / way);
  }
  /// Seen from above, mm.
  double length() const {
    const auto part = [&](double r) {
      return 0.5 * (r * std::hypot(r, growth) + growth * growth * std::asinh(r / growth)) / growth;
    };
    return part(radius(way)) - part(first);
  }
  /// Seen from above, by the angle.
  Vec2 velocity(double t) const {
    const double a = start + t, r = radius(t);
    return {growth * std::cos(a) - r * std::sin(a), growth * std::sin(a) + r * std::cos(a)};
  }
  Vec2 left(double t) const {
    const Vec2 on = velocity(t).normalized();
    return {-on.y(), on.x()};
  }
  /// Least level distance to a point, mm: Newton's method on every turn.
  double distance(const Vec2& p) const {
    const Vec2 q = p - kCenter.head<2>();
    const double beside = std::atan2(q.y(), q.x()) - start;
    double least = std::min((at(0).head<2>() - p).norm(), (at(way).head<2>() - p).norm());
    for (double t = beside - 2.0 * kPi * std::ceil(beside / (2.0 * kPi)); t < way + kPi; t += 2.0 * kPi) {
      if (std::abs(radius(t) - q.norm()) > least + std::abs(growth)) continue;
      double u = t;
      for (int i = 0; i < 5; ++i) {
        const double c = std::cos(start + u), s = std::sin(start + u), r = radius(u);
        const Vec2 off = Vec2(r * c, r * s) - q, on(growth * c - r * s, growth * s + r * c),
                   bend(-2.0 * growth * s - r * c, 2.0 * growth * c - r * s);
        u -= off.dot(on) / (on.squaredNorm() + std::max(off.dot(bend), -0.5 * on.squaredNorm()));
      }
      if (u > 0.0 && u < way) least = std::min(least, (at(u).head<2>() - p).norm());
    }
    return least;
  }
};

Toolpath pathOf(const Spiral& s) {
  PathMaker p;
  p.arc(s.at(0), kCenter, Vec3::UnitZ(), radToDeg(s.way));
  p.path().motions.back().to = s.at(s.way);
  return p.path();
}

/// The same way as lines within `sag` of it, all of one block.
Toolpath chordsOf(const Spiral& s, double sag) {
  const double step = std::sqrt(8.0 * sag / s.radius(s.way));
  const int count = static_cast<int>(std::ceil(s.way / step));
  PathMaker p;
  for (int i = 0; i < count; ++i) p.line(s.at(s.way * i / count), s.at(s.way * (i + 1) / count));
  for (Motion& m : p.path().motions) m.source.line = 1;
  return p.path();
}

/// Half of the width of a cutter's section, mm.
using HalfWidth = double (*)(double height);
double flatWidth(double) { return 3.0; }
double ballWidth(double height) {
  return height < 3.0 ? std::sqrt(std::max(0.0, height * (6.0 - height))) : 3.0;
}

/// Sum over the heights of a cut `depth` deep of f(half width there): by substitution smooth at the tip.
template <typename F>
double overHeights(HalfWidth width, double depth, F&& f) {
  double sum = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n;
    sum += f(width(depth * s * s)) * 2.0 * s * depth / n;
  }
  return sum;
}

void expectRemoved(const Cut& c, double expected, double within = kVolume) {
  EXPECT_NEAR((c.initial - c.volume) / expected - 1.0, 0.0, within);
}

/// All points within w of a curve that bends less and does not come near itself: 2 w length + pi w^2.
TEST(SpiralVolume, LevelGrooveIsWidthTimesLengthAndItsEnds) {
  for (const double way : {2.1, 7.9, 15.3}) {
    const Spiral s{7.03, 8.1 / (2.0 * kPi), way, -4.117, 0.0};
    for (const auto& [text, width] :
         {std::pair<const char*, HalfWidth>{"1=flat:6", flatWidth}, {"1=ball:6", ballWidth}}) {
      const double expected =
          overHeights(width, -s.z, [&](double w) { return 2.0 * w * s.length() + kPi * w * w; });
      expectRemoved(cut(kBlank, pathOf(s), {tool(text)}, kGrid), expected);
    }
  }
}

/// Areas of all points within each of `reach` of the spiral, by a net of points that count by how far they
/// are in: half of a cosine wave to both sides of the border.
std::vector<double> areasWithin(const Spiral& s, const std::vector<double>& reach, double net) {
  const double soft = 1.5 * net,
               most = s.radius(s.way) + *std::max_element(reach.begin(), reach.end()) + soft;
  std::vector<double> areas(reach.size(), 0.0);
  for (double x = -most; x < most; x += net) {
    for (double y = -most; y < most; y += net) {
      const double d = s.distance(kCenter.head<2>() + Vec2(x, y));
      for (std::size_t i = 0; i < reach.size(); ++i) {
        const double in = std::clamp((reach[i] - d) / soft, -1.0, 1.0);
        areas[i] += 0.5 * (1.0 + in + std::sin(kPi * in) / kPi) * net * net;
      }
    }
  }
  return areas;
}

constexpr double kNet = 0.04;
/// Loops that a cutter of 6 mm overlaps: it leaves nothing between them, a ball ridges.
const Spiral kNarrow{5.03, 4.2 / (2.0 * kPi), 14.6, -4.117, 0.0};

TEST(SpiralVolume, TheNetIsGoodEnough) {
  const Spiral wide{7.03, 8.1 / (2.0 * kPi), 7.9, -1.0, 0.0};
  EXPECT_NEAR(areasWithin(wide, {3.0}, kNet)[0] / (6.0 * wide.length() + 9.0 * kPi), 1.0, 0.3 * kVolume);
}

TEST(SpiralVolume, LoopsThatOverlapCountOnce) {
  const double area = areasWithin(kNarrow, {3.0}, kNet)[0];
  EXPECT_LT(area, 0.85 * (6.0 * kNarrow.length() + 9.0 * kPi));
  expectRemoved(cut(kBlank, pathOf(kNarrow), {tool("1=flat:6")}, kGrid), -kNarrow.z * area);
}

TEST(SpiralVolume, BallLeavesRidgesBetweenLoops) {
  // Simpson's rule over the angle of the half ball, in parts: loops meet at a width of 2.1.
  std::vector<double> angles, weights, reach;
  const double meet = std::asin(2.1 / 3.0);
  for (const auto& [from, to] : {std::pair{0.0, meet}, std::pair{meet, 0.5 * kPi}}) {
    const int n = 16;
    for (int i = 0; i <= n; ++i) {
      angles.push_back(from + (to - from) * i / n);
      weights.push_back((to - from) / (3.0 * n) * (i == 0 || i == n ? 1 : i % 2 == 0 ? 2 : 4));
    }
  }
  for (const double a : angles) reach.push_back(3.0 * std::sin(a));
  const std::vector<double> areas = areasWithin(kNarrow, reach, kNet);
  double expected = (-kNarrow.z - 3.0) * areas.back();
  for (std::size_t i = 0; i < angles.size(); ++i)
    expected += weights[i] * areas[i] * 3.0 * std::sin(angles[i]);
  expectRemoved(cut(kBlank, pathOf(kNarrow), {tool("1=ball:6")}, kGrid), expected, kRidges);
}

/// Lower side of a cutter of 6 mm.
using Outline = double (*)(double r);
double bullOutline(double r) {
  return 1.0 - std::sqrt(std::max(0.0, 1.0 - std::pow(std::max(0.0, r - 2.0), 2)));
}
double coneOutline(double r) { return std::max(0.0, r - 0.5) / std::tan(degToRad(30.0)); }
double drillOutline(double r) { return r / std::tan(degToRad(59.0)); }

/// What is taken at one place in plan, mm, by the places of the way up to `reach` rad off `t`: a golden
/// section.
double depthAt(const Spiral& s, Outline outline, const Vec2& p, double t, double reach) {
  const auto low = [&](double u) {
    const Vec3 at = s.at(u);
    const double r = (at.head<2>() - p).norm();
    return at.z() + outline(std::min(r, 3.0)) + 1e3 * std::max(0.0, r - 3.0);
  };
  const double u = leastAt(low, std::max(0.0, t - reach), std::min(s.way, t + reach));
  return std::max(0.0, -low(u));
}

/// The sum over all places in plan, along the way and across it, and around its ends; for loops that are
/// apart.
double slowVolume(const Spiral& s, Outline outline) {
  const int along = 600, across = 192;
  const double reach = 3.0 / s.first;
  double sum = 0.0;
  for (int i = 0; i < along; ++i) {
    const double t = s.way * (i + 0.5) / along, r = s.radius(t), g = s.growth;
    const double speed = s.velocity(t).norm(), bend = (r * r + 2.0 * g * g) / (speed * speed * speed);
    const Vec2 left = s.left(t);
    for (int k = 0; k < across; ++k) {
      const double b = kPi * ((k + 0.5) / across - 0.5), d = 3.0 * std::sin(b);
      const double wide = 3.0 * std::cos(b) * kPi / across;
      sum += depthAt(s, outline, s.at(t).head<2>() + d * left, t, reach) * speed * (1.0 - bend * d) * wide *
             s.way / along;
    }
  }
  for (const double t : {0.0, s.way}) {
    const Vec2 beyond = (s.at(t) - s.at(t == 0.0 ? 1e-6 : s.way - 1e-6)).head<2>().normalized();
    for (int i = 0; i < across; ++i) {
      const double b = kPi * ((i + 0.5) / across - 0.5);
      const Vec2 out(std::cos(b) * beyond.x() - std::sin(b) * beyond.y(),
                     std::sin(b) * beyond.x() + std::cos(b) * beyond.y());
      for (int k = 0; k < across; ++k) {
        const double c = 0.5 * kPi * (k + 0.5) / across, d = 3.0 * std::sin(c),
                     wide = 3.0 * std::cos(c) * 0.5 * kPi / across;
        sum += depthAt(s, outline, s.at(t).head<2>() + d * out, t, reach) * d * wide * kPi / across;
      }
    }
  }
  return sum;
}

TEST(SpiralColumns, LowerEndsAreThoseOfASlowSearch) {
  const std::pair<const char*, Outline> tools[] = {
      {"1=flat:6", [](double) { return 0.0; }},
      {"1=ball:6", [](double r) { return 3.0 - std::sqrt(9.0 - r * r); }},
      {"1=bull:6:1", bullOutline},
      {"1=cone:6:1:60", coneOutline},
      {"1=drill:6:118", drillOutline}};
  int touched = 0;
  for (const double fall : {0.0, 1.0, 5.2}) {
    const Spiral s{4.03, 1.25, 9.4, -1.03, fall};
    const Toolpath path = pathOf(s);
    const CurveWay way = curveWay(path.motions[0].from, path.motions[0].to, path.arcs[0]);
    for (const auto& [text, outline] : tools) {
      const ConvexProfile profile = makeToolSolid(tool(text)).cutter.front();
      const ColumnSolid solid = columnSolid(profile);
      const std::vector<WaySweep> parts = columnParts(solid, way);
      for (int i = 1; i <= 500; ++i) {
        const double t = s.way * std::fmod(0.618034 * i, 1.0),
                     beside = 6.0 * std::fmod(0.754878 * i, 1.0) - 3.0;
        const Vec2 p = s.at(t).head<2>() + beside * s.left(t);
        double x[8] = {p.x()}, y[8] = {p.y()}, lo[8], hi[8], low = 0.0;
        const WaySweep* lowest = nullptr;
        for (const WaySweep& part : parts) {
          columnKernels().way.columns(part, x, y, 1, lo, hi);
          if (lo[0] < low) low = lo[0], lowest = &part;
        }
        ASSERT_NEAR(low, -depthAt(s, outline, p, t, 3.0 / s.first), 1e-9) << text << ' ' << fall << ' ' << i;
        // The cutter touches that point from the place that is told.
        if (lowest == nullptr) continue;
        const Vec3 there = s.at(curveSide(*lowest, {x[0], y[0], low}, 0.0, 0.0).place);
        ASSERT_NEAR(there.z() + outline(std::min(3.0, (there.head<2>() - p).norm())), low, 1e-8) << text;
        ++touched;
      }
    }
  }
  EXPECT_GT(touched, 6000);
}

TEST(SpiralVolume, FallingGroovesMatchASlowSearch) {
  const Spiral s{4.03, 1.25, 9.4, -1.03, 3.2};
  const Cut bull = cut(kBlank, pathOf(s), {tool("1=bull:6:1")}, kGrid);
  expectRemoved(bull, slowVolume(s, bullOutline));
  const Cut cone = cut(kBlank, pathOf(s), {tool("1=cone:6:1:60")}, kGrid);
  expectRemoved(cone, slowVolume(s, coneOutline), kCreases);
  const Cut drill = cut(kBlank, pathOf(s), {tool("1=drill:6:118")}, kGrid);
  expectRemoved(drill, slowVolume(s, drillOutline), kCreases);
}

/// Of each triangle the motion that made it: the spiral all of its groove, and nothing beside it.
TEST(SpiralProvenance, EachTriangleOfTheGrooveNamesTheSpiral) {
  const Spiral s{7.03, 8.1 / (2.0 * kPi), 9.7, -2.217, 0.0};
  PathMaker p;
  p.line({-35, -30, -1}, {35, -30, -1});  // before it and after it, away from it
  const Toolpath spiral = pathOf(s);
  p.path().arcs = spiral.arcs;
  p.path().motions.push_back(spiral.motions[0]);
  p.path().motions.back().source.line = 2;
  p.line({-35, 34, -1}, {35, 34, -1});
  for (const char* text : {"1=flat:6", "1=ball:6", "1=bull:6:1"}) {
    const Cut c = cut(kBlank, p.path(), {tool(text)}, kGrid);
    int groove = 0, others = 0;
    for (std::size_t i = 0; i < c.mesh.triangles.size(); ++i) {
      const auto& t = c.mesh.triangles[i];
      const Vec3 middle =
          (c.mesh.positions[t[0]] + c.mesh.positions[t[1]] + c.mesh.positions[t[2]]).cast<double>() / 3.0;
      const double beside = s.distance(middle.head<2>());
      const bool inside = middle.z() < -1e-3 && middle.z() > -9.0 && beside < 3.5;
      ++(inside ? groove : others);
      if (inside) {
        ASSERT_EQ(c.mesh.motion[i], 1u) << text << ' ' << middle.transpose();
      } else {
        ASSERT_NE(c.mesh.motion[i], 1u) << text << ' ' << middle.transpose();
      }
    }
    EXPECT_GT(groove, 10000);
    EXPECT_GT(others, 10000);
    EXPECT_GT(c.summary.removed_mm3[1], c.summary.removed_mm3[0]);
  }
}

/// A cutter of 6 mm with 2 mm of flutes, a thicker shank and a holder.
Tool shortTool() {
  Tool t = tool("1=flat:6");
  t.flute_length = 2.0;
  t.shank_diameter = 8.0;
  t.overall_length = 3.5;
  t.holder = {{0, 6}, {20, 6}};
  return t;
}

struct Touches {
  std::vector<Contact> curve, chords;
};

Touches touches(const Spiral& s, const Tool& t, double spindle = 1000.0) {
  Toolpath curve = pathOf(s), chords = chordsOf(s, 2e-4);
  for (Toolpath* path : {&curve, &chords}) {
    for (Motion& m : path->motions) m.spindle = spindle;
  }
  return {cut(kBlank, curve, {t}, kGrid).summary.contacts, cut(kBlank, chords, {t}, kGrid).summary.contacts};
}

/// What chords are off the spiral, and how near the deepest point is found.
constexpr double kDepthMm = 4e-4;

TEST(SpiralContacts, ShankBesideTheGrooveIsAsDeepAsOnChords) {
  // It begins 0.9 mm below the top, where the flutes end, and takes nothing itself.
  for (const double fall : {0.0, 0.5}) {
    const Spiral s{9.03, 12.1 / (2.0 * kPi), 9.7, -2.9 + fall, fall};
    const Touches found = touches(s, shortTool());
    ASSERT_EQ(found.curve.size(), 1u);
    ASSERT_EQ(found.chords.size(), 1u);
    const Contact& contact = found.curve[0];
    EXPECT_EQ(contact.kind, ContactKind::kShank);
    EXPECT_EQ(contact.motion, 0u);
    EXPECT_NEAR(contact.depth_mm, 0.9, 1e-4);
    // Among thousands of falling chords the search stops before it has seen all.
    EXPECT_NEAR(contact.depth_mm, found.chords[0].depth_mm, fall > 0.0 ? 0.01 : kDepthMm);
    EXPECT_NEAR(contact.where.z(), -0.9, 1e-3);
    EXPECT_GT(s.distance(contact.where.head<2>()), 3.9 - 1e-3);
    EXPECT_LT(s.distance(contact.where.head<2>()), 4.0 + 1e-6);
    // Falling it is deepest at the end of the way.
    if (fall > 0.0) {
      EXPECT_LT((contact.where - s.at(s.way)).head<2>().norm(), 4.0 + 1e-3);
    }
    // Level: what is in the way counts once, however many parts of the way touch it.
    if (fall == 0.0) {
      EXPECT_NEAR(contact.volume_mm3 / (0.9 * (8.0 * s.length() + 16.0 * kPi)), 1.0, 0.01);
    }
  }
}

TEST(SpiralContacts, HolderIsToldBesideTheShank) {
  // The holder comes 1 mm below the top. The shank is deepest beside the groove that lies under it: 1.45 mm
  // below the top and as far from the groove's edge.
  const Spiral s{15.03, 16.1 / (2.0 * kPi), 6.0, -4.5, 0.0};
  const Touches found = touches(s, shortTool());
  ASSERT_EQ(found.curve.size(), 2u);
  ASSERT_EQ(found.chords.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found.curve[i].kind, i == 0 ? ContactKind::kShank : ContactKind::kHolder);
    EXPECT_EQ(found.curve[i].kind, found.chords[i].kind);
    EXPECT_NEAR(found.curve[i].depth_mm, i == 0 ? 1.45 : 1.0, 1e-4);
    EXPECT_NEAR(found.curve[i].depth_mm, found.chords[i].depth_mm, kDepthMm);
  }
}

TEST(SpiralContacts, CutterWithoutSpindleIsAsDeepAsItGoes) {
  const Spiral s{9.03, 8.1 / (2.0 * kPi), 9.7, -1.0, 1.3};
  for (const char* text : {"1=flat:6", "1=ball:6", "1=cone:6:1:60"}) {
    const Touches found = touches(s, tool(text), 0.0);
    ASSERT_EQ(found.curve.size(), 1u) << text;
    EXPECT_EQ(found.curve[0].kind, ContactKind::kSpindleOff) << text;
    EXPECT_NEAR(found.curve[0].depth_mm, 2.3, 1e-4) << text;
  }
}

TEST(SpiralContacts, AShankThatStaysAboveIsNotTold) {
  const Spiral s{9.03, 12.1 / (2.0 * kPi), 9.7, -1.99, 0.0};
  EXPECT_TRUE(touches(s, shortTool()).curve.empty());
  const Spiral deeper{9.03, 12.1 / (2.0 * kPi), 9.7, -1.0, 1.02};  // by 0.02 mm at the end
  const Touches found = touches(deeper, shortTool());
  ASSERT_EQ(found.curve.size(), 1u);
  EXPECT_NEAR(found.curve[0].depth_mm, 0.02, 1e-4);
}

/// Helices about level axes, and about one that leans: chords are 0.05 micrometres off them.
TEST(LeaningArcs, TheirGroovesAreExact) {
  const Vec3 axes[] = {Vec3::UnitY(), -Vec3::UnitX(), Vec3(0.3, 0.9, 0.2).normalized()};
  for (const char* text : {"1=flat:6", "1=ball:6", "1=bull:6:1"}) {
    for (const Vec3& axis : axes) {
      PathMaker p;
      const Vec3 low = Vec3(0, 0, -4) - axis * axis.dot(Vec3(0, 0, -4)), out = low.normalized();
      const Vec3 center = Vec3(0.3, -0.2, -4.1) - 15.0 * out, across = axis.cross(out);
      const double half = degToRad(40.0);
      p.arc(center + 15.0 * (std::cos(half) * out - std::sin(half) * across), center, axis, 80.0, 3.0);
      const Cut c = cut(kBlank, p.path(), {tool(text)}, kGrid);
      const ConvexProfile profile = makeToolSolid(tool(text)).cutter.front();
      const Motion& m = p.path().motions[0];
      const Sweep exact(profile, m.from, m.to, &p.path().arcs[0]);
      std::vector<double> off;
      for (std::size_t i = 0; i < c.mesh.triangles.size(); ++i) {
        if (c.mesh.motion[i] != 0) continue;
        for (const std::uint32_t v : c.mesh.triangles[i]) {
          const Vec3 at = c.mesh.positions[v].cast<double>();
          if (at.z() < -1e-3) off.push_back(std::abs(exact.distance(at, 1e300)));
        }
      }
      ASSERT_GT(off.size(), 5000u) << text;
      // Vertices are rounded to float; those on edges are off by what edges are.
      std::sort(off.begin(), off.end());
      EXPECT_LT(off[off.size() / 2], 1e-6) << text;
      EXPECT_LT(off[off.size() * 9 / 10], 5e-6) << text;
    }
  }
}

}  // namespace
}  // namespace proveout::test
