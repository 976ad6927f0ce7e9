// What motion blocks plan beside PlannedMotion.
#pragma once

#include <array>

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// G4.
struct Dwell {
  double seconds = 0.0;
};

/// Rapids to machine points: G53 has one, G28 and G30 have an intermediate point before it.
struct MachineMove {
  bool has_via = false;
  AxisPoint via;  ///< machine
  AxisPoint to;   ///< machine
};

/// Where a chain of threading blocks starts.
struct ThreadStart {
  bool tell = false;
  double lead = 0.0;       ///< mm/turn
  double angle_deg = 0.0;  ///< of the spindle
};

/// A curve that goes along chords (motion/curve.h): a point of it, program coordinates X, Y, Z in mm, for t
/// in 0..1. The data are the function's own.
struct CurveMove {
  using Function = Vec3 (*)(const CurveMove&, double t);
  Function at = nullptr;
  std::array<double, 12> data{};
  const void* more = nullptr;  ///< must live until the curve is carried out
  int pieces = 1;              ///< equal parts of 0..1 in which the curve bends no more than a few times
};

/// G5.1.
struct Smoothing {
  int mode = 0;  ///< Q
};

}  // namespace proveout::nc
