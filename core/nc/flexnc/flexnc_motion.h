// Motions of the FlexNC control.
#pragma once

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// Moves along the words with the motion in force. False: an error was reported, here as below.
bool moveFlexAxes(FlexContext& c, const FlexAxisWords& words);

/// A motion from where the machine is to `to` = (x, z), machine frame, compensated as the modes say; without
/// feed.
PathItem flexMotion(FlexContext& c, PathItem::Kind kind, const Vec2& to);
/// Sends it; the machine is at its end then.
bool sendFlexMotion(FlexContext& c, PathItem& item);
/// A function of the block in hand where the machine is.
PathItem flexFunction(FlexContext& c, PathItem::Kind kind);
/// An event of the path in its turn.
bool sendFlexEvent(FlexContext& c, EventKind what);

/// The feed in force for a motion to `to_x` (machine frame).
bool planFlexFeed(FlexContext& c, double to_x, FeedStyle& feed);
/// How fast the spindle turns at a signed radius of the work system, 1/min; 0: it stands.
double flexRpm(const FlexContext& c, double radius);
/// The nose radius that compensation keeps off the contour, mm.
double flexNoseRadius(const FlexContext& c);

}  // namespace proveout::nc
