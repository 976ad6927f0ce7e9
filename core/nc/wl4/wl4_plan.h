// Planning a block of the WL4 control.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// All checks of the block in hand, on a copy of the modal state. Changes nothing in the run. False: an error
/// was reported.
bool planBlock(Wl4Context& c, Wl4BlockPlan& p);

/// The code takes effect in the plan.
void selectCode(Wl4BlockPlan& p, const Wl4GCode& code);

}  // namespace proveout::nc
