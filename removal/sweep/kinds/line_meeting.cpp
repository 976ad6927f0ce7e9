#include "removal/sweep/kinds/line_meeting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// By how much a point may be beyond the end of its face, mm: rounding must not take it from both of the
/// faces that meet there.
constexpr double kBeyondMm = 1e-9;
/// Newton's method stops this near to a face, mm.
constexpr double kThereMm = 1e-12;

bool within(double value, double a, double b) {
  return value >= std::min(a, b) - kBeyondMm && value <= std::max(a, b) + kBeyondMm;
}

/// A disc that goes along a line, and all within a radius of that.
class RoundedDisc {
 public:
  RoundedDisc(const ConvexProfile::Element& corner, const SpaceLine& line, const Vec3& way)
      : e_(corner), line_(line), way_(way) {}

  /// From `start`, outside of the volume, in the direction of `sign` (+1, -1) to where it begins; NaN: it
  /// does not, or not with the corner's own face.
  double begin(double start, double sign) {
    double t = start;
    for (int round = 0; round < kMostRounds; ++round) {
      place(line_.at(t));
      const double off = distance_ - e_.radius;
      if (off <= kThereMm) return isOnFace() ? t : kNone;
      const double slope = -sign * away_.dot(line_.along);
      if (!(slope > 0.0)) return kNone;
      const double next = t + sign * off / slope;
      if (next == t) return isOnFace() ? t : kNone;
      t = next;
    }
    return kNone;
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// Half the derivative of the distance's square by the place s of the disc, and the bend of that.
  struct Slope {
    double value, bend;
  };
  Slope slopeAt(const Vec3& p, double s) const {
    const Vec3 q = p - s * way_;
    const double level = q.head<2>().norm(), up = q.z() - e_.cz, out = level - e_.cr;
    Slope slope{-up * way_.z(), way_.z() * way_.z()};
    if (out <= 0.0) return slope;
    const double along = q.head<2>().dot(way_.head<2>()) / level;
    slope.value -= out * along;
    slope.bend += along * along + out / level * (way_.head<2>().squaredNorm() - along * along);
    return slope;
  }
  /// Finds the place of the disc that is nearest to `p` by Newton's method on the slope of a convex function,
  /// between places of different sign.
  void place(const Vec3& p) {
    double low = 0.0, high = 1.0, s = s_;
    for (int round = 0; round < kMostRounds; ++round) {
      const Slope slope = slopeAt(p, s);
      if (slope.value == 0.0) break;
      (slope.value < 0.0 ? low : high) = s;
      double next = slope.bend > 0.0 ? s - slope.value / slope.bend : slope.value < 0.0 ? 1.0 : 0.0;
      next = std::clamp(next, low, high);
      if (next == s || std::abs(next - s) * way_.cwiseAbs().maxCoeff() < kPlaceMm) {
        s = next;
        break;
      }
      // An end of the bracket that is known already is no news.
      if ((next == low || next == high) && round > 0 && next > 0.0 && next < 1.0) next = 0.5 * (low + high);
      if (round > kMostSteps) next = 0.5 * (low + high);
      s = next;
    }
    s_ = s;
    const Vec3 q = p - s * way_;
    const double level = q.head<2>().norm(), out = std::max(0.0, level - e_.cr);
    away_ = Vec3(0.0, 0.0, q.z() - e_.cz);
    if (out > 0.0) away_.head<2>() = out / level * q.head<2>();
    distance_ = away_.norm();
    if (distance_ > 0.0) away_ /= distance_;
  }
  /// Whether the nearest point is one of the arc, not of the rest of the ring around it.
  bool isOnFace() const {
    const double r = e_.radius * away_.head<2>().norm(), z = e_.radius * away_.z();
    const double ar = e_.ar - e_.cr, az = e_.az - e_.cz, br = e_.br - e_.cr, bz = e_.bz - e_.cz;
    const double slack = kBeyondMm * e_.radius;
    return ar * z - az * r >= -slack && r * bz - z * br >= -slack;
  }

  static constexpr double kPlaceMm = 1e-13;
  static constexpr int kMostSteps = 40, kMostRounds = 100;
  const ConvexProfile::Element& e_;
  const SpaceLine& line_;
  const Vec3& way_;
  double s_ = 0.5, distance_ = 0.0;
  Vec3 away_ = Vec3::Zero();
};

}  // namespace

