// What tools sweep whose axis leans but stands still, on a coarse grid against a dense reference that knows
// nothing of profiles, sweeps and frames: outlines as drawn, and places of the way between which the tool's
// distance can change by no more than the way is long.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "removal/sweep/motion_bodies.h"
#include "tests/property/drawn_outline.h"
#include "tests/property/random_moves.h"
#include "tests/property/swept_columns.h"
#include "tests/support/golden_section.h"
#include "tests/unit/removal/cut_fixture.h"
#include "tests/unit/tool/drawings.h"

namespace proveout {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
/// Chords that arcs are drawn with a quarter turn: within 3e-5 mm.
constexpr int kSteps = 200;
constexpr double kWrongMm = 1e-4;

/// A motion of a tool that leans, and the reference for it.
struct Case {
  Vec3 axis = Vec3::UnitZ();
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  bool curved = false;
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double sweep = 0.0, rise = 0.0;

  Vec3 at(double t) const {
    if (!curved) return from + t * (to - from);
    const Vec3 u = from - center, v = normal.cross(u);
    return center + std::cos(t * sweep) * u + std::sin(t * sweep) * v + t * rise * normal;
  }
  double length() const {
    return curved ? std::hypot((from - center).norm() * sweep, rise) : (to - from).norm();
  }
};

class Reference {
 public:
  Reference(const test::DrawnOutline& outline, const Case& of)
      : outline_(outline), case_(of), length_(of.length()) {}

  double toolDistance(const Vec3& p, double t) const {
    const Vec3 q = p - case_.at(t);
    const double z = q.dot(case_.axis);
    return outline_.distance((q - z * case_.axis).norm(), z);
  }
  /// Whether the tool comes to hold the point; what is nearer to its surface than a micrometre may be either.
  bool holds(const Vec3& p) const {
    const double a = toolDistance(p, 0.0), b = toolDistance(p, 1.0);
    return a < 0.0 || b < 0.0 || holdsBetween(p, 0.0, a, 1.0, b);
  }
  /// The least distance, negative inside: of dense places, and between those beside the least ones.
  double distance(const Vec3& p) const {
    constexpr double kPlaceMm = 0.08;
    const auto places = static_cast<std::size_t>(std::clamp(length_ / kPlaceMm, 48.0, 1024.0));
    const double step = 1.0 / static_cast<double>(places);
    std::vector<double> d;
    for (std::size_t i = 0; i <= places; ++i) d.push_back(toolDistance(p, static_cast<double>(i) * step));
    double best = *std::min_element(d.begin(), d.end());
    const double near = best + length_ * step;
    for (std::size_t i = 0; i <= places; ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, places);
      if (d[i] > near || d[before] < d[i] || (after > i && d[after] <= d[i])) continue;
      const auto f = [&](double t) { return toolDistance(p, t); };
      best = std::min(best, f(test::leastAt(f, static_cast<double>(before) * step,
                                            static_cast<double>(after) * step, 1e-9)));
    }
    return best;
  }

 private:
  bool holdsBetween(const Vec3& p, double t0, double d0, double t1, double d1) const {
    const double way = length_ * (t1 - t0);
    if (d0 + d1 - way >= 0.0 || way < 1e-6) return false;
    const double middle = 0.5 * (t0 + t1), d = toolDistance(p, middle);
    return d < 0.0 || holdsBetween(p, t0, d0, middle, d) || holdsBetween(p, middle, d, t1, d1);
  }

  const test::DrawnOutline& outline_;
  const Case& case_;
  double length_;
};

