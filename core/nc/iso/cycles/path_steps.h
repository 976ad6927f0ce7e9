// Blocks that stand for many motions: pockets, engraving.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Carries out c.path_steps: a perform function. Feeds are those of plan.motion.feed. Cutter compensation is
/// off in such a block. False: an error was reported.
bool performSteps(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
