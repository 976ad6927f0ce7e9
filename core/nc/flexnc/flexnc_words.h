// The words of a block, carried out from left to right (digest flexnc, 2.1).
#pragma once

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// Whether the control knows all codes and addresses of the block: before anything of it happens.
bool checkFlexWords(FlexContext& c);
/// Carries out the block in hand. False: an error was reported, here as below.
bool performFlexWords(FlexContext& c, FlexCursor& cursor);
/// The motion of the words of axes that wait.
bool performFlexAxes(FlexContext& c, FlexCursor& cursor);

// What the rows of the codes name.
bool performFlexMotionCode(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexDwell(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexPlane(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexShift(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexNothing(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexSurfaceSpeed(FlexContext& c, FlexCursor& cursor, const FlexWord& word);

}  // namespace proveout::nc
