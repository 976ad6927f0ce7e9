// The outline of a pocket, read from the blocks of a subprogram.
#pragma once

#include "core/nc/iso/context/context.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// The outline that P of the block in hand names: program O`P`, or the blocks from N`P` on of the program in
/// hand, up to M99. Its first block leads from `start` (plane coordinates, mm) to the outline, the others are
/// lines and arcs of the plane, 40 at most. False: reported.
bool readOutline(IsoContext& c, const BlockPlan& plan, const Vec2& start, PlaneContour& outline);

}  // namespace proveout::nc
