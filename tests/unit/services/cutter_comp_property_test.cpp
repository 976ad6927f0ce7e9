// Properties of compensated contours, checked by brute force: the tool centre keeps its distance to the
// contour.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "comp_mill.h"
#include "core/nc/services/cutter_comp.h"

namespace proveout {
namespace {

using comp_test::Mill;

/// A closed contour, counter-clockwise, as elements; `arc` with a centre.
struct Side {
  Vec2 from, to;
  bool arc = false;
  Vec2 center = Vec2::Zero();
  bool ccw = true;
};
using Contour = std::vector<Side>;

Vec2 pointOn(const Side& s, double t) {
  if (!s.arc) return s.from + t * (s.to - s.from);
  const Vec2 a = s.from - s.center, b = s.to - s.center;
  double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (s.ccw && sweep < 0) sweep += 2 * kPi;
  if (!s.ccw && sweep > 0) sweep -= 2 * kPi;
  const double c = std::cos(t * sweep), n = std::sin(t * sweep);
  return s.center + Vec2(a.x() * c - a.y() * n, a.x() * n + a.y() * c);
}

/// Points along the contour, close together.
std::vector<Vec2> samples(const Contour& contour, int per_side) {
  std::vector<Vec2> points;
  for (const Side& s : contour) {
    for (int i = 0; i < per_side; ++i) points.push_back(pointOn(s, static_cast<double>(i) / per_side));
  }
  return points;
}

/// Exact distance of a point to a straight side; to an arc by its circle where the foot lies on it.
double distanceTo(const Side& s, const Vec2& p) {
  const double ends = std::min((p - s.from).norm(), (p - s.to).norm());
  if (!s.arc) {
    const Vec2 d = s.to - s.from;
    const double t = (p - s.from).dot(d) / d.squaredNorm();
    return t > 0 && t < 1 ? std::abs(d.x() * (p - s.from).y() - d.y() * (p - s.from).x()) / d.norm() : ends;
  }
  const Vec2 a = s.from - s.center, b = s.to - s.center, q = p - s.center;
  const auto angle = [&](const Vec2& v) {
    double x = std::atan2(a.x() * v.y() - a.y() * v.x(), a.dot(v)) * (s.ccw ? 1 : -1);
    return x < 0 ? x + 2 * kPi : x;
  };
  return angle(q) <= angle(b) ? std::abs(q.norm() - a.norm()) : ends;
}

double distanceTo(const Contour& contour, const Vec2& p) {
  double best = 1e300;
  for (const Side& s : contour) best = std::min(best, distanceTo(s, p));
  return best;
}

Contour polygon(const std::vector<Vec2>& corners) {
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    contour.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  return contour;
}

/// Rounds every corner with tangent arcs of `radius` (corners of both kinds).
Contour rounded(const std::vector<Vec2>& corners, double radius) {
  Contour contour;
  const std::size_t n = corners.size();
  std::vector<Side> arcs;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = corners[i], in = (p - corners[(i + n - 1) % n]).normalized();
    const Vec2 out = (corners[(i + 1) % n] - p).normalized();
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const double leg = radius * std::tan(std::abs(turn) / 2);
    const double side = turn > 0 ? 1.0 : -1.0;
    const Vec2 start = p - leg * in;
    arcs.push_back({start, p + leg * out, true, start + side * radius * Vec2(-in.y(), in.x()), turn > 0});
  }
  for (std::size_t i = 0; i < n; ++i) {
    contour.push_back(arcs[i]);
    contour.push_back({arcs[i].to, arcs[(i + 1) % n].from});
  }
  return contour;
}

/// Runs the contour from the middle of its last side, straight in and out along a perpendicular.
Mill millContour(const Contour& contour, double rho, const CutterCompPolicy& policy = {}) {
  const Side& last = contour.back();
  const Vec2 middle = 0.5 * (last.from + last.to);
  const Vec2 along = (last.to - last.from).normalized();
  const Vec2 approach = middle - 3.0 * std::abs(rho) * along + 3.0 * rho * Vec2(-along.y(), along.x());
  Mill run(approach, policy);
  run.side(rho).line(middle.x(), middle.y()).line(last.to.x(), last.to.y());
  for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
    const Side& s = contour[i];
    if (s.arc) {
      run.arc(s.to.x(), s.to.y(), s.center.x(), s.center.y(), s.ccw);
    } else {
      run.line(s.to.x(), s.to.y());
    }
  }
  run.line(middle.x(), middle.y());
  run.off().line(middle.x() + 3.0 * std::abs(rho) * along.x() - 3.0 * rho * along.y(),
                 middle.y() + 3.0 * std::abs(rho) * along.y() + 3.0 * rho * along.x());
  return run;
}

