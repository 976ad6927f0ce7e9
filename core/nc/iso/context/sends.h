// What a block hands to the pipe beside its motion.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// A function of the block in hand, for the pipe: where it runs, its source, the compensation of `state`.
PathItem functionItem(const IsoContext& c, PathItem::Kind kind, const IsoState& state);
/// An event of the path in its turn, and the time that it takes. False: an error was reported.
bool sendEvent(IsoContext& c, EventKind what, double time_s = 0.0);
/// A rapid to a point of the machine, as an item of its own. The caller settles there. False: an error was
/// reported.
bool sendMachineRapid(IsoContext& c, const AxisPoint& to);

}  // namespace proveout::nc
