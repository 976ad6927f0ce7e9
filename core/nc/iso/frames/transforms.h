// Mirroring, scaling and rotation (manual chapter 16).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// G69 and G50 of the block. False: an error was reported.
bool planTransformsOff(IsoContext& c, BlockPlan& plan);
/// After a change of plan.next.transforms: chain and start of the block.
void renewChain(const IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
