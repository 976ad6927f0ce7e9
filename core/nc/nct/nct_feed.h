// Feeds of the nct control: limits from parameters, how blocks join (manual chapters 6 and 7).
#pragma once

#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// Hands the parameters of chapters 6 and 7 to the emitter. At power-on and when a program has written one.
void configureFeeds(NctContext& c);

/// How a motion of the block in hand joins its neighbours: G9, G61 to G64.
MotionJoin joinOf(const BlockPlan& plan);

/// Part of the feed on an arc that cutter compensation has made smaller (manual 6.4): 1 where it has not.
double insideArcFactor(const NctParameters& parameters, double programmed_radius, double radius);

}  // namespace proveout::nc
