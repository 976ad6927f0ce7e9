// Figures over both sampled surfaces.
#pragma once

#include "removal/compare/comparison.h"
#include "removal/compare/measured_sides.h"

namespace proveout {

/// Fills max_gouge, max_excess, the figures of both sides and the histogram.
void fillStatistics(const BothSides& sides, Comparison& comparison);

}  // namespace proveout
