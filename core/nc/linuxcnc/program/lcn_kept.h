// Numbered parameters that stand in the registers of the channel: probed point, homes, shift of G92, frames,
// tool.
#pragma once

#include <optional>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// #5061 to #5070, #5161 to #5390, #5401 to #5413. Those from #5161 on are in machine units, the probed point
/// in those of the program. Nothing: it is another one.
std::optional<double> lcnKept(const IsoContext& c, int number);
/// The same the other way; frames take effect when they are chosen next. False: it is another one.
bool putLcnKept(IsoContext& c, int number, double value);

}  // namespace proveout::nc
