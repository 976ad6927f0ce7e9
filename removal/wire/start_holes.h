// Start holes in a blank with upright walls.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "removal/grid/start_hole.h"
#include "removal/wire/wire_stock.h"

namespace proveout {

/// Walls between holes, and between a hole and the border, are thicker than this, mm.
inline constexpr double kLeastWallMm = 1e-3;

/// Adds the holes to the hollows of the blank. Errors: a hole that does not lie wholly inside the blank, or
/// that meets another one.
Status addStartHoles(PrismBlank& blank, const std::vector<StartHole>& holes);

}  // namespace proveout
