// Motions that the rotary axes ask for: G53.1, and the call of G54.2 (manual 25.4, 25.11).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Whether the block calls G54.2 where another code than G0 and G1 is in force: its motion is a rapid.
bool callsInRapid(const BlockPlan& plan);
/// G54.2 alone: the linear axes go to the new zero (N3212.FOS = 0). False: an error was reported.
bool followZero(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
