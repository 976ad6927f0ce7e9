// What measuring moves plan.
#pragma once

#include "core/machine/axis_point.h"

namespace proveout::nc {

/// G31.
struct SkipMove {
  AxisPoint to;  ///< machine
};

/// G37: rapid to `approach`, then at feed towards the gauge. Programmed coordinates, mm.
struct LengthMove {
  AxisPoint approach, gauge, furthest, beyond;
  int axis = 0;
};

}  // namespace proveout::nc
