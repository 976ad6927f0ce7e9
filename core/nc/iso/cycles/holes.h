// The holes of a drilling cycle, for controls that plan theirs in another way.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The axis words of the block: the bottom goes to plan.next.cycle, the other axes to `holes`.
void takeHoleWords(const IsoContext& c, BlockPlan& plan, Holes& holes);
/// Levels of `holes` and of its cycle from plan.next.cycle, which has a bottom; without R it is the initial
/// level.
void takeLevels(const BlockPlan& plan, Holes& holes, DrillCycle& cycle);
/// Drills what plan.payload (Holes) says along plan.next.cycle.drill_axis by c.drill_steps. False: reported.
bool performHoles(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
