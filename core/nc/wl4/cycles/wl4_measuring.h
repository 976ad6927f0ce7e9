// Measuring moves of the WL4 control.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// G38: to the end or the first touch and back the same way. False: an error was reported.
bool performMeasuring(Wl4Context& c, Wl4BlockPlan& p);

}  // namespace proveout::nc
