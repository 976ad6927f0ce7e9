#include "core/nc/services/cutter_comp_roll.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout::comp_detail {
namespace {

constexpr double kTouching = 1e-7;      ///< mm; a disk that overlaps by less touches
constexpr double kChordError = 0.0002;  ///< mm, of the chords that stand for turns about a point

double turnOf(const Element& e) { return e.sweep >= 0.0 ? 1.0 : -1.0; }

/// Angle from `a` to `b` in (-pi, pi].
double angleBetween(const Vec2& a, const Vec2& b) { return std::atan2(cross2(a, b), a.dot(b)); }

/// Whether the ray from an arc's centre towards `d` meets the arc.
bool onArc(const Element& arc, const Vec2& d) {
  if (std::abs(arc.sweep) >= 2.0 * kPi) return true;
  double angle = turnOf(arc) * angleBetween(planar(arc.p0) - arc.center, d);
  if (angle < 0.0) angle += 2.0 * kPi;
  return angle <= std::abs(arc.sweep);
}

double radiusOf(const Element& arc) { return (planar(arc.p0) - arc.center).norm(); }

}  // namespace

/// The curve on which the disk's centre moves.
struct Roll::Mover {
  PlaneCurve curve;
  Vec2 from = Vec2::Zero();
  double turn = 0.0;  ///< circles: > 0 counter-clockwise

  /// Length of way from the start to a point of the curve; below 0 behind the start.
  double travel(const Vec2& to) const {
    if (!curve.circle) return (to - from).dot(curve.direction);
    return turn * angleBetween(from - curve.point, to - curve.point) * curve.radius;
  }
  Vec2 direction(const Vec2& at) const {
    return curve.circle ? Vec2(turn * leftOf(at - curve.point).normalized()) : curve.direction;
  }
};

Roll::Mover Roll::mover(const RollPlace& at) const {
  const Element& e = elements_[at.index];
  const double r = std::abs(rho_);
  // On the left of the path the disk goes clockwise about a point, on the right counter-clockwise.
  if (at.pivot) return {{true, planar(e.p0), Vec2::UnitX(), r}, at.center, rho_ > 0.0 ? -1.0 : 1.0};
  if (e.kind == ElementKind::kArc) {
    return {{true, e.center, Vec2::UnitX(), (at.center - e.center).norm()}, at.center, turnOf(e)};
  }
  return {{false, at.center, startTangent(e), 0.0}, at.center, 0.0};
}

/// False for arcs inside that are smaller than the disk: only their ends can touch it.
bool Roll::solid(const Element& e) const {
  return e.kind == ElementKind::kLine || radiusOf(e) - turnOf(e) * rho_ > 0.0;
}

Vec2 Roll::nearest(const Element& e, const Vec2& p) const {
  const Vec2 a = planar(e.p0), b = planar(e.p1);
  if (e.kind == ElementKind::kLine) return nearestOnSegment(p, a, b);
  const Vec2 d = p - e.center;
  if (d.norm() > kTinyLength && onArc(e, d)) return e.center + radiusOf(e) * d.normalized();
  return (p - a).squaredNorm() < (p - b).squaredNorm() ? a : b;
}

double Roll::depth(const Vec2& center, std::size_t first) const {
  double depth = 0.0;
  for (std::size_t i = first; i <= last_; ++i) {
    depth = std::max(depth, std::abs(rho_) - (nearest(elements_[i], center) - center).norm());
  }
  return depth;
}

/// The element ahead into which the disk cuts deepest where it stands; the disk is pushed off it. Index 0:
/// none.
RollPlace Roll::touching(const RollPlace& at) const {
  RollPlace found;
  double deepest = kTouching;
  for (std::size_t i = at.index + 1; i <= last_; ++i) {
    const Element& e = elements_[i];
    const Vec2 point = nearest(e, at.center), away = at.center - point;
    const double depth = std::abs(rho_) - away.norm();
    if (depth <= deepest || away.norm() < kTinyLength) continue;
    deepest = depth;
    const bool at_end = (point - planar(e.p1)).norm() < kTinyLength;
    const bool at_start = (point - planar(e.p0)).norm() < kTinyLength;
    found = {point + std::abs(rho_) * away.normalized(), at_end ? i + 1 : i, at_end || at_start};
  }
  return found;
}

