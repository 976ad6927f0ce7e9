// Figures over a whole sampled surface.
#pragma once

#include "removal/compare.h"
#include "removal/deviation_patches.h"

namespace proveout {

/// Fills max_gouge, max_excess (of both sides), rms, p95 and the histogram (of the machined side).
void fillStatistics(const BothSides& sides, Comparison& comparison);

/// See Comparison::nominal_tessellation_mm.
double estimateTessellation(const TriMesh& mesh);

}  // namespace proveout
