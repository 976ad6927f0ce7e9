#include "core/tool/convex_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout {

namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr double kNoLength = 1e-12;  ///< mm
/// Normals of neighbouring sides that differ by less are one direction, radians.
constexpr double kSmooth = 1e-9;

double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }
Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// `angle` plus full turns, the first at or above `least`.
double above(double angle, double least) { return angle + kTurn * std::ceil((least - angle) / kTurn); }

/// Outward normal at the start or the end of a side.
double normalAt(const OutlineSide& side, bool at_end) {
  if (side.arc) return angleOf((at_end ? side.to : side.from) - side.center);
  const Vec2 d = side.to - side.from;
  return std::atan2(-d.x(), d.y());
}

bool arcHolds(const OutlineSide& arc, const Vec2& p) {
  const double begin = normalAt(arc, false);
  return above(angleOf(p - arc.center), begin) <= above(normalAt(arc, true), begin);
}

}  // namespace

int circleSteps(double radius, double tolerance) {
  if (!(radius > tolerance)) return 4;
  const double step = 2.0 * std::acos(1.0 - tolerance / radius);
  return 4 * std::max(1, static_cast<int>(std::ceil(kTurn / (4.0 * step))));
}

ConvexOutline::ConvexOutline(const std::vector<OutlineSide>& sides) {
  for (const OutlineSide& side : sides) {
    if ((side.to - side.from).norm() > kNoLength) sides_.push_back(side);
  }
  PROVEOUT_ASSERT(sides_.size() >= 2);
  double at = normalAt(sides_.front(), false);
  const double begin = at;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const OutlineSide& side = sides_[k];
    if (side.arc) {
      const double end = above(normalAt(side, true), at);
      turns_.push_back({at, end, side.center, side.radius});
      at = end;
    }
    const double next = normalAt(sides_[(k + 1) % sides_.size()], false);
    double end = above(next, at);
    if (end - at > kTurn - kSmooth) end = at;  // smooth, the next normal a hair behind
    if (k + 1 == sides_.size()) {
      PROVEOUT_ASSERT(at <= begin + kTurn + kSmooth);  // convex, and once round
      end = begin + kTurn;
    }
    turns_.push_back({at, end, side.to, 0.0});
    at = end;
  }
  PROVEOUT_ASSERT_DEAR(std::ranges::is_sorted(turns_, {}, &Turn::begin));
  min_ = {support(kPi).x(), support(-0.5 * kPi).y()};
  max_ = {support(0.0).x(), support(0.5 * kPi).y()};
}

std::size_t ConvexOutline::turnAt(double direction) const {
  const auto at = std::upper_bound(turns_.begin(), turns_.end(), direction,
                                   [](double d, const Turn& turn) { return d < turn.begin; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, at - turns_.begin() - 1));
}

Vec2 ConvexOutline::support(double direction) const {
  double d = above(direction, turns_.front().begin);
  if (d >= turns_.front().begin + kTurn) d -= kTurn;
  const Turn& turn = turns_[turnAt(d)];
  return turn.center + turn.radius * unit(d);
}

void ConvexOutline::chain(double from, double to, double tolerance, std::vector<Vec2>& points) const {
  double start = above(from, turns_.front().begin);
  if (start >= turns_.front().begin + kTurn) start -= kTurn;
  double shift = from - start;  // of the directions asked for against those of the turns
  const auto add = [&](const Vec2& p) {
    if (points.empty() || (points.back() - p).norm() > kNoLength) points.push_back(p);
  };
  std::size_t k = turnAt(start);
  for (double at = from; at <= to;) {
    const Turn& turn = turns_[k];
    const double end = std::min(to, turn.end + shift);
    add(turn.center + turn.radius * unit(at));
    if (turn.radius > 0.0) {
      const double step = kTurn / circleSteps(turn.radius, tolerance);
      for (double i = std::floor(at / step + 1e-6) + 1.0; i * step < end - 1e-6 * step; ++i)
        add(turn.center + turn.radius * unit(i * step));
      add(turn.center + turn.radius * unit(end));
    }
    if (turn.end + shift >= to) return;
    at = turn.end + shift;
    if (++k == turns_.size()) {
      k = 0;
      shift += kTurn;
    }
  }
}

ConvexOutline::Sample ConvexOutline::sample(const Vec2& p) const {
  Sample best;
  best.value = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const OutlineSide& side = sides_[k];
    Vec2 nearest;
    double out;  // signed distance to the side's line or circle
    Vec2 normal;
    if (side.arc) {
      const Vec2 arm = p - side.center;
      const double length = arm.norm();
      const bool holds = length > 0.0 && arcHolds(side, p);
      out = length - side.radius;
      normal = length > 0.0 ? Vec2(arm / length) : unit(normalAt(side, false));
      const bool to_end = (p - side.to).squaredNorm() < (p - side.from).squaredNorm();
      nearest = holds ? Vec2(side.center + side.radius * normal) : to_end ? side.to : side.from;
      // Beyond its sector an arc says nothing of the inside: its neighbours do, or the chord.
      const Vec2 chord = side.to - side.from;
      if (!holds && cross2(chord, p - side.from) > 0.0) out = -1.0;
    } else {
      const Vec2 d = (side.to - side.from).normalized();
      const double along = std::clamp(d.dot(p - side.from), 0.0, (side.to - side.from).norm());
      nearest = side.from + along * d;
      normal = {d.y(), -d.x()};
      out = normal.dot(p - side.from);
    }
    if (out > 0.0) inside = false;
    const Vec2 away = p - nearest;
    const double distance = away.norm();
    if (distance >= best.value) continue;
    best = {distance, distance > 1e-12 ? Vec2(away / distance) : normal, static_cast<int>(k)};
  }
  if (inside) {
    best.value = -best.value;
    if (best.value < -1e-12) best.gradient = -best.gradient;
  }
  return best;
}

ConvexOutline mirrored(const ConvexOutline& outline, int axis) {
  std::vector<OutlineSide> sides(outline.sides().rbegin(), outline.sides().rend());
  for (OutlineSide& side : sides) {
    std::swap(side.from, side.to);
    for (Vec2* p : {&side.from, &side.to, &side.center}) (*p)[axis] = -(*p)[axis];
  }
  return ConvexOutline(sides);
}

ConvexOutline shifted(const ConvexOutline& outline, const Vec2& by) {
  std::vector<OutlineSide> sides = outline.sides();
  for (OutlineSide& side : sides) {
    side.from += by;
    side.to += by;
    side.center += by;
  }
  return ConvexOutline(sides);
}

}  // namespace proveout