/// Where the disk on its way would be stopped by element `index`, if that is nearer than `least`.
void Roll::consider(const Mover& mover, std::size_t index, double& least, RollPlace& found) const {
  const Element& e = elements_[index];
  const auto candidates = [&](const PlaneCurve& obstacle, bool point) {
    const Meeting meeting = meet(mover.curve, obstacle);
    for (std::size_t m = 0; m < meeting.count; ++m) {
      const Vec2& x = meeting.points[m];
      const double travel = mover.travel(x);
      if (travel < -kTouching || travel >= least) continue;
      const Vec2 q = point ? obstacle.point : nearest(e, x);
      const bool touches = std::abs((q - x).norm() - std::abs(rho_)) < kTouching;
      if (!touches || mover.direction(x).dot(q - x) <= 0.0) continue;
      least = travel;
      found = {x, point ? index + 1 : index, point};
    }
  };
  candidates({true, planar(e.p1), Vec2::UnitX(), std::abs(rho_)}, true);
  if (e.kind == ElementKind::kLine) {
    const Vec2 t = startTangent(e);
    candidates({false, planar(e.p0) + rho_ * leftOf(t), t, 0.0}, false);
  } else if (solid(e)) {
    candidates({true, e.center, Vec2::UnitX(), radiusOf(e) - turnOf(e) * rho_}, false);
  }
}

RollPlace Roll::next(const RollPlace& at) const {
  if (at.index > last_) return at;
  if (const RollPlace stop = touching(at); stop.index > 0) return stop;
  const Element& own = elements_[at.index];
  const Mover way = mover(at);
  // Where its own element ends this way: turned flat onto it, or at the end point.
  const bool turns = at.pivot;
  const Vec2 tangent = turns ? startTangent(own) : endTangent(own);
  const Vec2 limit = planar(turns ? own.p0 : own.p1) + rho_ * leftOf(tangent);
  RollPlace found{limit, turns ? at.index : at.index + 1, !turns};
  double least = way.travel(limit);
  if (own.kind == ElementKind::kArc && !turns && least < 0.0 && std::abs(own.sweep) > kPi) {
    least += 2.0 * kPi * way.curve.radius;
  }
  if (least <= 0.0) {
    least = 0.0;
    found.center = at.center;
  }
  const std::size_t first = turns ? at.index : at.index + 1;
  for (std::size_t i = first; i <= last_; ++i) consider(way, i, least, found);
  return found;
}

double Roll::unreached(const RollPlace& from, const RollPlace& to) const {
  // The end of the element before a corner is not reached where the corner is sharp: that is no interference.
  if (to.index <= from.index + (from.pivot ? 0 : 1) && !to.pivot) return 0.0;
  const std::size_t end = to.pivot ? to.index - 1 : to.index;  // the element whose point stops the disk
  double farthest = 0.0;
  for (std::size_t i = from.index; i < end; ++i) {
    farthest = std::max(farthest, (planar(elements_[i].p1) - to.center).norm());
  }
  for (std::size_t i = from.pivot ? from.index : from.index + 1; i < to.index; ++i) {
    const Element& e = elements_[i];
    if (e.kind != ElementKind::kArc) continue;
    const Vec2 d = e.center - to.center;
    if (d.norm() > kTinyLength && onArc(e, d)) farthest = std::max(farthest, d.norm() + radiusOf(e));
  }
  return std::max(0.0, farthest - std::abs(rho_));
}

void Roll::way(const RollPlace& from, const RollPlace& to, std::vector<Vec2>& points) const {
  if (from.pivot) {
    const Vec2 p = planar(elements_[from.index].p0), a = from.center - p;
    const double turn = angleBetween(a, to.center - p);
    const double step = 2.0 * std::acos(1.0 - std::min(1.0, kChordError / std::abs(rho_)));
    const int count = static_cast<int>(std::ceil(std::abs(turn) / step));
    for (int k = 1; k < count; ++k) {
      const double angle = turn * k / count;
      points.push_back(p + std::cos(angle) * a + std::sin(angle) * leftOf(a));
    }
  }
  points.push_back(to.center);
}

}  // namespace proveout::comp_detail
