// Cycles of the FlexNC control: templates and special blocks (digest flexnc, 5 to 10).
#pragma once

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// The cycle of the code word; what stands behind it are its arguments. False: an error was reported, here as
/// below.
bool performFlexCycle(FlexContext& c, FlexCursor& cursor, const FlexWord& word);

/// Whether the block in hand goes on with the contour of the block before (K=0).
bool goesOnWithContour(const FlexContext& c);
/// The moves that are due where no contour block goes on.
bool endFlexContours(FlexContext& c);

// What the rows of the codes name.
/// G81.1, G81.2 and G81.3: to the equidistant.
bool performFlexApproach(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
/// G81: compensation off, to the point of the tool change.
bool performFlexEndBlock(FlexContext& c, FlexCursor& cursor, const FlexWord& word);

}  // namespace proveout::nc