class LeaningBodies : public ::testing::TestWithParam<std::size_t> {
 protected:
  double random(double low, double high) { return moves_.number(low, high); }
  Vec3 direction() { return Vec3(random(-1, 1), random(-1, 1), random(-1, 1)).normalized(); }
  Vec3 axisOf(int style) {
    if (style == 0) return Vec3::Unit(static_cast<int>(random(0.0, 2.0)));
    if (style == 1) return -Vec3::UnitZ();
    if (style == 2) return (Vec3::UnitZ() + 1e-7 * direction()).normalized();
    if (style == 3) return -Vec3::UnitY();
    return direction();
  }
  /// Unit, at right angles to `axis`.
  Vec3 beside(const Vec3& axis) {
    const Vec3 any = direction();
    return (any - any.dot(axis) * axis).normalized();
  }
  Case line(int style) {
    Case c;
    c.axis = axisOf(style % 7);
    c.from = moves_.point();
    c.to = c.from + random(0.5, 9.0) * direction();
    if (style % 5 == 0) c.to = c.from + random(-9.0, 9.0) * c.axis;
    if (style % 5 == 1) c.to = c.from + random(0.5, 9.0) * beside(c.axis);
    if (style % 5 == 2) c.to = c.from + random(-9.0, 9.0) * Vec3::Unit(style / 5 % 3);
    if (style % 23 == 3) c.to = c.from;
    return c;
  }
  /// 0: about the tool's axis, 1: a helix about it, 2: about any axis.
  Case arc(int style, int kind) {
    Case c;
    c.curved = true;
    c.axis = axisOf(style % 7);
    c.from = moves_.point();
    c.normal = kind == 2 ? direction() : random(-1, 1) < 0.0 ? Vec3(-c.axis) : c.axis;
    const double radius = random(0.3, 9.0);
    c.center = c.from - radius * beside(c.normal);
    c.sweep = random(-6.28, 6.28);
    c.rise = kind == 1 ? random(-4.0, 4.0) : 0.0;
    c.to = c.at(1.0);
    return c;
  }
  Case any(int i) { return i % 5 < 3 ? line(i / 5 * 3 + i % 5) : arc(i, i % 5 == 3 ? 0 : 1 + i / 5 % 2); }

  static Toolpath pathOf(const Case& c) {
    Toolpath path;
    Motion m;
    m.from = c.from;
    m.to = c.to;
    m.tool = 1;
    m.spindle = 1000.0;
    m.axis = 0;
    path.axes.push_back({c.axis, c.axis, 0, {}, PoseLaw::kVector, nullptr});
    if (c.curved) {
      m.arc = 0;
      path.arcs.push_back({c.center, c.normal, c.sweep});
    }
    path.motions.push_back(m);
    return path;
  }

  /// What the engine says of one cutter.
  struct Bodies {
    BodyStore store;
    std::vector<ColumnSolid> solids;
    std::vector<SweptBody> all;
  };
  static void makeBodies(const Toolpath& path, const std::vector<ConvexProfile>& parts, Bodies& out) {
    for (const ConvexProfile& part : parts) out.solids.push_back(columnSolid(part));
    BodyMaker maker(path, 1.0, 100.0, out.store);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (const MotionBody& made : maker.make(0, {&parts[k], &out.solids[k], true, true}))
        out.all.push_back(made.body);
    }
  }
  test::RandomMoves moves_{55};
};

