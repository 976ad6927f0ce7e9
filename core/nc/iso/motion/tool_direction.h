// Motions that the rotary axes ask for: G53.1, and the call of G54.2 (manual 25.4, 25.11).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// G54.2 alone: the linear axes go to the new zero (N3212.FOS = 0). False: an error was reported.
bool followZero(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
