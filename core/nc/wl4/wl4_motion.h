// Motions of the WL4 control.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// Carries out the motion in force, or measures along it. False: an error was reported, here as below.
bool performMotion(Wl4Context& c, Wl4BlockPlan& p);

// What the rows of the codes name.
bool performRapid(Wl4Context& c, Wl4BlockPlan& p);
bool performLine(Wl4Context& c, Wl4BlockPlan& p);
/// G2 and G3.
bool performArc(Wl4Context& c, Wl4BlockPlan& p);
/// G12 and G13.
bool performQuarter(Wl4Context& c, Wl4BlockPlan& p);
/// G36: to the zero of the machine on the axes that the block names.
bool performReference(Wl4Context& c, Wl4BlockPlan& p);

}  // namespace proveout::nc
