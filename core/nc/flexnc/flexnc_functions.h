// M functions of the FlexNC control.
#pragma once

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// The spindle as the state has it, at the speed of where the tool is. False: an error was reported, here as
/// below.
bool turnFlexSpindle(FlexContext& c);

// What the rows of the codes name.
bool performFlexOptionalStop(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexEnd(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexSpindle(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexToolChange(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
bool performFlexCoolant(FlexContext& c, FlexCursor& cursor, const FlexWord& word);

}  // namespace proveout::nc
