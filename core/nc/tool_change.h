// The machine's way to where it changes tools.
#pragma once

#include <vector>

#include "core/nc/axis_point.h"
#include "core/nc/control_settings.h"
#include "core/nc/kind_set.h"

namespace proveout::nc {

/// Points that the machine goes to one after the other in rapid, machine coordinates, mm; none where it
/// stands right. `ceiling`: upper end of Z in the control's own areas, infinite without one.
std::vector<AxisPoint> toolChangeWay(const ControlSettings& settings, const AxisPoint& from, double ceiling);

/// The coordinates that no word gives behind such a way: those of the axes that it may move.
KindSet unsaidBehind(const ToolChangePlace& place);

}  // namespace proveout::nc