TEST_P(LeaningBodies, NoSampleIsOnTheWrongSide) {
  const test::Drawing drawing = test::drawings(kSteps)[GetParam()];
  const test::DrawnOutline outline(drawing);
  const ToolSolid solid = makeToolSolid(drawing.tool);
  const double slack = drawing.hollow + kWrongMm;
  double wrong = 0.0, off = 0.0;
  int inside = 0, samples = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = any(i);
    const Toolpath path = pathOf(c);
    Bodies bodies;
    makeBodies(path, solid.cutter, bodies);
    Box3 box;
    for (const ConvexProfile& part : solid.cutter)
      box.extend(motionField(part, wayOf(path, path.motions[0])).bounds());
    const Reference reference(outline, c);
    const double step = std::cbrt(box.size().prod() / 700.0);
    const Vec3 first = box.min - step * Vec3(random(0, 1), random(0, 1), random(0, 1));
    for (double x = first.x(); x < box.max.x() + step; x += step) {
      for (double y = first.y(); y < box.max.y() + step; y += step) {
        const auto covered = test::columnSpans(bodies.all, x, y, 0.0);
        for (double z = first.z(); z < box.max.z() + step; z += step) {
          const bool in = std::any_of(covered.begin(), covered.end(),
                                      [&](const auto& s) { return s[0] < z && z < s[1]; });
          const Vec3 p(x, y, z);
          ++samples;
          inside += in ? 1 : 0;
          if (reference.holds(p) != in) wrong = std::max(wrong, std::abs(reference.distance(p)));
          ASSERT_LE(wrong, slack) << drawing.name << ", motion " << i << " at " << p.transpose();
        }
        // The ends of what is covered lie on the surface.
        for (const auto& s : covered) {
          for (const double z : s) {
            off = std::max(off, std::abs(reference.distance({x, y, z})));
            ASSERT_LE(off, slack) << drawing.name << ", motion " << i << " at " << x << ' ' << y << ' ' << z;
          }
        }
      }
    }
  }
  EXPECT_GT(inside, samples / 50);
  std::printf("%s: %d samples, %d inside, largest error %.3g mm, of ends of columns %.3g mm\n",
              drawing.name.c_str(), samples, inside, wrong, off);
}

INSTANTIATE_TEST_SUITE_P(Tools, LeaningBodies, ::testing::Range(std::size_t{0}, test::drawings(1).size()));

// The whole of the engine, against closed forms.

/// Turned about +x: +z leans towards -y.
Vec3 leaning(double degrees) { return {0.0, -std::sin(degToRad(degrees)), std::cos(degToRad(degrees))}; }

class LeaningCuts : public ::testing::Test {
 protected:
  LeaningCuts() { path_.axes.reserve(4); }

  Motion& line(const Vec3& axis, const Vec3& from, const Vec3& to) {
    Motion m;
    m.from = from;
    m.to = to;
    m.tool = 1;
    m.spindle = 1000.0;
    m.kind = MotionKind::kFeed;
    m.source.line = static_cast<std::uint32_t>(path_.motions.size() + 1);
    m.axis = static_cast<std::int32_t>(path_.axes.size());
    path_.axes.push_back({axis, axis, 0, {}, PoseLaw::kVector, nullptr});
    path_.motions.push_back(m);
    path_.files = {"test"};
    return path_.motions.back();
  }
  static Tool longTool(const std::string& option) {
    Tool tool = test::tool(option);
    tool.flute_length = 120.0;
    return tool;
  }

  Toolpath path_;
};

double outsideOf(const Box3& box, const Vec3& p) {
  const Vec3 d = (p - box.center()).cwiseAbs() - 0.5 * box.size();
  return d.cwiseMax(0.0).norm() + std::min(0.0, d.maxCoeff());
}

