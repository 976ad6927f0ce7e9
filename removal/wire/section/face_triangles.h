// Triangles of a flat face with hollows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// Triangles whose corners are those of the loops alone, counter-clockwise. Corners are numbered through all
/// loops in their order. `loops`: the outer border first, counter-clockwise, then hollows, clockwise; three
/// points or more each, no two neighbours equal. Always n + 2 h - 2 triangles for n points and h hollows,
/// which use each edge of the loops once: the face is closed even where loops cross each other (some
/// triangles then are turned over or flat). Cutting of ears (G. H. Meisters, 1975), hollows joined to the
/// border by bridges (D. Eberly, 1998).
std::vector<std::array<std::uint32_t, 3>> faceTriangles(const std::vector<std::vector<Vec2>>& loops);

}  // namespace proveout
