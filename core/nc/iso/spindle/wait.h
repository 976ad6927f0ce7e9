// Waiting points of channels (manual 14.5).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Refuses ranges that cannot be waiting codes.
bool checkWaitCodes(IsoContext& c);
/// Plans a block with a waiting code: it and P alone, P the digits of the channels that meet. False: an error
/// was reported.
bool planWait(IsoContext& c, BlockPlan& plan, const Word& m);
/// Everything that was programmed is done; c.waiting says what the channel waits for. False: an error was
/// reported.
bool performWait(IsoContext& c, const BlockPlan& plan);
/// The channel goes on, having waited `idle_s`.
void endWait(IsoContext& c, double idle_s);

}  // namespace proveout::nc
