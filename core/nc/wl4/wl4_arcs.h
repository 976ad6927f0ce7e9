// Circles of blocks of the WL4 control.
#pragma once

#include "core/nc/services/arcs.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// G2 and G3 from where the machine is to the target; `moves` tells whether the block moves. False: an error
/// was reported.
bool resolveBlockArc(Wl4Context& c, const Wl4BlockPlan& p, PlaneArc& arc, bool& moves);
/// G12 and G13: centre (u, v), mm, and signed sweep, rad. False: an error was reported.
bool resolveQuarter(Wl4Context& c, const Wl4BlockPlan& p, Vec2& center, double& sweep);

}  // namespace proveout::nc
