// The closed forms of the surfaces that flat and ball ends leave on grid edges, against the exact swept
// distance: a swept convex solid is convex, so that a step along the normal is as far from it as the step is
// long.
#include "removal/sweep/swept_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/sweep/column_curve.h"
#include "removal/sweep/column_way.h"
#include "tests/property/random_moves.h"

namespace proveout {
namespace {

constexpr double kStepMm = 1e-3, kWithinMm = 1e-8;

class SweptBodySurfaces : public ::testing::TestWithParam<const char*> {
 protected:
  SweptBodySurfaces() {
    Tool tool = parseToolOption(GetParam()).value();
    tool.flute_length = 15.0;
    profile_ = makeToolSolid(tool).cutter.front();
    profile_.setFirstElementId(7);
    solid_ = columnSolid(profile_);
  }

  double random(double low, double high) { return moves_.number(low, high); }

  struct Line {
    Vec3 from, to;
    SweptBody body;
  };
  Line line(int style) {
    auto [from, to] = moves_.line(style);
    if (style == 4) to.z() = from.z() + 1e-5 * (to.z() - from.z());  // nearly level
    return {from, to, SweptBody(profile_, LineBody(columnLine(solid_, from, to)))};
  }

  void check(const SweptBody& body, const Vec3& p, int axis, bool below) {
    const auto surface = body.closedSurface(p, axis, below);
    if (!surface) {  // the flank of a ball
      EXPECT_TRUE(solid_.ball);
      return;
    }
    ++known_;
    const SweptField exact = body.field();
    EXPECT_NEAR(surface->normal.norm(), 1.0, 1e-12);
    double anywhere = SweptField::kAnywhere;
    const SweepSample seen = exact.sampleOutside(p + kStepMm * surface->normal, 1e-10, anywhere);
    EXPECT_NEAR(seen.value, kStepMm, kWithinMm) << "axis " << axis;
    // An end of one element is one of the next, too.
    const int element = surface->element % ConvexProfile::kEdgeIds,
              other = seen.element % ConvexProfile::kEdgeIds;
    const bool rim = surface->element >= ConvexProfile::kEdgeIds, at_end = seen.element != other;
    EXPECT_TRUE(other == element || ((rim || at_end) && std::abs(other - element) == 1))
        << surface->element << " " << seen.element;
    rims_ += rim ? 1 : 0;
  }

  /// Where the vertical through a random point enters and leaves the sweep; false if it misses.
  bool column(const Line& line, Vec3& low, Vec3& high) {
    std::array<double, 8> x{}, y{}, lo{}, hi{};
    const Vec3 end = line.from + random(0, 1) * (line.to - line.from);
    x[0] = end.x() + random(-3, 3), y[0] = end.y() + random(-3, 3);
    line.body.columns(x.data(), y.data(), 1, lo.data(), hi.data());
    low = {x[0], y[0], lo[0]};
    high = {x[0], y[0], hi[0]};
    return lo[0] < hi[0];
  }

