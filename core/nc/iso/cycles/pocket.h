// The pocket milling macro of the control, G65 P9999 (manual 23.6).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Number of the macro. A program of the user's with this number goes first.
inline constexpr std::int64_t kPocketProgram = 9999;

/// Turns the arguments of the call in `frame` into the frame of the built-in macro. False: MACRO ERROR 1 or
/// 2, or an illegal address, reported.
bool pocketFrame(IsoContext& c, CallFrame& frame);

}  // namespace proveout::nc
