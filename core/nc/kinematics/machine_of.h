// The machine behind a channel's axes.
#pragma once

#include "core/machine/machine_model.h"
#include "core/nc/kinematics/axes.h"

namespace proveout::nc {

/// The machine of the settings; where they name none, one whose X, Y and Z move the tool and whose tables
/// stand on each other in the order of the axes. `origin`: of the workpiece frame, machine frame, mm: a table
/// without a centre turns about it.
MachineModel machineOf(const ControlSettings& settings, const AxisTable& axes, const Vec3& origin);

}  // namespace proveout::nc
