// Which words of an nct program are in force: told to the channel's OriginRecorder.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The words of the block in hand take effect as the plan says. Before anything of the block is sent.
void recordWords(IsoContext& c, const BlockPlan& plan);
/// A drilling cycle goes on to the level of the drill axis that `level` gave: kCyclePlane, kCycleDepth,
/// kCycleStep, or kCycleReturn for the initial one.
void recordCycleLevel(IsoContext& c, int drill_axis, OriginKind level);
/// The tool called last is in the spindle.
void recordToolChange(IsoContext& c);
/// Work offsets, shifts and length offset of `state` are in force.
void recordFrames(IsoContext& c, const IsoState& state);
/// Number of a word of the block in hand, for what it sets.
std::uint32_t numberOf(IsoContext& c, const Word& w, OriginKind kind);
/// Number of the first word of an axis in the block, as a value of a table; 0: there is none.
std::uint32_t numberOfAxisWord(IsoContext& c, const BlockPlan& plan, int axis);

}  // namespace proveout::nc
