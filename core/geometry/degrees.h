// Sines and cosines of angles in degrees. What is a simple number comes out as one: 0, 0.5 and 1 at multiples
// of 30 and 90 degrees, for any number of turns.
#pragma once

#include <cmath>

#include "core/geometry/types.h"

namespace proveout {

struct SinCos {
  double sin = 0.0, cos = 1.0;
};

/// Of any finite angle; NaN otherwise.
inline SinCos sinCosDegrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // exact, as is the rest below
  const double quarters = std::round(turn / 90.0);
  const double rest = turn - 90.0 * quarters;  // -45 to 45
  const double s = std::abs(rest) == 30.0 ? std::copysign(0.5, rest) : std::sin(degToRad(rest)) + 0.0;
  const double c = std::cos(degToRad(rest));
  if (quarters == 1.0) return {c, 0.0 - s};
  if (quarters == -1.0) return {0.0 - c, s};
  if (std::abs(quarters) == 2.0) return {0.0 - s, 0.0 - c};
  return {s, c};
}
inline double sinDegrees(double degrees) { return sinCosDegrees(degrees).sin; }
inline double cosDegrees(double degrees) { return sinCosDegrees(degrees).cos; }

}  // namespace proveout
