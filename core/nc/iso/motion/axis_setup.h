// Axes as the control's parameters change them.
#pragma once

#include "core/nc/control/control_settings.h"
#include "core/nc/iso/parameters/parameter_table.h"

namespace proveout::nc {

/// The settings with the axes that their parameters name (AxisParam): a parameter of axis number n changes
/// the axis of that number or adds one. Settings that cannot be come out as checkAxes() refuses them.
ControlSettings withAxisParameters(const ParameterTable& table, const ControlSettings& settings);

}  // namespace proveout::nc
