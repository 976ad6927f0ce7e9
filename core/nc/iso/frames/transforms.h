// Mirroring, scaling and rotation (manual chapter 16).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// G69 and G50 of the block. False: an error was reported.
bool planTransformsOff(IsoContext& c, BlockPlan& plan);
/// Chain and start of the block by the frames of plan.next.
void takeNewChain(const IsoContext& c, BlockPlan& plan);
/// The same after a change of plan.next.transforms.
void renewChain(const IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
