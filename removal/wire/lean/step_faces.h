// Level faces between two sections that share points: what one of them covers and the other does not.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// An edge of a loop, by the numbers of its points; the region is on its left.
using LoopEdge = std::array<std::uint32_t, 2>;

/// Triangles, counter-clockwise seen from above.
struct StepFaces {
  std::vector<std::array<std::uint32_t, 3>> below_alone, above_alone;
};

/// Of the loops that differ between a section and the one above it; all others are the same. Edges meet in
/// common points alone. Each edge is one of a triangle, but for those that both sections have, and those that
/// go to and fro.
StepFaces stepFaces(const std::vector<Vec2>& points, const std::vector<LoopEdge>& below,
                    const std::vector<LoopEdge>& above);

}  // namespace proveout
