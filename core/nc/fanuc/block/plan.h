// How Fanuc-like controls plan a block beyond the rules of the family, and what they do at power-on and
// reset.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// IsoDialect::plan: planBlock(), then notes of settings that the block depends on, open curves, lengths that
/// a reference move has ended.
bool planFanuc(IsoContext& c, BlockPlan& plan);
/// IsoDialect::power_on: the plane of `power_on_plane`.
void fanucPowerOn(const IsoContext& c, IsoState& state);
/// IsoDialect::begin: the way of rapids.
void fanucBegin(IsoContext& c);
/// IsoDialect::end_shifts: `g52_at_end`, `g92_at_end`.
void fanucEndShifts(IsoContext& c);
/// IsoDialect::unknown_m: noted once, an error with `strict_m`.
bool fanucUnknownM(IsoContext& c, const Word& word, int number);

}  // namespace proveout::nc
