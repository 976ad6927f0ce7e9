// First zero of a field along a grid edge.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {

/// Root of `f` in [a, b] where f(a) >= 0 > f(b): regula falsi with the Illinois rule. `tolerance` is on the
/// parameter.
template <typename F>
double edgeRoot(F&& f, double a, double fa, double b, double fb, double tolerance) {
  PROVEOUT_ASSERT_DEAR(fa >= 0.0 && fb < 0.0);
  int side = 0;
  for (int i = 0; i < 100 && std::abs(b - a) > tolerance; ++i) {
    double t = (fa * b - fb * a) / (fa - fb);
    if (!(t > std::min(a, b) && t < std::max(a, b))) t = 0.5 * (a + b);
    if (i > 20) t = 0.5 * (a + b);  // a function with a kink at the root: bisect
    const double ft = f(t);
    if (std::abs(ft) < 1e-10) return t;  // mm: far below every tolerance
    if (ft >= 0.0) {
      a = t;
      fa = ft;
      if (side == 1) fb *= 0.5;
      side = 1;
    } else {
      b = t;
      fb = ft;
      if (side == -1) fa *= 0.5;
      side = -1;
    }
  }
  return 0.5 * (a + b);
}

}  // namespace proveout
