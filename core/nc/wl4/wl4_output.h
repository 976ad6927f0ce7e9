// Items of the WL4 control on their way to the pipe.
#pragma once

#include "core/nc/stages/motion_pipe.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// A motion of the planned block from where the machine is to its target, without feed.
PathItem motionItem(Wl4Context& c, const Wl4BlockPlan& p, PathItem::Kind kind);
/// Sends it; the machine is at the target then. False: an error was reported.
bool sendMotion(Wl4Context& c, const Wl4BlockPlan& p, PathItem& item);

/// A function of the block in hand where the machine is.
PathItem functionItem(Wl4Context& c, PathItem::Kind kind);
/// An event of the path in its turn, and the time that it takes. False: an error was reported.
bool sendEvent(Wl4Context& c, EventKind what, double time_s = 0.0);

}  // namespace proveout::nc
