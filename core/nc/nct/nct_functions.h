// Functions of the machine that programs only pass on: groups of M codes, auxiliary functions (manual 13).
#pragma once

#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// Group of the M code by N1341 to N1372, 1 to 16; 0: none.
int mGroup(const NctParameters& parameters, int m);
/// Is the M code one of those that the parameters BUF name: blocks are read only when it is done.
bool endsLookAhead(const NctParameters& parameters, int m);
/// Takes the words of auxiliary functions (N1333 to N1335) out of the block: nothing else sees them. An
/// address that is an axis stays one. False: no integer of up to 8 digits, reported.
bool takeAuxiliary(NctContext& c, BlockPlan& plan);
/// Sends the auxiliary functions of the block. False: an error was reported.
bool performAuxiliary(NctContext& c, const BlockPlan& plan);
/// Refuses auxiliary functions at letters that cannot be one.
bool checkAuxiliary(NctContext& c);

}  // namespace proveout::nc
