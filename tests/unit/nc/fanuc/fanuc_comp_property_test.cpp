// Cutter compensation of Fanuc-like mills against a slow reference of its own: offsets of lines and arcs and
// the corners between them by the rules of iso-fanuc, section 8, in double precision.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace fanuc_comp_property_test {
namespace {

constexpr double kPiRef = 3.14159265358979323846;

Vec2 left(const Vec2& d) { return {-d.y(), d.x()}; }
double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
double wrap(double angle) { return std::remainder(angle, 2.0 * kPiRef); }
double angleOf(const Vec2& d) { return std::atan2(d.y(), d.x()); }

/// A programmed line or arc.
struct Element {
  bool arc = false;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero(), centre = Vec2::Zero();
  double radius = 0.0;  ///< as programmed by R
  int turn = 0;         ///< of an arc: +1 counter-clockwise, -1 clockwise

  Vec2 direction(const Vec2& at) const {
    if (!arc) return (to - from).normalized();
    return turn * left((at - centre).normalized());
  }
  double sweep() const {
    double a = turn * (angleOf(to - centre) - angleOf(from - centre));
    while (a <= 0.0) a += 2.0 * kPiRef;
    while (a > 2.0 * kPiRef) a -= 2.0 * kPiRef;
    return a;
  }
};

/// The centre by the R form of section 3: middle + s h n, s = -1 for G2, +1 for G3 with R > 0.
Element arcTo(const Vec2& from, const Vec2& to, double radius, int turn) {
  const Vec2 chord = to - from;
  const double h = std::sqrt(std::max(0.0, radius * radius - 0.25 * chord.squaredNorm()));
  return {true, from, to, Vec2(0.5 * (from + to) + turn * h * left(chord.normalized())), radius, turn};
}

/// A piece of the expected path.
struct Piece {
  Vec2 to = Vec2::Zero();
  std::optional<Vec2> centre;
  double sweep = 0.0;
};

struct Expected {
  std::vector<Piece> path;
  bool interference = false;     ///< 041
  bool no_intersection = false;  ///< 033
  bool close = false;            ///< too near to a limit to say
};

/// Points where the offset curves of two elements meet.
std::vector<Vec2> meetings(const Element& a, const Element& b, double rho) {
  const auto lineOf = [&](const Element& e, Vec2& p, Vec2& d) {
    d = e.direction(e.from);
    p = e.from + rho * left(d);
  };
  const auto circle = [&](const Element& e) { return (e.to - e.centre).norm() - e.turn * rho; };
  Vec2 p, d, q, f;
  if (!a.arc && !b.arc) {
    lineOf(a, p, d);
    lineOf(b, q, f);
    const double k = cross(d, f);
    if (std::abs(k) < 1e-12) return {};
    return {p + d * (cross(q - p, f) / k)};
  }
  if (a.arc && b.arc) {
    const double r1 = circle(a), r2 = circle(b), gap = (b.centre - a.centre).norm();
    const double x = (gap * gap + r1 * r1 - r2 * r2) / (2.0 * gap), y2 = r1 * r1 - x * x;
    if (y2 < 0.0) return {};
    const Vec2 u = (b.centre - a.centre) / gap;
    return {a.centre + x * u + std::sqrt(y2) * left(u), a.centre + x * u - std::sqrt(y2) * left(u)};
  }
  const Element &line = a.arc ? b : a, &round = a.arc ? a : b;
  lineOf(line, p, d);
  const double along = (round.centre - p).dot(d), across = cross(d, round.centre - p), r = circle(round);
  const double half2 = r * r - across * across;
  if (half2 < 0.0) return {};
  return {p + d * (along + std::sqrt(half2)), p + d * (along - std::sqrt(half2))};
}

class Reference {
 public:
  Reference(const std::vector<Element>& contour, const Vec2& out, double rho)
      : contour_(contour), out_(out), rho_(rho) {}

  Expected run() {
    const Element& first = contour_[1];
    add({contour_[0].to + rho_ * left(first.direction(first.from)), {}, 0.0});
    for (std::size_t k = 1; k < contour_.size(); ++k) element(k);
    add({out_, {}, 0.0});
    return result_;
  }

 private:
  void add(const Piece& piece) {
    if ((piece.to - at_).norm() < 1e-6 && !result_.path.empty()) return;
    result_.path.push_back(piece);
    at_ = piece.to;
  }

