// Which directions the tool can have.
#pragma once

#include "core/machine/machine_model.h"

namespace proveout {

/// Over the travel of all rotary axes, in steps of two degrees: least and largest components of the tool's
/// direction seen from the part, and the largest angle from where it is with all axes at 0.
struct ToolReach {
  Vec3 least = Vec3::Constant(2.0), largest = Vec3::Constant(-2.0);
  double most_tilt_deg = 0.0;
};
/// Axes beyond the second one that turn stay at 0.
ToolReach toolReach(const MachineModel& model);

}  // namespace proveout
