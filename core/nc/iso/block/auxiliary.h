// Auxiliary functions: addresses whose numbers programs only pass on to the machine (manual 13).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Takes the words of auxiliary functions (N1333 to N1335) out of the block: nothing else sees them. An
/// address that is an axis stays one. False: no integer of up to 8 digits, reported.
bool takeAuxiliary(IsoContext& c, BlockPlan& plan);
/// Sends the auxiliary functions of the block. False: an error was reported.
bool performAuxiliary(IsoContext& c, const BlockPlan& plan);
/// Refuses auxiliary functions at letters that cannot be one.
bool checkAuxiliary(IsoContext& c);

}  // namespace proveout::nc