  void element(std::size_t k) {
    const Element& e = contour_[k];
    std::vector<Vec2> corner;
    if (k + 1 == contour_.size()) {
      corner = {e.to + rho_ * left(e.direction(e.to))};  // square to the last block
    } else {
      corner = cornerTo(e, contour_[k + 1]);
      if (corner.empty()) {
        result_.no_intersection = true;
        corner = {e.to + rho_ * left(e.direction(e.to))};
      }
    }
    own(e, corner.front());
    for (std::size_t i = 1; i < corner.size(); ++i) add({corner[i], {}, 0.0});
  }

  std::vector<Vec2> cornerTo(const Element& a, const Element& b) {
    const Vec2 p = a.to, u1 = a.direction(p), u2 = b.direction(p);
    const Vec2 n1 = left(u1), n2 = left(u2);
    const double turn = std::atan2(cross(u1, u2), u1.dot(u2)), side = rho_ > 0.0 ? 1.0 : -1.0;
    const double deflection = std::abs(turn), r = std::abs(rho_);
    constexpr double kNear = 0.3 * kPiRef / 180.0;
    result_.close = result_.close || deflection < 2.0 * kNear ||
                    std::abs(deflection - 0.5 * kPiRef) < kNear || deflection > kPiRef - kNear;
    if (turn * side > 0.0) {  // towards the tool
      const std::vector<Vec2> all = meetings(a, b, rho_);
      if (all.empty()) return {};
      if (all.size() == 1) return all;
      const double d0 = (all[0] - p).norm(), d1 = (all[1] - p).norm();
      result_.close = result_.close || std::abs(d0 - d1) < 1e-2;
      return {d0 < d1 ? all[0] : all[1]};
    }
    std::vector<Vec2> points;
    if (a.arc) points.push_back(p + rho_ * n1);
    if (deflection <= 0.5 * kPiRef) {
      points.push_back(p + rho_ * n1 + r * std::tan(0.5 * deflection) * u1);
    } else {
      points.push_back(p + rho_ * n1 + r * u1);
      points.push_back(p + rho_ * n2 - r * u2);
    }
    if (b.arc) points.push_back(p + rho_ * n2);
    return points;
  }

  void own(const Element& e, const Vec2& end) {
    if (!e.arc) {
      const double forward = (end - at_).dot(e.direction(e.from));
      result_.interference = result_.interference || forward < 0.0;
      result_.close = result_.close || std::abs(forward) < 0.02;
      return add({end, {}, 0.0});
    }
    const double radius = (e.to - e.centre).norm() - e.turn * rho_;
    result_.close = result_.close || std::abs(radius) < 0.02;
    if (radius <= 0.0) {
      result_.interference = true;
      return add({end, {}, 0.0});
    }
    const double sweep = e.sweep() + e.turn * (wrap(angleOf(end - e.centre) - angleOf(e.to - e.centre)) -
                                               wrap(angleOf(at_ - e.centre) - angleOf(e.from - e.centre)));
    result_.interference = result_.interference || sweep < 0.0;
    result_.close = result_.close || std::abs(sweep * radius) < 0.02;
    add({end, e.centre, e.turn * sweep});
  }

  const std::vector<Element>& contour_;
  Vec2 out_;
  double rho_;
  Vec2 at_ = Vec2::Zero();
  Expected result_;
};

/// Numbers that are the same with every library.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
  bool once(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937 engine_;
};

double rounded(double x) { return std::round(x * 1000.0) / 1000.0; }
Vec2 rounded(const Vec2& p) { return {rounded(p.x()), rounded(p.y())}; }

struct Contour {
  std::vector<Element> elements;  ///< the first is the way in
  Vec2 out = Vec2::Zero();
  double radius = 0.0;
  bool on_left = false;

