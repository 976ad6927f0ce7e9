// Modal state at power-on and after the end of a program (manual chapter 3).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The codes and words that power-on sets (N1300, N1301, N0300, N0301, ...).
IsoState powerOnState(const IsoContext& c);
/// Power-on: modal codes, frames and position.
void powerOn(IsoContext& c);
/// Reset, M2, M30: groups return to their codes of power-on, where N1301.CLR and the CLR tables do not keep
/// them; G52 and G92 shifts go. Feed, speeds, tool and tables stay.
void resetAtEnd(IsoContext& c);

}  // namespace proveout::nc
