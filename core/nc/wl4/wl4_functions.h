// Spindle, tools and other functions of the WL4 control. False: an error was reported.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// Runs the block's M functions of one phase; at the start also a change of the spindle's speed.
bool performFunctions(Wl4Context& c, Wl4BlockPlan& p, Wl4Phase phase);
/// M6: takes the machine to where it changes tools, before anything else of the block is planned.
bool goToToolChange(Wl4Context& c);
/// The spindle goes on as the state says.
bool turnSpindle(Wl4Context& c, const Wl4State& s);

// What the rows of the codes name.
bool performDwell(Wl4Context& c, Wl4BlockPlan& p);
bool performStop(Wl4Context& c, Wl4BlockPlan& p, int m);
bool performOptionalStop(Wl4Context& c, Wl4BlockPlan& p, int m);
/// M3, M4, M5, M19.
bool performSpindle(Wl4Context& c, Wl4BlockPlan& p, int m);
bool performToolChange(Wl4Context& c, Wl4BlockPlan& p, int m);
bool performCoolant(Wl4Context& c, Wl4BlockPlan& p, int m);
/// M40 to M48.
bool performGear(Wl4Context& c, Wl4BlockPlan& p, int m);
/// Functions of the machine, which the path tells of.
bool performOther(Wl4Context& c, Wl4BlockPlan& p, int m);

}  // namespace proveout::nc