Vec2 pointOnPiece(const CompPiece& p, double t) {
  if (!p.is_arc) return (p.from + t * (p.to - p.from)).head<2>();
  const Vec2 a = p.from.head<2>() - p.center;
  const double r = a.norm() + t * ((p.to.head<2>() - p.center).norm() - a.norm());
  const double angle = std::atan2(a.y(), a.x()) + t * p.sweep_rad;
  return p.center + r * Vec2(std::cos(angle), std::sin(angle));
}

/// The path keeps off the contour by r, and passes every contour point that it can reach at exactly r.
void expectKeepsDistance(const Contour& contour, const Mill& run, double r, bool convex_to_tool) {
  ASSERT_TRUE(run.status.ok());
  ASSERT_TRUE(run.out.notes.empty());
  run.expectContinuous();
  std::vector<Vec2> path;
  for (const CompPiece& p : run.moves()) {
    if (p.tag == 1 || p.tag == run.tag) continue;  // the ways in and out
    for (int i = 0; i <= 40; ++i) {
      path.push_back(pointOnPiece(p, i / 40.0));
      ASSERT_GE(distanceTo(contour, path.back()), r - 1e-6) << "at " << path.back().transpose();
    }
  }
  // Own pieces run at exactly r except where they are prolonged past the end of their element.
  for (const CompPiece& p : run.moves()) {
    if (p.role != CompPiece::Role::kOwn || p.tag == 1 || p.tag == run.tag) continue;
    ASSERT_NEAR(distanceTo(contour, pointOnPiece(p, 0.5)), r, 1e-6);
  }
  if (!convex_to_tool) return;
  for (const Vec2& q : samples(contour, 7)) {
    double nearest = 1e300;
    for (const CompPiece& p : run.moves()) {
      for (int i = 0; i <= 400; ++i) nearest = std::min(nearest, (pointOnPiece(p, i / 400.0) - q).norm());
    }
    ASSERT_LT(nearest, r + 0.05) << "at " << q.transpose();
  }
}

std::vector<Vec2> randomStar(std::mt19937& random, double roughness) {
  std::uniform_int_distribution<int> count(5, 11);
  std::uniform_real_distribution<double> wobble(-1, 1);
  const int n = count(random);
  std::vector<Vec2> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + 0.2 * wobble(random)) / n;
    const double radius = 60 * (1 + roughness * wobble(random));
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

TEST(CompensationProperty, RectanglesOnBothSidesAndInBothDirections) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> size(30, 100), radius(0.5, 9);
  for (int n = 0; n < 60; ++n) {
    const double w = size(random), h = size(random), r = radius(random);
    std::vector<Vec2> corners = {{0, 0}, {w, 0}, {w, h}, {0, h}};
    if (n % 2) std::reverse(corners.begin(), corners.end());
    for (const double rho : {r, -r}) {
      SCOPED_TRACE(testing::Message() << "n " << n << " rho " << rho);
      const bool outside = (rho < 0) == (n % 2 == 0);
      const Contour contour = polygon(corners);
      const Mill run = millContour(contour, rho);
      expectKeepsDistance(contour, run, r, outside);
      // Offset rectangle: closed form for its corners.
      const double d = outside ? -r : r;
      for (const Vec2& c : {Vec2(d, d), Vec2(w - d, d), Vec2(w - d, h - d), Vec2(d, h - d)}) {
        double nearest = 1e300;
        for (const CompPiece& p : run.moves()) nearest = std::min(nearest, (p.to.head<2>() - c).norm());
        EXPECT_LT(nearest, 1e-9);
      }
    }
  }
}

TEST(CompensationProperty, RandomPolygons) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> radius(0.3, 3);
  for (int n = 0; n < 150; ++n) {
    const Contour contour = polygon(randomStar(random, 0.2));
    const double r = radius(random);
    for (const double rho : {r, -r}) {
      SCOPED_TRACE(testing::Message() << "n " << n << " rho " << rho);
      expectKeepsDistance(contour, millContour(contour, rho), r, false);
    }
  }
}

