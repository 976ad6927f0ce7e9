// What the parts of PathEmitter share about ways of all axes.
#pragma once

#include <array>

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// Where shapes of ways are compared: no fractions of a turn that an arc of several turns repeats.
inline constexpr std::array<double, 4> kProbes{0.137, 0.389, 0.618, 0.871};

/// All axes at a share of the straight way from `a` to `b`.
inline AxisPoint between(const AxisPoint& a, const AxisPoint& b, double share) {
  AxisPoint p;
  for (int k = 0; k < kMaxAxes; ++k) p[k] = a[k] + (b[k] - a[k]) * share;
  return p;
}

}  // namespace proveout::nc
