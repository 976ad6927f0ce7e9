// Feeds of the nct control: limits from parameters, the feed in force, how blocks join (manual chapters 6 and
// 7).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Hands the parameters of chapters 6 and 7 to the emitter. At power-on and when a program has written one.
void configureFeeds(IsoContext& c);

/// How a motion of the block in hand joins its neighbours: G9, G61 to G64.
MotionJoin joinOf(const BlockPlan& plan);

/// Spindle speed for feeds and dwells per turn, 1/min; warns once if the spindle stands still.
double turnsPerMinute(IsoContext& c, const BlockPlan& plan);
/// The feed in force. False: none is programmed.
bool feedStyle(IsoContext& c, BlockPlan& plan, FeedStyle& style);

}  // namespace proveout::nc
