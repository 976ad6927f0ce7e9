// How much a program of the FlexNC control may run.
#pragma once

#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// Counts a block, or a move of a cycle. True: the run was cancelled, or the limit of blocks, reported.
bool flexWorkOver(FlexContext& c);
/// Whether the program is in a loop without an end at the block in hand: reported then. `counters`: of the
/// REPEAT statements that are under way.
bool flexGoesRound(FlexContext& c, std::uint64_t counters);

/// Whether the program is in a loop that comes no nearer to its end at the block in hand: reported then.
bool flexGoesOn(FlexContext& c);

}  // namespace proveout::nc
