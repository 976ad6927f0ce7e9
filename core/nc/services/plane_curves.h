// Lines and circles in a plane and where they meet.
#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/plane.h"

namespace proveout {

/// An infinite line or a full circle. Lengths mm.
struct PlaneCurve {
  bool circle = false;
  Vec2 point = Vec2::Zero();       ///< on the line, or the centre
  Vec2 direction = Vec2::UnitX();  ///< unit, lines
  double radius = 0.0;             ///< circles, >= 0
};

/// Common points of two curves, at most two.
struct Meeting {
  std::array<Vec2, 2> points;
  std::size_t count = 0;
  void add(const Vec2& p) { points[count++] = p; }
};

/// Curves that miss each other by less than a micrometre's thousandth touch. Parallel lines and circles about
/// one centre do not meet.
Meeting meet(const PlaneCurve& a, const PlaneCurve& b);

}  // namespace proveout
