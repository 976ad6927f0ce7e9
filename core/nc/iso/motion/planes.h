// Planes by axis.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The plane of the G17, G18 or G19 of the block, by the axis words beside it. False: reported.
bool planPlane(IsoContext& c, BlockPlan& plan);
/// Can the plane in force hold circles and compensated paths? False, with that alarm: it has a rotary axis
/// that does not stand for a linear one, or a parallel axis under a rotation.
bool planeOfLines(IsoContext& c, const BlockPlan& plan, SharedAlarm alarm, const char* what);

}  // namespace proveout::nc