QuadraticRoots quadraticRoots(double a, double b, double c) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const double root2 = b * b - a * c;
  if (!(root2 >= 0.0)) return {kNone, kNone};
  const double q = -(b + std::copysign(std::sqrt(root2), b));
  const double first = q / a, second = q != 0.0 ? c / q : 0.0;
  return {std::fmin(first, second), std::fmax(first, second)};
}

void LineMeeting::meet(const ConvexProfile& profile) {
  for (int i = 0; i < profile.elementCount(); ++i) {
    const Element& e = profile.element(i);
    if (e.br > 0.0) meetDisc(e.br, e.bz);
    if (!e.arc) {
      if (e.dz != 0.0) meetStraight(e);
    } else if (e.cr == 0.0) {
      meetBall(e);
    } else {
      meetCorner(e);
    }
  }
}

void LineMeeting::meetCylinder(double radius, double low, double high) {
  meetDisc(radius, low);
  meetDisc(radius, high);
  Element flank;
  flank.ar = flank.br = radius;
  flank.az = low, flank.bz = high;
  flank.dr = 0.0, flank.dz = 1.0;
  meetStraight(flank);
}

/// A level disc: places s of the way and t of the line at which the line is at its height lie on a line, too,
/// on which the level distance from its middle is a quadratic.
void LineMeeting::meetDisc(double radius, double height) {
  const double kz = line_.along.z(), dz = way_.z(), norm2 = kz * kz + dz * dz;
  if (!(norm2 > 0.0)) return;  // its rim leaves what the faces beside it do
  const double up = (height - line_.from.z()) / norm2, t0 = up * kz, s0 = -up * dz;
  const Vec2 at = line_.from.head<2>() + t0 * line_.along.head<2>() - s0 * way_.head<2>();
  const Vec2 step = dz * line_.along.head<2>() - kz * way_.head<2>();  // as t grows by dz, and s by kz
  const double step2 = step.squaredNorm(), beyond = at.squaredNorm() - radius * radius;
  auto [low, high] = quadraticRoots(step2, at.dot(step), beyond);
  if (step2 == 0.0) {
    if (beyond > 0.0) return;
    low = -std::numeric_limits<double>::infinity(), high = -low;
  }
  if (kz == 0.0) {
    if (!(s0 >= 0.0 && s0 <= 1.0)) return;
  } else {
    const double first = -s0 / kz, last = (1.0 - s0) / kz;
    low = std::max(low, std::min(first, last));
    high = std::min(high, std::max(first, last));
  }
  if (!(low <= high)) return;
  take(t0 + low * dz);
  take(t0 + high * dz);
}

void LineMeeting::meetStraight(const Element& e) {
  meetStanding(e, 0.0);
  meetStanding(e, 1.0);
  meetPlanes(e);
}

/// The cylinder or cone at the place s.
void LineMeeting::meetStanding(const Element& e, double s) {
  const Vec3 q = line_.from - s * way_;
  const Vec2 level = q.head<2>(), along = line_.along.head<2>();
  // radius * dz = g + dr * t
  const double g = e.ar * e.dz + (q.z() - e.az) * e.dr, grows = e.dr * line_.along.z();
  const double dz2 = e.dz * e.dz;
  const auto [low, high] =
      quadraticRoots(dz2 * along.squaredNorm() - grows * grows, dz2 * level.dot(along) - g * grows,
                     dz2 * level.squaredNorm() - g * g);
  for (const double t : {low, high}) {
    if (!std::isfinite(t)) continue;
    const Vec3 p = q + t * line_.along;
    // The other half of the double cone is at other heights.
    if (within(p.z(), e.az, e.bz) && within(p.head<2>().norm(), e.ar, e.br)) take(t);
  }
}

