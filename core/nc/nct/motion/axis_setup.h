// Axes as the control's parameters change them.
#pragma once

#include "core/nc/control/control_settings.h"

namespace proveout::nc {

/// The settings with the axes that N0100 to N0103 and N0106.ROT name: a parameter of axis number n changes
/// the axis of that number or adds one. Settings that cannot be come out as checkAxes() refuses them.
ControlSettings withAxisParameters(const ControlSettings& settings);

}  // namespace proveout::nc
