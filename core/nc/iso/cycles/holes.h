// The holes of a drilling cycle, for controls that plan theirs in another way.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Drills what plan.payload (Holes) says along plan.next.cycle.drill_axis by c.drill_steps. False: reported.
bool performHoles(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
