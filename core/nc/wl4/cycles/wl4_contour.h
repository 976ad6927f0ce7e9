// The contour of G76 to G78: blocks of the program, read as if they ran (digest wl4, 10).
#pragma once

#include <vector>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// In the plane (u, v) of the block, mm, machine coordinates; chamfers are cut.
struct Wl4BlockContour {
  PlaneContour elements;
  std::vector<Wl4ContourWords> words;  ///< by ContourElement::source
  Wl4ContourWords start;
};

/// The blocks from P to Q of the cycle in hand. State, machine and block are as before then, variables as the
/// contour's blocks have left them. False: an error was reported.
bool readContour(Wl4Context& c, const Wl4BlockPlan& p, Wl4BlockContour& contour);

}  // namespace proveout::nc
