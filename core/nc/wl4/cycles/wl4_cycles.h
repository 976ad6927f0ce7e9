// Cycles of the WL4 control over contours: G76, and G77 and G78 with P and Q (digest wl4, 10).
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// What the rows of the codes name: reads the contour and cuts its passes. True also where the deed is no
/// cycle over a contour: its program is to run then. False: an error was reported.
bool performContourCycle(Wl4Context& c, Wl4BlockPlan& p);

}  // namespace proveout::nc
