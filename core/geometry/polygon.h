// Polygons of a plane.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/plane.h"

namespace proveout {

/// Above 0 where the corners go counter-clockwise. About the first of them, so that a small polygon far from
/// the origin loses no digits.
inline double polygonArea(const std::vector<Vec2>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += 0.5 * cross2(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return sum;
}

}  // namespace proveout
