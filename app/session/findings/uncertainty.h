// How far the surface of a machined part may lie off the true one.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// How far the exported surface may lie off the true one: chords of the grid on a wall as curved as the
/// smallest radius of the tools used, h^2 / (8 r), at most half a cell. Flat surfaces are exact. mm.
double surfaceUncertainty(const Toolpath& path, const std::vector<Tool>& tools, double resolution_mm);

/// Largest error of the part's surface over all clampings, mm: a move into another clamping that is not
/// exact adds the chords of the mesh that it is made from (Stock::moved).
double partUncertainty(const RunResult& run);
/// The share of it that moves add, mm; 0 with one clamping.
double movesUncertainty(const RunResult& run);

}  // namespace proveout
