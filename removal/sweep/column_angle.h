// Angles of columns about the axis of a helix, without the library's functions: the compiler turns these into
// vectors, and they give the same bits wherever they are compiled. Functions are static, see column_types.h.
#pragma once

namespace proveout {

/// asin(v) for 0 <= v <= 1, rad. Error below 1e-15: the polynomial is the best one for asin on [0, 1/2].
static inline double arcSine(double v) {
  const bool low = v <= 0.5;
  const double half = 0.5 * (1.0 - v), z = low ? v * v : (half > 0.0 ? half : 0.0);
  const double t = low ? v : __builtin_sqrt(z);
  double p = 0.028169218060881412899;
  p = p * z - 0.010749050339697807562;
  p = p * z + 0.016035514349148823079;
  p = p * z + 0.0078029494773533171436;
  p = p * z + 0.0118754943826369232;
  p = p * z + 0.013929652902326633248;
  p = p * z + 0.017355259955786321748;
  p = p * z + 0.022372047631744510379;
  p = p * z + 0.030381947367098481126;
  p = p * z + 0.044642857103423643363;
  p = p * z + 0.075000000000207643609;
  p = p * z + 0.16666666666666648628;
  const double angle = t + t * z * p;
  return low ? angle : 1.57079632679489661923 - 2.0 * angle;
}

/// Angle of a point at (x, y), `d` from the origin, from `cut` on, rad; -pi <= cut <= 0.
static inline double turnAngle(double x, double y, double d, double cut) {
  constexpr double kTurn = 6.28318530717958647693, kLeast = 1e-300;
  const double ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y, side = ax < ay ? ax : ay;
  const double within = arcSine(side / (d > kLeast ? d : kLeast));
  const double up = ay > ax ? 0.25 * kTurn - within : within, round = x < 0.0 ? 0.5 * kTurn - up : up;
  const double angle = y < 0.0 ? -round : round, from = angle < cut ? angle + kTurn : angle;
  return from < cut + kTurn ? from : cut + kTurn;
}

}  // namespace proveout
