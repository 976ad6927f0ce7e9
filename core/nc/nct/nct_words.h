// What plan functions do with words: numbers, axis targets, feeds.
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// "G54.1" of 541.
std::string gName(int code10);
/// A length of the block in mm.
inline double lengthOf(const BlockPlan& plan, const Word& w) { return w.value * plan.next.unitScale(); }
/// The integer that a word must hold. False, with alarm 2002: no integer, or out of range.
bool integerWord(NctContext& c, const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out);
/// End point of the axis words, in the plan's chain, mm; marks the named axes in plan.motion.named. False: an
/// axis is given twice.
bool axisTarget(NctContext& c, BlockPlan& plan, Vec3& target);
/// Spindle speed for feeds and dwells per turn, 1/min; warns once if the spindle stands still.
double turnsPerMinute(NctContext& c, const BlockPlan& plan);
/// The feed in force. False: none is programmed.
bool feedStyle(NctContext& c, BlockPlan& plan, FeedStyle& style);

/// Is the word one of X Y Z U V W? Then `axis` is 0 to 2, and `step` says whether it counts from where the
/// tool is.
bool axisWord(const BlockPlan& plan, const Word& w, int& axis, bool& step);

}  // namespace proveout::nc
