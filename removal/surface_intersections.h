// Triangles of a mesh that run through each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Pairs of triangles that meet elsewhere than in their common corners, at least one of them with a corner
/// that is a suspect (a flag for each vertex). Each pair once, the lower number first, in order. In double
/// precision: triangles that touch within rounding may be told either way. `block_mm` > 0: about the size of
/// a triangle.
std::vector<std::array<std::uint32_t, 2>> findIntersections(const TriMesh& mesh,
                                                            std::span<const std::uint8_t> suspect,
                                                            double block_mm);

}  // namespace proveout
