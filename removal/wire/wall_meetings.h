// Triangles of a wire's mesh that run through each other.
#pragma once

#include <cstddef>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// How many pairs of triangles of a closed mesh meet elsewhere than in their common corners. Its lowest and
/// its highest faces are level: there the edges that bound them are compared, a pair of edges counts as one,
/// and so does a triangle that is turned over. Walls of a leaning wire are compared as strips, in the order
/// of their triangles. Where all walls are upright their edges say everything.
std::size_t wallMeetings(const TriMesh& mesh);

}  // namespace proveout
