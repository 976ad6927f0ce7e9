// Places as they are shown to people.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/geometry/types.h"

namespace proveout {

/// Rounded to a micrometre, without a negative zero. mm.
inline double toMicrometre(double mm) { return std::round(mm * 1000.0) / 1000.0 + 0.0; }

/// "X1.000 Y-2.500 Z0.000", to a micrometre. mm.
inline std::string placeText(const Vec3& p) {
  return fmt::format("X{:.3f} Y{:.3f} Z{:.3f}", toMicrometre(p.x()), toMicrometre(p.y()),
                     toMicrometre(p.z()));
}

/// "X0.000..10.000 Y..", to a micrometre. mm.
inline std::string extentText(const Box3& box) {
  const auto along = [&](char axis, int i) {
    return fmt::format("{}{:.3f}..{:.3f}", axis, toMicrometre(box.min[i]), toMicrometre(box.max[i]));
  };
  return along('X', 0) + " " + along('Y', 1) + " " + along('Z', 2);
}

}  // namespace proveout
