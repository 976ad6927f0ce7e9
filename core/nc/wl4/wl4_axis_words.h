// What the words of the axes mean in a block of the WL4 control: steps of plans, which rows of the codes
// name. Each fills the plan; false: an error was reported.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// Positions to go to, and the chamfer behind the motion.
bool planPositions(Wl4Context& c, Wl4BlockPlan& p);
/// G4: X are seconds.
bool planDwell(Wl4Context& c, Wl4BlockPlan& p);
/// G36: axes that are to move, whatever the value.
bool planReference(Wl4Context& c, Wl4BlockPlan& p);
/// G92: where the machine is in the new system.
bool planSystem(Wl4Context& c, Wl4BlockPlan& p);
/// G76 to G78: the start of the contour, which the cycle reads itself.
bool planContourCycle(Wl4Context& c, Wl4BlockPlan& p);

}  // namespace proveout::nc