/// The planes that a cylinder or cone leaves beside its way.
void LineMeeting::meetPlanes(const Element& e) {
  const double level = way_.head<2>().norm();
  if (!(level > 0.0)) return;
  const Vec2 ahead = way_.head<2>() / level, aside(-ahead.y(), ahead.x());
  const double c = e.dr * way_.z() / (e.dz * level);
  if (!(std::abs(c) < 1.0)) return;
  for (const double side : {-1.0, 1.0}) {
    const double d = side * std::sqrt((1.0 - c) * (1.0 + c));
    const Vec2 out = c * ahead + d * aside, across(-out.y(), out.x());
    const Vec3 normal(e.dz * out.x(), e.dz * out.y(), -e.dr);
    const double toward = normal.dot(line_.along);
    if (toward == 0.0) continue;
    const double t = (e.dz * e.ar - e.dr * e.az - normal.dot(line_.from)) / toward;
    const Vec3 p = line_.at(t);
    const double speed = across.dot(way_.head<2>());
    const double s = across.dot(p.head<2>()) / speed;
    if (!(s >= 0.0 && s <= 1.0)) continue;
    if (within(p.z() - s * way_.z(), e.az, e.bz) &&
        within(out.dot(p.head<2>() - s * way_.head<2>()), e.ar, e.br))
      take(t);
  }
}

QuadraticRoots LineMeeting::capsule(double height, double radius) const {
  const Vec3 q = line_.from - Vec3(0.0, 0.0, height);
  QuadraticRoots span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto add = [&](double t) {
    span.low = std::fmin(span.low, t);
    span.high = std::fmax(span.high, t);
  };
  for (const double s : {0.0, 1.0}) {
    const Vec3 from = q - s * way_;
    const auto [low, high] = quadraticRoots(1.0, from.dot(line_.along), from.squaredNorm() - radius * radius);
    if (low <= high) add(low), add(high);
  }
  const double length2 = way_.squaredNorm();
  if (length2 > 0.0) {
    const double step = line_.along.dot(way_) / length2, first = q.dot(way_) / length2;
    const Vec3 aside = q - first * way_, turn = line_.along - step * way_;
    const auto [low, high] =
        quadraticRoots(turn.squaredNorm(), aside.dot(turn), aside.squaredNorm() - radius * radius);
    for (const double t : {low, high}) {
      const double s = first + t * step;
      if (s >= 0.0 && s <= 1.0) add(t);
    }
  }
  return span;
}

/// A part of a sphere.
void LineMeeting::meetBall(const Element& e) {
  const Vec3 q = line_.from - Vec3(0.0, 0.0, e.cz);
  const double radius2 = e.radius * e.radius;
  for (const double s : {0.0, 1.0}) {
    const Vec3 from = q - s * way_;
    const auto [low, high] = quadraticRoots(1.0, from.dot(line_.along), from.squaredNorm() - radius2);
    for (const double t : {low, high}) {
      if (within(e.cz + from.z() + t * line_.along.z(), e.az, e.bz)) take(t);
    }
  }
  const double length2 = way_.squaredNorm();
  if (!(length2 > 0.0)) return;
  const double step = line_.along.dot(way_) / length2, first = q.dot(way_) / length2;
  const Vec3 aside = q - first * way_, turn = line_.along - step * way_;
  const auto [low, high] = quadraticRoots(turn.squaredNorm(), aside.dot(turn), aside.squaredNorm() - radius2);
  for (const double t : {low, high}) {
    const double s = first + t * step;
    if (s >= 0.0 && s <= 1.0 && within(e.cz + aside.z() + t * turn.z(), e.az, e.bz)) take(t);
  }
}

void LineMeeting::meetCorner(const Element& e) {
  const auto [low, high] = capsule(e.cz, e.cr + e.radius);
  if (!(low <= high)) return;
  RoundedDisc disc(e, line_, way_);
  if (const double t = disc.begin(low, 1.0); std::isfinite(t)) take(t);
  if (const double t = disc.begin(high, -1.0); std::isfinite(t)) take(t);
}

}  // namespace proveout
