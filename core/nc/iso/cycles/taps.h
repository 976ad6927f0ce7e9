// The main spindle in the tapping cycles G74, G84, G84.2, G84.3 (manual 18.1.2, 18.1.8 to 18.1.10).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// What a cycle taps.
struct Tap {
  int hand = 0;        ///< +1 a right-hand thread, -1 a left-hand one, 0: it taps nothing
  bool rigid = false;  ///< the cycle turns the spindle along with the axis, without a floating chuck
};

/// Warns where the spindle does not turn into the thread when a cycle with a floating chuck begins; a rigid
/// tap needs no start.
void checkTapStart(IsoContext& c, const BlockPlan& plan, const Tap& tap);
/// Gives one way of a tap its spindle: signed speed, acceleration along the path, a stand at the end.
/// `inwards`: towards the bottom; `extraction`: the last way out of the hole.
void takeTapSpindle(const IsoContext& c, const BlockPlan& plan, const Tap& tap, bool inwards, bool extraction,
                    FeedStyle& style);

}  // namespace proveout::nc
