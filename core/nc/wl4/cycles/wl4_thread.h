// Threads of the WL4 control: what the rows of the codes name. False: an error was reported.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// G32: blocks one behind the other are one thread.
bool performThread(Wl4Context& c, Wl4BlockPlan& p);
/// G33: there and, the spindle reversed, back.
bool performThreadAndBack(Wl4Context& c, Wl4BlockPlan& p);

}  // namespace proveout::nc