  ConvexProfile profile_;
  ColumnSolid solid_;
  test::RandomMoves moves_{5};
  int known_ = 0, rims_ = 0;
};

TEST_P(SweptBodySurfaces, NormalsAreThoseOfTheSweep) {
  for (int i = 0; i < 20000; ++i) {
    const Line made = line(i % 8);
    const SweptBody& one = made.body;
    Vec3 low, high;
    if (!column(made, low, high)) continue;
    check(one, low, 2, true);
    if (!solid_.ball) check(one, high, 2, false);
    // A level ray from far away to a point on the vertical.
    const Vec3 inside = low + random(0.01, 0.99) * (high - low);
    const int axis = i / 8 % 2;
    const double side = i / 16 % 2 == 0 ? 1.0 : -1.0, far = 40.0;
    Vec3 from = inside;
    from[axis] -= side * far;
    const double cut = one.levelCut(from, axis == 0 ? side : 0.0, axis == 1 ? side : 0.0, far).at;
    from[axis] += side * cut;
    check(one, from, axis, false);
    if (HasFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(known_, 20000);
  if (!solid_.ball) {
    EXPECT_GT(rims_, 5000);
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, SweptBodySurfaces, ::testing::Values("1=flat:6", "2=ball:6"),
                         [](const auto& param) { return param.index == 0 ? "Flat" : "Ball"; });

/// Parts of helices, of upright arcs and of spirals: a step along the normal from where a column enters or
/// leaves the volume leads away from all of the curve, but where another part of it is near.
class CurveSurfaces : public ::testing::TestWithParam<const char*> {
 protected:
  double random(double low, double high) { return moves_.number(low, high); }

  struct Curve {
    Vec3 from, to;
    ArcGeometry arc;
  };
  Curve curve(bool helix) {
    Curve c;
    c.from = moves_.point();
    const double radius = random(4.0, 15.0), start = random(0.0, 6.28), turned = random(0.0, 6.28);
    c.arc.normal = helix ? Vec3(0, 0, 1) : Vec3(std::cos(turned), std::sin(turned), 0.0);
    c.arc.sweep_rad = random(-6.0, 6.0);
    const Vec3 u = helix ? Vec3(1, 0, 0) : Vec3(-c.arc.normal.y(), c.arc.normal.x(), 0.0);
    const Vec3 v = c.arc.normal.cross(u);
    const auto out = [&](double a) -> Vec3 { return radius * (std::cos(a) * u + std::sin(a) * v); };
    c.arc.center = c.from - out(start);
    c.to = c.arc.center + out(start + c.arc.sweep_rad) + (helix ? random(-3.0, 3.0) : 0.0) * c.arc.normal;
    return c;
  }

  /// A part of a random curve as a body of its own, and the whole curve.
  struct Part {
    int number;
    const Curve& curve;
    const ConvexProfile& profile;
    const SweptField& exact;
    std::function<CurveSide(const Vec3& p, const Vec3& on)> look;  ///< see curveSide
    SweptBody body;

    double side(const Vec3& p, const Vec3& on) const { return look(p, on).value; }
    /// The level edge from `from` begins to be in the part after `at`.
    bool beginsAt(const Vec3& from, const Vec3& on, double at) const {
      return side(from + (at - 2e-8) * on, on) >= -1e-9 && side(from + (at + 2e-8) * on, on) <= 1e-9;
    }
    /// The cutter touches the point where it is at this share of the curve.
    bool isTouchedFrom(double start, const Vec3& p) const {
      const Vec3 tip = arcPoint(arcFrame(curve.from, curve.to, curve.arc), curve.arc, start);
      return std::abs(profile.sample((p - tip).head<2>().norm(), p.z() - tip.z()).value) < 1e-6;
    }
  };
  enum class Ways { kTurns, kAll };
  /// Calls body(part) for the parts of random curves, all of the tool's profiles: turns, or in turn turns,
  /// upright arcs and spirals.
  template <typename Body>
  void forEachPart(Ways ways, Body&& body) {
    for (const ConvexProfile& profile : profiles()) {
      const ColumnSolid solid = columnSolid(profile);
      for (int i = 0; i < 300; ++i) {
        const int kind = ways == Ways::kTurns ? 0 : i % 3;
        Curve c = curve(kind != 1);
        if (kind == 2) c.to += random(0.01, 0.5) * (c.to - c.arc.center).cwiseProduct(Vec3(1, 1, 0));
        const SweptField exact(profile, c.from, c.to, &c.arc);
        const CurveWay way = curveWay(c.from, c.to, c.arc);
        const auto each = [&](const auto& parts) {
          for (const auto& part : parts) {
            const auto look = [&](const Vec3& p, const Vec3& on) {
              return curveSide(part.way, {p.x(), p.y(), p.z()}, on.x(), on.y());
            };
            body(Part{i, c, profile, exact, look, SweptBody(profile, part, &exact)});
            ASSERT_FALSE(HasFailure()) << "case " << i;
          }
        };
        if (kind == 0) each(bodiesOf<TurnBody>(columnTurns(solid, c.from, c.to, c.arc)));
        if (kind == 1) each(bodiesOf<UprightBody>(columnUprights(solid, c.from, c.to, c.arc)));
        if (kind == 2) each(bodiesOf<WayBody>(columnParts(solid, way)));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  template <typename Kind, typename Way>
  static std::vector<Kind> bodiesOf(const std::vector<Way>& ways) {
    return {ways.begin(), ways.end()};
  }
  static std::vector<ConvexProfile> profiles() {
    if (std::string(GetParam()) == "thread mill") return threadMill();
    Tool tool = parseToolOption(GetParam()).value();
    tool.flute_length = 15.0;
    return makeToolSolid(tool).cutter;
  }
  static std::vector<ConvexProfile> threadMill() {
    Tool tool;
    tool.type = ToolType::kThreadMill;
    tool.diameter = 10.0;
    tool.pitch = 1.5;
    tool.teeth = 3;
    return makeToolSolid(tool).cutter;
  }
  struct Columns {
    std::array<double, 8> x{}, y{}, lo{}, hi{};
  };
  /// Of random columns around the curve's start, where the part begins and ends.
  Columns columnsNear(const Part& part) {
    Columns at;
    for (std::size_t k = 0; k < 8; ++k)
      at.x[k] = part.curve.from.x() + random(-9, 9), at.y[k] = part.curve.from.y() + random(-9, 9);
    part.body.columns(at.x.data(), at.y.data(), 8, at.lo.data(), at.hi.data());
    return at;
  }
  /// False where none of eight columns meets the part.
  bool pointInside(const Part& part, Vec3& inside) {
    const auto [x, y, lo, hi] = columnsNear(part);
    for (std::size_t k = 0; k < 8; ++k) {
      if (lo[k] >= hi[k]) continue;
      inside = {x[k], y[k], lo[k] + random(0.02, 0.98) * (hi[k] - lo[k])};
      return true;
    }
    return false;
  }

  /// Level edges, every fourth a vertical one that ends where it is cut, as far as they start outside.
  void addEdge(const Part& part, int number, EdgeCuts& cuts) {
    Vec3 inside;
    if (!pointInside(part, inside)) return;
    const int k = cuts.count;
    const bool level = number % 4 != 0;
    const double a = random(0.0, 6.28), far = number % 2 == 0 ? random(0.1, 3.0) : 0.1;
    const Vec3 on = level ? Vec3(std::cos(a), std::sin(a), 0.0) : Vec3::Zero(), from = inside - far * on;
    if (level && part.side(from, on) <= 0.0) return;
    std::array<double, 8> x{inside.x()}, y{inside.y()}, lo{}, hi{};
    part.body.columns(x.data(), y.data(), 1, lo.data(), hi.data());
    cuts.x[k] = from.x(), cuts.y[k] = from.y();
    cuts.z[k] = level ? from.z() : number % 8 == 0 ? lo[0] : hi[0];
    cuts.dx[k] = on.x(), cuts.dy[k] = on.y();
    cuts.inside[k] = level ? far : 0.0;
    cuts.end[k] = level ? 0.0 : number % 8 == 0 ? 1.0 : -1.0;
    ++cuts.count;
  }

  void check(const SweptBody& body, const SweptField& exact, const Vec3& p, bool below) {
    const double there = exact.distance(p, 1e300);
    ASSERT_LT(there, 1e-7);
    if (there < -1e-6) return;  // covered by another part
    const SweptSurface surface = body.surface(p, 2, below);
    EXPECT_NEAR(surface.normal.norm(), 1.0, 1e-12);
    EXPECT_EQ(surface.normal.z() <= 1e-9, below || surface.normal.z() == 0.0);
    ++known_;
    // Bent surfaces and rims between the parts of a tool: most, and none by much.
    exact_ += exact.distance(p + kStepMm * surface.normal, 1e300) > (1.0 - 1e-3) * kStepMm ? 1 : 0;
  }

  test::RandomMoves moves_{11};
  int known_ = 0, exact_ = 0;
};

TEST_P(CurveSurfaces, NormalsLeadAwayFromTheCurve) {
  forEachPart(Ways::kAll, [&](const Part& part) {
    const auto [x, y, lo, hi] = columnsNear(part);
    for (std::size_t k = 0; k < 8; ++k) {
      if (lo[k] >= hi[k]) continue;
      check(part.body, part.exact, {x[k], y[k], lo[k]}, true);
      check(part.body, part.exact, {x[k], y[k], hi[k]}, false);
    }
  });
  EXPECT_GT(known_, 300);
  EXPECT_GT(exact_, 0.99 * known_);
}

/// Level edges end where the part begins, and the tool touches that point from the place that is told.
TEST_P(CurveSurfaces, LevelCutsAreWhereThePartBegins) {
  int cuts = 0, touched = 0, slopes = 0, right = 0;
  forEachPart(Ways::kAll, [&](const Part& part) {
    Vec3 inside;
    if (!pointInside(part, inside)) return;
    const double a = random(0.0, 6.28), far = part.number % 2 == 0 ? 60.0 : random(0.1, 3.0);
    const Vec3 on(std::cos(a), std::sin(a), 0.0), from = inside - far * on;
    if (part.side(from, on) <= 0.0) return;
    const EdgeCut cut = part.body.levelCut(from, on.x(), on.y(), far);
    ++cuts;
    ASSERT_TRUE(part.beginsAt(from, on, cut.at));
    touched += part.isTouchedFrom(cut.start, from + cut.at * on) ? 1 : 0;
    const double step = 1e-6;
    const double slope = part.look(inside, on).slope;
    if (slope == 0.0) return;
    ++slopes;
    const double seen =
        (part.side(inside + step * on, on) - part.side(inside - step * on, on)) / (2.0 * step);
    right += std::abs(seen - slope) < 1e-3 * (1.0 + std::abs(slope)) ? 1 : 0;
  });
  EXPECT_GT(cuts, 200);
  EXPECT_GT(touched, 0.99 * cuts);  // but where the way comes to be over the edge
  EXPECT_GT(slopes, 100);
  EXPECT_GT(right, 0.98 * slopes);  // but beside edges of the tool
}

/// Edges that are cut together end where the part begins, and the tool touches them from the place told.
TEST_P(CurveSurfaces, EdgesCutTogetherEndWhereTheTurnBegins) {
  int asked = 0, found = 0, touched = 0;
  const auto cuts = std::make_unique<EdgeCuts>();
  forEachPart(Ways::kTurns, [&](const Part& part) {
    cuts->count = 0;
    for (int k = 0; k < 13; ++k) addEdge(part, k, *cuts);
    if (cuts->count > 0) part.body.cutEdges(*cuts);
    for (int k = 0; k < cuts->count; ++k) {
      ++asked;
      if (cuts->found[k] == 0.0) continue;
      ++found;
      const bool level = cuts->end[k] == 0.0;
      const double at = level ? cuts->at[k] : 0.0;
      const Vec3 on(cuts->dx[k], cuts->dy[k], 0.0), from(cuts->x[k], cuts->y[k], cuts->z[k]);
      ASSERT_TRUE(!level || part.beginsAt(from, on, at));
      touched += part.isTouchedFrom(cuts->start[k], from + at * on) ? 1 : 0;
    }
  });
  EXPECT_GT(asked, 1000);
  EXPECT_GT(found, 0.8 * asked);
  EXPECT_GT(touched, 0.99 * found);  // but where the way comes to be over the edge
}

/// The closed forms of level and of vertical moves, whatever the tool.
TEST_P(CurveSurfaces, LevelCutsOfLevelAndVerticalMovesAreWhereTheyBegin) {
  int cuts = 0;
  for (const ConvexProfile& profile : profiles()) {
    const ColumnSolid solid = columnSolid(profile);
    for (int i = 0; i < 400; ++i) {
      const auto [from, to] = moves_.line(i % 2);
      const SweptBody body(profile, LineBody(columnLine(solid, from, to)));
      const SweptField exact = body.field();
      std::array<double, 8> x{}, y{}, lo{}, hi{};
      const Vec3 near = from + random(0, 1) * (to - from);
      x[0] = near.x() + random(-4, 4), y[0] = near.y() + random(-4, 4);
      body.columns(x.data(), y.data(), 1, lo.data(), hi.data());
      if (lo[0] >= hi[0]) continue;
      const Vec3 inside(x[0], y[0], lo[0] + random(0.02, 0.98) * (hi[0] - lo[0]));
      const double a = random(0.0, 6.28), far = i % 4 < 2 ? 60.0 : random(0.1, 3.0);
      const Vec3 on(std::cos(a), std::sin(a), 0.0), start = inside - far * on;
      if (exact.distance(start, 1e300) <= 0.0) continue;
      const double cut = body.levelCut(start, on.x(), on.y(), far).at;
      ++cuts;
      ASSERT_GE(exact.distance(start + (cut - 2e-8) * on, 1e300), -2e-8) << i;
      ASSERT_LE(exact.distance(start + (cut + 2e-8) * on, 1e300), 2e-8) << i;
    }
  }
  EXPECT_GT(cuts, 100);
}

INSTANTIATE_TEST_SUITE_P(Tools, CurveSurfaces,
                         ::testing::Values("1=flat:6", "2=ball:6", "3=bull:8:1.5", "4=cone:6:0.4:60",
                                           "5=lollipop:6:3", "thread mill"),
                         [](const auto& param) { return std::to_string(param.index); });

TEST(SweptBodySurface, OtherToolsAndArcsHaveNone) {
  Tool tool = parseToolOption("1=bull:8:1.5").value();
  const ConvexProfile bull = makeToolSolid(tool).cutter.front();
  const ColumnSolid solid = columnSolid(bull);
  const SweptBody round(bull, LineBody(columnLine(solid, Vec3::Zero(), Vec3(5, 0, 1))));
  EXPECT_FALSE(round.closedSurface(Vec3(2, 0, 0.4), 2, true));
  const ConvexProfile flat = makeToolSolid(parseToolOption("1=flat:8").value()).cutter.front();
  const ColumnSolid cylinder = columnSolid(flat);
  const Vec3 from = Vec3::Zero(), to(5, 0, 0);
  EXPECT_TRUE(
      SweptBody(flat, LineBody(columnLine(cylinder, from, to))).closedSurface(Vec3(2, 0, 0), 2, true));
  // A chord of a curve, which is known exactly.
  const SweptField curve(flat, from, to, nullptr);
  EXPECT_FALSE(SweptBody(flat, ChordBody(columnLine(cylinder, from, to)), &curve)
                   .closedSurface(Vec3(2, 0, 0), 2, true));
}

}  // namespace
}  // namespace proveout