/// A slot by a flat end whose axis lies along -y: that of an upright one in a block that is turned.
TEST_F(LeaningCuts, ASlotAtRightAnglesIsThatOfATurnedBlock) {
  const Vec3 axis(0.0, -1.0, 0.0);
  line(axis, {-5.0, 4.0, 3.2}, {25.3, 4.0, 7.1});
  const Box3 box{{-20.0, 0.0, -10.0}, {40.0, 15.0, 20.0}};
  const test::Cut side = test::cut(BoxShape{box.min, box.max}, path_, {longTool("1=flat:8")}, 0.5);
  // (x, y, z) of the block turned is (x, z, -y) here.
  Toolpath upright;
  upright.files = {"test"};
  upright.motions = path_.motions;
  upright.motions[0].axis = -1;
  for (Vec3* p : {&upright.motions[0].from, &upright.motions[0].to}) *p = Vec3(p->x(), p->z(), -p->y());
  const Box3 turned{{-20.0, -10.0, -15.0}, {40.0, 20.0, 0.0}};
  const test::Cut up = test::cut(BoxShape{turned.min, turned.max}, upright, {longTool("1=flat:8")}, 0.5);
  EXPECT_NEAR(side.initial - side.volume, up.initial - up.volume, 1e-5 * (up.initial - up.volume));

  const Vec2 a(-5.0, 3.2), b(25.3, 7.1);
  double off = 0.0;
  for (const auto& vertex : side.mesh.positions) {
    const Vec3 p = vertex.cast<double>();
    const Vec2 q(p.x(), p.z());
    const double t = std::clamp((q - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    const double aside = (q - a - t * (b - a)).norm() - 4.0;
    const double slot = std::max(aside, p.y() - 4.0);
    off = std::max(off, std::min(std::abs(outsideOf(box, p)), std::abs(slot)));
  }
  std::printf("slot at right angles: vertices within %.3g mm\n", off);
  EXPECT_LT(off, 1e-3);
}

/// A cylinder through a slab whose axis leans from the slab's normal takes pi r^2 thickness / cos.
TEST_F(LeaningCuts, ObliqueHolesAreWholeCylinders) {
  for (const double degrees : {30.0, 54.7, 70.528779}) {
    path_ = {};
    const Vec3 axis = leaning(degrees);
    line(axis, 45.0 * axis, -45.0 * axis);
    const Box3 slab{{-12.0, -45.0, -5.0}, {12.0, 45.0, 5.0}};
    const test::Cut cut = test::cut(BoxShape{slab.min, slab.max}, path_, {longTool("1=flat:6")}, 0.3);
    const double exact = kPi * 9.0 * 10.0 / axis.z(), removed = cut.initial - cut.volume;
    double off = 0.0;
    for (const auto& vertex : cut.mesh.positions) {
      const Vec3 p = vertex.cast<double>();
      const double around = std::abs((p - p.dot(axis) * axis).norm() - 3.0);
      off = std::max(off, std::min(around, std::abs(outsideOf(slab, p))));
    }
    std::printf("hole at %g degrees: volume off by %.3g, vertices by %.3g mm\n", degrees,
                removed / exact - 1.0, off);
    EXPECT_NEAR(removed, exact, 1e-5 * exact);
    EXPECT_LT(off, 1e-3);
  }
}

/// As long as its flank stays out, what a ball leaves does not tell where its axis points.
TEST_F(LeaningCuts, ABallLeavesItsSphere) {
  const Vec3 axis = leaning(8.0), tip = -3.0 * axis + Vec3(0.0, 0.0, 1.0);
  line(axis, tip + Vec3(-30.0, 1.3, 0.0), tip + Vec3(30.0, 1.3, 0.0));
  const Box3 box{{-20.0, -8.0, -6.0}, {20.0, 8.0, 0.0}};
  const test::Cut cut = test::cut(BoxShape{box.min, box.max}, path_, {longTool("1=ball:6")}, 0.4);
  const double exact = 40.0 * (9.0 * std::acos(1.0 / 3.0) - std::sqrt(8.0));
  EXPECT_NEAR(cut.initial - cut.volume, exact, 1e-5 * exact);
  double off = 0.0;
  for (const auto& vertex : cut.mesh.positions) {
    const Vec3 p = vertex.cast<double>();
    const double around = std::abs(std::hypot(p.y() - 1.3, p.z() - 1.0) - 3.0);
    off = std::max(off, std::min(around, std::abs(outsideOf(box, p))));
  }
  std::printf("leaning ball: vertices within %.3g mm\n", off);
  EXPECT_LT(off, 1e-3);
}

/// A full circle in a tilted plane leaves the ring that its tool sweeps.
TEST_F(LeaningCuts, ACircleInATiltedPlaneLeavesARing) {
  const Vec3 axis = leaning(40.0), x = Vec3::UnitX();
  Motion& m = line(axis, 10.0 * x, 10.0 * x);
  m.arc = 0;
  path_.arcs.push_back({Vec3::Zero(), axis, 2.0 * kPi});
  Tool tool = test::tool("1=flat:4");
  tool.flute_length = 3.0;
  const Box3 box{{-15.0, -15.0, -15.0}, {15.0, 15.0, 15.0}};
  const test::Cut one = test::cut(BoxShape{box.min, box.max}, path_, {tool}, 0.5, 1);
  const double exact = kPi * (144.0 - 64.0) * 3.0;
  double off = 0.0;
  for (const auto& vertex : one.mesh.positions) {
    const Vec3 p = vertex.cast<double>();
    const double z = p.dot(axis), r = (p - z * axis).norm();
    const double ring = std::max(std::abs(r - 10.0) - 2.0, std::abs(z - 1.5) - 1.5);
    off = std::max(off, std::min(std::abs(ring), std::abs(outsideOf(box, p))));
  }
  std::printf("ring: volume off by %.3g, vertices by %.3g mm\n", (one.initial - one.volume) / exact - 1.0,
              off);
  EXPECT_NEAR(one.initial - one.volume, exact, 1e-5 * exact);
  EXPECT_LT(off, 1e-3);
  // Threads do not change a bit.
  const test::Cut four = test::cut(BoxShape{box.min, box.max}, path_, {tool}, 0.5, 4);
  EXPECT_EQ(one.volume, four.volume);
  ASSERT_EQ(one.mesh.positions.size(), four.mesh.positions.size());
  for (std::size_t i = 0; i < one.mesh.positions.size(); ++i)
    ASSERT_EQ(one.mesh.positions[i], four.mesh.positions[i]);
}

/// A rapid that leans into the block is told with its depth; what the same tool cuts upright behind a
/// leaning way is not taken for its own hole.
TEST_F(LeaningCuts, ContactsOfLeaningToolsAreTold) {
  const Vec3 axis = leaning(30.0);
  line(axis, 20.0 * axis, -2.0 * axis).kind = MotionKind::kRapid;
  const Box3 box{{-10.0, -10.0, -10.0}, {10.0, 10.0, 0.0}};
  const test::Cut cut = test::cut(BoxShape{box.min, box.max}, path_, {longTool("1=drill:4:118")}, 0.5);
  ASSERT_EQ(cut.summary.contacts.size(), 1u);
  EXPECT_EQ(cut.summary.contacts[0].kind, ContactKind::kRapid);
  EXPECT_NEAR(cut.summary.contacts[0].depth_mm, 2.0 * axis.z(), 0.05);
}

TEST_F(LeaningCuts, TheLeastTouchOfALeaningRimIsFound) {
  const Vec3 axis = leaning(30.0);
  // The rim's lowest point is 0.02 below the top; between the samples.
  const double low = 4.0 * std::sin(degToRad(30.0));
  line(axis, Vec3(0.1, 0.2, low - 0.02) + 20.0 * axis, Vec3(0.1, 0.2, low - 0.02)).kind = MotionKind::kRapid;
  const Box3 box{{-10.0, -10.0, -10.0}, {10.0, 10.0, 0.0}};
  const test::Cut cut = test::cut(BoxShape{box.min, box.max}, path_, {longTool("1=flat:8")}, 0.5);
  ASSERT_EQ(cut.summary.contacts.size(), 1u);
  EXPECT_NEAR(cut.summary.contacts[0].depth_mm, 0.02, 2e-3);
}

TEST_F(LeaningCuts, AnAxisThatTurnsCuts) {
  line(leaning(30.0), {0.0, 0.0, -3.0}, {1.0, 0.0, -3.0});
  path_.axes[0].to = Vec3::UnitZ();
  RemovalOptions options;
  options.resolution_mm = 0.5;
  Progress quiet;
  Result<Stock> stock = Stock::create(BoxShape{{-10.0, -10.0, -10.0}, {10.0, 10.0, 0.0}}, options, quiet);
  ASSERT_TRUE(stock);
  const Result<RemovalSummary> removal = stock->remove(path_, {longTool("1=flat:8")}, options, quiet);
  ASSERT_TRUE(removal);
  EXPECT_GT(countedVolume(*removal), 40.0);
}

}  // namespace
}  // namespace proveout
