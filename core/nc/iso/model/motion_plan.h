// What motion blocks plan beside PlannedMotion.
#pragma once

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

/// G5.1.
struct Smoothing {
  int mode = 0;  ///< Q
};

}  // namespace proveout::nc
