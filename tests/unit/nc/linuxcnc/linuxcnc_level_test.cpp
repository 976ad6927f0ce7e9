// Levels of G71 and G72 on random contours: nothing below the contour, all of it at last, no cut deeper than
// a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/nc/linuxcnc/cycles/level_cutter.h"

namespace proveout::nc {
namespace {

constexpr double kSlack = 1e-6;

/// Height of the contour over u, the highest of steps.
double heightAt(const PlaneContour& contour, double u) {
  double high = -1e300;
  for (const ContourElement& e : contour) {
    if (u < e.from.x() - 1e-9 || u > e.to.x() + 1e-9) continue;
    double a = 0.0, b = 1.0;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (a + b);
      (pointOn(e, middle).x() < u ? a : b) = middle;
    }
    const bool wall = e.to.x() - e.from.x() < 1e-9;
    high = std::max({high, pointOn(e, a).y(), wall ? e.to.y() : -1e300});
  }
  return high;
}

bool isOn(const PlaneContour& contour, const Vec2& p) {
  return std::any_of(contour.begin(), contour.end(),
                     [&](const ContourElement& e) { return distanceFrom(e, p) < 1e-5; });
}

PlaneContour randomContour(std::mt19937& random, double& top) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  PlaneContour out;
  Vec2 at(0, between(0.0, 4.0));
  top = at.y();
  for (int k = 0; k < 8; ++k) {
    const double du = between(0.0, 1.0) < 0.25 ? 0.0 : between(0.5, 5.0), dv = between(-4.0, 4.5);
    const Vec2 to(at.x() + du, std::max(0.0, at.y() + dv));
    if ((to - at).norm() < 0.1) continue;
    const double rise = to.y() - at.y();
    if (du > 0.0 && std::abs(rise) > 0.2 && k % 2 == 0) {
      // A quarter of a circle, above its centre or below it.
      const bool bump = between(0.0, 1.0) < 0.5;
      const Vec2 end(at.x() + std::abs(rise), to.y());
      const Vec2 center = bump == (rise > 0.0) ? Vec2(end.x(), at.y()) : Vec2(at.x(), end.y());
      out.push_back(arcElement(center, at, end, bump ? -0.5 * kPi : 0.5 * kPi));
    } else {
      out.push_back(lineElement(at, to));
    }
    at = out.back().to;
    top = std::max(top, at.y());
  }
  top += between(0.2, 3.0);
  out.insert(out.begin(), lineElement({-1.0, top}, {0.0, out.front().from.y()}));
  out.push_back(lineElement(at, {at.x(), top}));
  return out;
}

/// The stock over places of u, which moves cut.
class Stock {
 public:
  Stock(double end, double top) : end_(end), heights_(kPlaces, top) {}
  /// The deepest that a feed move cut at a place.
  double cut(const LevelMove& m) {
    double deepest = 0.0;
    for (std::size_t k = 0; k < kPlaces; ++k) {
      const double u = end_ * (static_cast<double>(k) + 0.5) / kPlaces;
      const PlaneContour one = {m.element};
      const double low = std::min(m.element.from.x(), m.element.to.x()),
                   high = std::max(m.element.from.x(), m.element.to.x());
      if (u < low || u > high) continue;
      const double v = m.element.from.x() < m.element.to.x() ? heightAt(one, u)
                                                             : std::min(m.element.from.y(), m.element.to.y());
      deepest = std::max(deepest, heights_[k] - v);
      heights_[k] = std::min(heights_[k], v);
    }
    return deepest;
  }

 private:
  static constexpr std::size_t kPlaces = 60;
  double end_;
  std::vector<double> heights_;
};

// lcn-4-G71 lcn-4-G72
TEST(LinuxCncLevels, StayAboveTheContourAndCutAllOfIt) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    double top = 0.0;
    const PlaneContour contour = randomContour(random, top);
    const LevelRules rules{.step = 0.7, .retract = 0.3, .pockets = Pockets::kAll};
    const std::vector<LevelMove> moves = cutLevels(contour, rules);
    ASSERT_FALSE(moves.empty());
    Stock stock(contour.back().to.x(), top + rules.step);
    for (const LevelMove& m : moves) {
      for (int k = 0; k <= 8; ++k) {
        const Vec2 p = pointOn(m.element, k / 8.0);
        if (p.x() < 0.0) continue;
        double low = 1e300;  // at steps any height of the wall is on the contour
        for (const double u : {p.x() - 1e-7, p.x(), p.x() + 1e-7})
          low = std::min(low, heightAt(contour, std::clamp(u, 1e-9, contour.back().to.x() - 1e-9)));
        ASSERT_TRUE(p.y() > low - kSlack || isOn(contour, p)) << round << ": " << p.transpose();
      }
      if (m.rapid) continue;
      EXPECT_LT(stock.cut(m), rules.step + 1e-3) << round;
    }
    for (std::size_t k = 1; k < contour.size(); ++k) {
      for (int i = 0; i <= 6; ++i) {
        const Vec2 p = pointOn(contour[k], i / 6.0);
        const bool covered = std::any_of(moves.begin(), moves.end(), [&](const LevelMove& m) {
          return !m.rapid && distanceFrom(m.element, p) < 1e-5;
        });
        EXPECT_TRUE(covered) << round << ": " << p.transpose();
      }
    }
  }
}

// lcn-4-G71: what .1 leaves and what .2 cuts is all of it.
TEST(LinuxCncLevels, LeavePocketsAndCutThemAlone) {
  std::mt19937 random(5);
  int pockets = 0;
  for (int round = 0; round < 200; ++round) {
    double top = 0.0;
    const PlaneContour contour = randomContour(random, top);
    LevelRules rules{.step = 0.9, .retract = 0.3, .pockets = Pockets::kNone};
    const auto left = cutLevels(contour, rules);
    rules.pockets = Pockets::kOnly;
    const auto rest = cutLevels(contour, rules);
    rules.pockets = Pockets::kAll;
    const auto all = cutLevels(contour, rules);
    pockets += left.size() < all.size() ? 1 : 0;
    for (std::size_t k = 1; k < contour.size(); ++k) {
      const Vec2 p = pointOn(contour[k], 0.5);
      const auto on = [&](const LevelMove& m) { return distanceFrom(m.element, p) < 1e-5; };
      EXPECT_TRUE(std::any_of(left.begin(), left.end(), on) || std::any_of(rest.begin(), rest.end(), on))
          << round;
    }
  }
  EXPECT_GT(pockets, 50);
}

}  // namespace
}  // namespace proveout::nc
