// Self-intersections: triangles of a wire's mesh that run through each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Pairs of triangles of a closed mesh that meet elsewhere than in their common corners, and each triangle
/// that is a line, with itself; told without rounding. Its lowest and its highest faces are level: there the
/// edges that bound them are compared, for which the walls at them stand, and a triangle that is turned over
/// is told with itself. Walls of a leaning wire are compared as strips, in the order of their triangles.
/// Where all walls are upright their edges say everything. The same for any number of threads.
std::vector<std::array<std::uint32_t, 2>> wallMeetings(const TriMesh& mesh);

}  // namespace proveout
