// The two angles by which two rotary axes turn one direction into another.
#pragma once

#include <array>

#include "core/geometry/types.h"

namespace proveout {

/// Angles in degrees, -180 < angle <= 180.
struct AnglePair {
  double first = 0.0, second = 0.0;
  bool first_free =
      false;  ///< any value of the first does: the direction lies along the first axis (0 is given)
  bool second_free = false;  ///< the same of the second
};

struct AnglePairs {
  int count = 0;  ///< 0: the direction cannot be reached; 1: both solutions are one
  std::array<AnglePair, 2> pair;
};

/// Solutions of Rot(first, a) Rot(second, b) from = to, right-handed, all unit. None where the axes are
/// parallel. `from` turned about the second axis meets what the first one turns `to` into in the intersection
/// of two circles.
AnglePairs solveAngles(const Vec3& first, const Vec3& second, const Vec3& from, const Vec3& to);

}  // namespace proveout