TEST(CompensationProperty, RandomPolygonsWithRoundedCorners) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> radius(0.3, 2.9);
  for (int n = 0; n < 150; ++n) {
    const Contour contour = rounded(randomStar(random, 0.15), 3.0);
    const double r = radius(random);
    for (const double rho : {r, -r}) {
      SCOPED_TRACE(testing::Message() << "n " << n << " rho " << rho);
      expectKeepsDistance(contour, millContour(contour, rho), r, false);
    }
  }
}

TEST(CompensationProperty, RoundOuterCornersStayWithinTheRadius) {
  std::mt19937 random(5);
  CutterCompPolicy policy;
  policy.outer_corner = CompOuterCorner::kArc;
  for (int n = 0; n < 40; ++n) {
    const Contour contour = polygon(randomStar(random, 0.2));
    const Mill run = millContour(contour, -2.0, policy);
    SCOPED_TRACE(testing::Message() << "n " << n);
    expectKeepsDistance(contour, run, 2.0, false);
    for (const CompPiece& p : run.moves()) {
      if (p.tag == 1 || p.tag == run.tag) continue;
      for (int i = 0; i <= 10; ++i) {
        ASSERT_NEAR(distanceTo(contour, pointOnPiece(p, i / 10.0)), 2.0, 1e-6);
      }
    }
  }
}

TEST(CompensationProperty, MirroredProgramsMirrorThePath) {
  std::mt19937 random(3);
  for (int n = 0; n < 50; ++n) {
    const Contour contour = rounded(randomStar(random, 0.15), 3.0);
    Contour mirrored = contour;
    for (Side& s : mirrored) {
      s.from.x() *= -1;
      s.to.x() *= -1;
      s.center.x() *= -1;
      s.ccw = !s.ccw;
    }
    const auto a = millContour(contour, 2.0).moves(), b = millContour(mirrored, -2.0).moves();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR((a[i].to - Vec3(-b[i].to.x(), b[i].to.y(), 0)).norm(), 0, 1e-9);
      EXPECT_NEAR(a[i].sweep_rad, -b[i].sweep_rad, 1e-9);
    }
  }
}

TEST(CompensationProperty, LookAheadDoesNotChangeSoundContours) {
  std::mt19937 random(17);
  for (int n = 0; n < 30; ++n) {
    const Contour contour = rounded(randomStar(random, 0.15), 3.0);
    CutterCompPolicy deep, unchecked;
    deep.extra_look_ahead = 8;
    unchecked.interference_check = false;
    const auto a = millContour(contour, -2.0).moves(), b = millContour(contour, -2.0, deep).moves();
    const auto c = millContour(contour, -2.0, unchecked).moves();
    ASSERT_EQ(a.size(), b.size());
    ASSERT_EQ(a.size(), c.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].to, b[i].to);
      EXPECT_EQ(a[i].to, c[i].to);
    }
  }
}

TEST(CompensationProperty, RandomInputNeverCrashesAndNeverLeavesGaps) {
  std::mt19937 random(99);
  std::uniform_real_distribution<double> coordinate(-20, 20);
  std::uniform_int_distribution<int> choice(0, 11);
  for (int n = 0; n < 3000; ++n) {
    CutterCompPolicy policy;
    policy.extra_look_ahead = n % 9;
    policy.interference_alarm = n % 2;
    policy.interference_check = n % 5 != 0;
    policy.outer_corner = n % 7 == 0 ? CompOuterCorner::kArc : CompOuterCorner::kLines;
    Mill run({coordinate(random), coordinate(random)}, policy);
    for (int step = 0; step < 30 && run.status.ok(); ++step) {
      const double x = coordinate(random), y = coordinate(random);
      switch (choice(random)) {
        case 0:
          run.side(choice(random) - 5.5);
          break;
        case 1:
          run.off().line(x, y);
          break;
        case 2:
          run.none(x);
          break;
        case 3:
          run.arc(x, y, y, x, x > y);
          break;
        case 4:
          run.line(run.comp.programmed().x(), run.comp.programmed().y());
          break;
        case 5:
          run.flush();
          break;
        case 6:
          if (run.comp.active()) run.cornerArc();
          break;
        case 7:
          if (run.comp.active()) run.keep(x, y);
          break;
        default:
          run.line(x, y);
      }
    }
    run.flush();
    run.expectContinuous();
    for (const CompPiece& p : run.out.pieces) {
      ASSERT_TRUE(p.from.allFinite() && p.to.allFinite() && std::isfinite(p.sweep_rad)) << "n " << n;
    }
    EXPECT_TRUE(!run.status.ok() || !run.comp.pending());
  }
}

}  // namespace
}  // namespace proveout
