// Contours of short lines with rounded points, as CAM systems write them: rounding is no interference, and
// what the cutter does not fit into still is.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "comp_mill.h"
#include "core/geometry/plane.h"
#include "core/nc/services/cutter_comp.h"

namespace proveout {
namespace {

using comp_test::Mill;
using Curve = std::function<Vec2(double)>;  ///< of 0..1, closed, counter-clockwise

double rounded(double value, double quantum) { return std::round(value / quantum) * quantum; }

Curve ellipse(double a, double b) {
  return [=](double t) { return Vec2(a * std::cos(2 * kPi * t), b * std::sin(2 * kPi * t)); };
}

/// A circle with `n` waves; concave where the waves are high enough.
Curve wavy(double radius, double height, int n) {
  return [=](double t) {
    const double w = 2 * kPi * t, r = radius + height * std::cos(n * w);
    return Vec2(r * std::cos(w), r * std::sin(w));
  };
}

/// Two half circles and two straights.
Curve oval(double length, double radius) {
  return [=](double t) {
    const double straight = length / (2 * length + 2 * kPi * radius), half = 0.5 - straight;
    const bool back = t >= 0.5;
    const double u = back ? t - 0.5 : t;
    const Vec2 p = u < straight ? Vec2(length * (u / straight - 0.5), -radius)
                                : Vec2(0.5 * length + radius * std::sin(kPi * (u - straight) / half),
                                       -radius * std::cos(kPi * (u - straight) / half));
    return back ? Vec2(-p) : p;
  };
}

std::vector<Vec2> points(const Curve& curve, int count, double quantum) {
  std::vector<Vec2> result;
  for (int i = 0; i < count; ++i) {
    const Vec2 p = curve(static_cast<double>(i) / count);
    const Vec2 q(rounded(p.x(), quantum), rounded(p.y(), quantum));
    if (result.empty() || q != result.back()) result.push_back(q);
  }
  result.push_back(result.front());
  return result;
}

/// From `from` onto the first point, along all of them, and back.
Mill mill(const std::vector<Vec2>& contour, const Vec2& from, double rho, const CutterCompPolicy& policy) {
  Mill run(from, policy);
  run.side(rho);
  for (const Vec2& p : contour) run.line(p.x(), p.y());
  run.off().line(from.x(), from.y());
  return run;
}

/// Distance of `p` to the sides number [first, last) of the contour.
double distance(const std::vector<Vec2>& contour, const Vec2& p, std::size_t first, std::size_t last) {
  double best = 1e300;
  for (std::size_t i = std::max<std::size_t>(first, 1); i < std::min(last, contour.size()); ++i) {
    best = std::min(best, distanceToSegment(p, contour[i - 1], contour[i]));
  }
  return best;
}

struct Quality {
  double overcut = 0.0, off = 0.0;  ///< mm, nearest and farthest place of the path against the radius
  double length = 0.0;              ///< mm
};

Quality measured(const std::vector<Vec2>& contour, const Mill& run, double r) {
  Quality q;
  const auto pieces = run.moves();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const CompPiece& p = pieces[i];
    if (p.tag == 1 || p.tag == run.tag) continue;
    const Vec2 step = (p.to - p.from).head<2>();
    q.length += step.norm();
    // Around the block, which has the number of its side, and now and then all over the contour.
    const std::size_t at = p.tag, around = i % 40 == 0 ? contour.size() : 400;
    for (const double t : {0.5, 1.0}) {
      const double d =
          distance(contour, p.from.head<2>() + t * step, at > around ? at - around : 0, at + around);
      q.overcut = std::max(q.overcut, r - d);
      q.off = std::max(q.off, d - r);
    }
  }
  return q;
}

struct Case {
  const char* name;
  Curve curve;
  int count;
  double rho;  ///< of the contour counter-clockwise: > 0 inside
};

/// Where the cutter comes from: off the first point, across the curve.
Vec2 approach(const Case& c) {
  const Vec2 along = (c.curve(1e-4) - c.curve(1.0 - 1e-4)).normalized();
  return c.curve(0.0) + 2.0 * c.rho * leftOf(along);
}

CutterCompPolicy alarming() {
  CutterCompPolicy policy;
  policy.interference_alarm = true;
  return policy;
}

/// As a control sets it that has no interference check and goes round corners.
CutterCompPolicy unchecked() {
  CutterCompPolicy policy;
  policy.interference_check = false;
  policy.outer_corner = CompOuterCorner::kArc;
  policy.start_ramp = policy.cancel_ramp = CompRamp::kA;
  return policy;
}

class FineContour : public testing::TestWithParam<Case> {};

TEST_P(FineContour, PathKeepsTheRadiusWithinTheRounding) {
  const Case& c = GetParam();
  for (const int variant : {0, 1, 2}) {
    SCOPED_TRACE(variant);
    const bool reversed = variant == 1;
    auto contour = points(c.curve, c.count, 0.001);
    if (reversed) std::reverse(contour.begin(), contour.end());
    const CutterCompPolicy policy = variant == 2 ? unchecked() : alarming();
    const Mill run = mill(contour, approach(c), reversed ? -c.rho : c.rho, policy);
    ASSERT_EQ(static_cast<int>(run.status.error), 0) << "block " << run.status.tag;
    EXPECT_TRUE(run.out.notes.empty());
    run.expectContinuous();
    const Quality q = measured(contour, run, std::abs(c.rho));
    EXPECT_LT(q.overcut, 0.002);
    EXPECT_LT(q.off, 0.002);
    // A closed curve's offset is longer or shorter by a turn of the radius; rounding adds to both.
    const auto exact = points(c.curve, 100000, 1e-12);
    double length = -2.0 * kPi * c.rho;
    for (std::size_t i = 1; i < exact.size(); ++i) length += (exact[i] - exact[i - 1]).norm();
    EXPECT_NEAR(q.length, length, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, FineContour,
                         testing::Values(Case{"Ellipse4000Inside", ellipse(40, 30), 4000, 10},
                                         Case{"Ellipse4000Outside", ellipse(40, 30), 4000, -10},
                                         Case{"Ellipse12000Inside", ellipse(40, 30), 12000, 3},
                                         Case{"Ellipse12000Outside", ellipse(40, 30), 12000, -3},
                                         Case{"EllipseNearlyAsTightAsTheCutter", ellipse(40, 30), 4000, 21.5},
                                         Case{"ChordsOfAHundredthInside", ellipse(40, 30), 22000, 10},
                                         Case{"ChordsOfAHundredthOutside", ellipse(40, 30), 22000, -10},
                                         Case{"WavesInside", wavy(30, 1.5, 6), 8000, 8},
                                         Case{"WavesOutside", wavy(30, 1.5, 6), 8000, -8},
                                         Case{"OvalInside", oval(60, 12), 6000, 10},
                                         Case{"OvalOutside", oval(60, 12), 6000, -10}),
                         [](const auto& c) { return c.param.name; });

TEST_P(FineContour, SoItDoesWithTwoDecimals) {
  const Case& c = GetParam();
  for (const bool reversed : {false, true}) {
    SCOPED_TRACE(reversed);
    auto contour = points(c.curve, c.count, 0.01);
    if (reversed) std::reverse(contour.begin(), contour.end());
    const double rho = reversed ? -c.rho : c.rho;
    Mill run(approach(c), alarming());
    run.decimal(0.01).side(rho);
    for (const Vec2& p : contour) run.line(p.x(), p.y());
    run.off().line(approach(c).x(), approach(c).y());
    ASSERT_EQ(static_cast<int>(run.status.error), 0) << "block " << run.status.tag;
    EXPECT_TRUE(run.out.notes.empty());
    const Quality q = measured(contour, run, std::abs(c.rho));
    EXPECT_LT(q.overcut, 0.02);
    EXPECT_LT(q.off, 0.02);
  }
}

TEST(FineContourFaults, TwoDecimalsHideNoCutterThatIsTooLarge) {
  const Case c{"", ellipse(30, 40), 4000, 24.0};
  Mill run(approach(c), alarming());
  run.decimal(0.01).side(c.rho);
  for (const Vec2& p : points(c.curve, c.count, 0.01)) run.line(p.x(), p.y());
  EXPECT_EQ(run.status.error, CompError::kInterference);
}

TEST(FineContourFaults, CutterLargerThanTheTightestPlaceIsAnAlarmThere) {
  // The tightest radius, 22.5 mm, is at 1/4 and 3/4 of the way.
  const Case c{"", ellipse(30, 40), 4000, 23.0};
  for (const bool alarm : {true, false}) {
    CutterCompPolicy policy;
    policy.interference_alarm = alarm;
    const Mill run = mill(points(c.curve, c.count, 0.001), approach(c), c.rho, policy);
    EXPECT_EQ(run.status.error, CompError::kInterference);
    EXPECT_NEAR(static_cast<double>(run.status.tag), 1000.0, 60.0);
  }
}

TEST(FineContourFaults, FilletOfShortLinesSmallerThanTheCutterIsAnAlarm) {
  // 90 degrees of radius 9.99 under a cutter of 10: it would cut in by 0.01 (sqrt(2) - 1) = 0.004 mm.
  for (const double radius : {9.99, 10.01}) {
    CutterCompPolicy policy;
    policy.interference_alarm = true;
    Mill run({-60, 30}, policy);
    run.side(10).line(-50, 0);
    for (int i = 0; i <= 300; ++i) {
      const double w = kPi / 2 * i / 300;
      run.line(rounded(radius * std::sin(w), 0.001), rounded(radius * (1 - std::cos(w)), 0.001));
    }
    run.line(radius, 60).off().line(-30, 60);
    EXPECT_EQ(run.status.ok(), radius > 10) << radius;
    if (radius < 10) {
      EXPECT_GE(run.status.tag, 3u);
      EXPECT_LE(run.status.tag, 303u);
    }
  }
}

TEST(FineContourFaults, RoundedFilletArcsAsLargeAsTheCutterFit) {
  // Tangent arcs of the cutter's radius between lines in many directions, with three decimals.
  for (int k = 0; k < 90; ++k) {
    const double w = degToRad(1.7 * k);
    const auto at = [&](double x, double y) {
      return Vec2(rounded(x * std::cos(w) - y * std::sin(w), 0.001),
                  rounded(x * std::sin(w) + y * std::cos(w), 0.001));
    };
    CutterCompPolicy policy;
    policy.interference_alarm = true;
    const Vec2 start = at(-30, 20), a = at(-20, 0), b = at(20, 0), c = at(25, 5), d = at(25, 40),
               m = at(20, 5);
    Mill run(start, policy);
    run.side(5)
        .line(a.x(), a.y())
        .line(b.x(), b.y())
        .arc(c.x(), c.y(), m.x(), m.y(), true)
        .line(d.x(), d.y());
    run.off().line(start.x(), start.y());
    ASSERT_TRUE(run.status.ok()) << k << " block " << run.status.tag;
    for (const CompPiece& p : run.moves()) {
      if (p.tag == 1 || p.tag == run.tag) continue;
      EXPECT_GT((p.to.head<2>() - b).norm(), 5.0 - 0.003);
      EXPECT_GT((p.to.head<2>() - c).norm(), 5.0 - 0.003);
    }
  }
}

TEST(FineContourFaults, SlotOfShortLinesNarrowerThanTheCutterIsAnAlarm) {
  CutterCompPolicy policy;
  policy.interference_alarm = true;
  policy.extra_look_ahead = 8;
  Mill run({-60, 30}, policy);
  run.side(5)
      .line(-50, 0)
      .line(0, 0)
      .line(0, -0.05)
      .line(9.9, -0.05)
      .line(9.9, 0)
      .line(50, 0)
      .off()
      .line(60, 30);
  EXPECT_EQ(run.status.error, CompError::kInterference);
}

}  // namespace
}  // namespace proveout
