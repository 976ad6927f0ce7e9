// What a block plans for shifts and work systems.
#pragma once

#include "core/machine/axis_point.h"
#include "core/nc/kinematics/frames.h"

namespace proveout::nc {

/// New values of the shifts and of one work system.
struct FrameChange {
  AxisPoint shift52, shift92;
  WorkSystemId id = -1;  ///< -1: no work system changes
  WorkSystem system;
};

}  // namespace proveout::nc