  std::string program() const {
    const auto words = [](const Vec2& p) { return fmt::format(" X{:.3f} Y{:.3f}", p.x(), p.y()); };
    std::string text = fmt::format("O1\nG21 G90 G17 F100\nG10 L12 P1 R{:.3f}\nG0{}\n{} D1", radius,
                                   words(elements[0].from), on_left ? "G41" : "G42");
    for (const Element& e : elements) {
      text += e.arc ? fmt::format("G{}{} R{:.3f}\n", e.turn > 0 ? 3 : 2, words(e.to), e.radius)
                    : fmt::format("G1{}\n", words(e.to));
    }
    return text + fmt::format("G40 G1{}\nM30\n", words(out));
  }
};

/// A contour of 2 to 7 elements with corners of any deflection; `smooth`: gentle ones, so that most fit.
Contour randomContour(unsigned seed) {
  Random random(seed);
  const bool smooth = random.once(0.7);
  Contour all;
  all.radius = rounded(random.between(0.5, smooth ? 4.0 : 9.0));
  all.on_left = random.once(0.5);
  const Vec2 start = rounded(Vec2(random.between(-50, 50), random.between(-50, 50)));
  double heading = random.between(-kPiRef, kPiRef);
  Vec2 at = rounded(Vec2(start + 30.0 * Vec2(std::cos(heading), std::sin(heading))));
  all.elements.push_back({false, start, at, Vec2::Zero(), 0.0, 0});
  const int count = 2 + static_cast<int>(random.between(0.0, 6.0));
  for (int k = 0; k < count; ++k) {
    heading += random.between(-1.0, 1.0) * (smooth ? 1.9 : 2.9);
    if (random.once(0.5)) {
      const double length = random.between(smooth ? 25.0 : 6.0, 60.0);
      const Vec2 to = rounded(Vec2(at + length * Vec2(std::cos(heading), std::sin(heading))));
      all.elements.push_back({false, at, to, Vec2::Zero(), 0.0, 0});
    } else {
      const int turn = random.once(0.5) ? 1 : -1;
      const double radius = rounded(random.between(smooth ? 15.0 : 3.0, 45.0));
      const double sweep = random.between(0.5, 2.6), middle = heading + turn * 0.5 * sweep;
      const double chord = 2.0 * radius * std::sin(0.5 * sweep);
      const Vec2 to = rounded(Vec2(at + chord * Vec2(std::cos(middle), std::sin(middle))));
      all.elements.push_back(arcTo(at, to, radius, turn));
      heading += turn * sweep;
    }
    at = all.elements.back().to;
  }
  all.out = rounded(Vec2(at + 25.0 * Vec2(std::cos(heading + 0.7), std::sin(heading + 0.7))));
  return all;
}

testing::AssertionResult samePath(const Expected& expected, const IsoRun& run) {
  std::vector<const Motion*> got;
  for (const Motion& m : run.path.motions) got.push_back(&m);
  if (got.size() != expected.path.size() + 1)  // the rapid to the start
    return testing::AssertionFailure()
           << got.size() - 1 << " motions, " << expected.path.size() << " expected";
  for (std::size_t k = 0; k < expected.path.size(); ++k) {
    const Motion& m = *got[k + 1];
    const Piece& piece = expected.path[k];
    if ((m.to.head<2>() - piece.to).norm() > 1e-4)
      return testing::AssertionFailure() << "motion " << k << " ends at " << IsoRun::shown(m.to)
                                         << ", expected " << piece.to.x() << " " << piece.to.y();
    if ((m.arc >= 0) != piece.centre.has_value())
      return testing::AssertionFailure() << "motion " << k << " is of the other kind";
    if (!piece.centre) continue;
    const ArcGeometry& arc = run.path.arcs[static_cast<std::size_t>(m.arc)];
    if ((arc.center.head<2>() - *piece.centre).norm() > 1e-4 || std::abs(arc.sweep_rad - piece.sweep) > 1e-5)
      return testing::AssertionFailure() << "arc of motion " << k;
  }
  return testing::AssertionSuccess();
}

/// Seeds 1 to 1200: how many fit, are refused, or are too near to a limit, is part of the test.
TEST(FanucCompProperty, FollowsTheRulesOnRandomContours) {
  int fits = 0, refused = 0, close = 0, left_side = 0, arcs = 0;
  for (unsigned seed = 1; seed <= 1200; ++seed) {
    const Contour contour = randomContour(seed);
    const double rho = contour.on_left ? contour.radius : -contour.radius;
    const Expected expected = Reference(contour.elements, contour.out, rho).run();
    if (expected.close) {
      ++close;
      continue;
    }
    const IsoRun run(ControlId::kFanucMill, contour.program(), runAtZero({{"rapid", 1}}));
    if (expected.interference || expected.no_intersection) {
      ++refused;
      const std::string error = run.error();
      const bool named = (expected.interference && error == "fanuc-041") ||
                         (expected.no_intersection && error == "fanuc-033");
      EXPECT_TRUE(named) << "seed " << seed << ": " << error << "\n" << contour.program();
      continue;
    }
    ++fits;
    left_side += contour.on_left ? 1 : 0;
    for (const Element& e : contour.elements) arcs += e.arc ? 1 : 0;
    EXPECT_EQ(run.error(), "") << "seed " << seed << ": " << run.message() << "\n" << contour.program();
    EXPECT_TRUE(samePath(expected, run)) << "seed " << seed << "\n" << contour.program();
  }
  EXPECT_EQ(fits, 1072);
  EXPECT_EQ(refused, 91);
  EXPECT_EQ(close, 37);
  EXPECT_GT(left_side, fits / 3);
  EXPECT_GT(arcs, fits);
}

}  // namespace
}  // namespace fanuc_comp_property_test
}  // namespace proveout::test
