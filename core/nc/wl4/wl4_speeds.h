// Feeds and speeds of the spindle in the WL4 control.
#pragma once

#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// Of the spindle in that state at a diameter (signed, mm), 1/min.
double rpmAt(const Wl4Setup& setup, const Wl4State& s, double diameter);
/// Warns of constant surface speed that comes to the axis between two signed diameters (mm), with nothing
/// that limits the spindle.
void warnOfUnlimitedSpeed(Wl4Context& c, const Wl4State& s, double from, double to);
/// The feed of the planned motion from where the machine is to its target. False: it has none, reported.
bool planFeed(Wl4Context& c, const Wl4BlockPlan& p, FeedStyle& feed);

}  // namespace proveout::nc
