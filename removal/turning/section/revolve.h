// The surface of a turned part as a triangle mesh, straight from its section.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/turning/section/section.h"

namespace proveout {

/// Points of a loop that are needed to stay within `tolerance` mm of it. Borders between motions stay where
/// what both made is longer than 100 tolerances, 200 of a loop at most; an edge that stands for several has
/// the motion that made most of it.
SectionLoop simplified(const SectionLoop& loop, double tolerance);
/// Their numbers, in order; all of them where fewer than 3 would do.
std::vector<std::size_t> keptPoints(const SectionLoop& loop, double tolerance);
/// The loop with these points alone.
SectionLoop simplified(const SectionLoop& loop, const std::vector<std::size_t>& kept);

/// The bodies turned about Z: closed and oriented. Corners are exact; rings are on the surface, and facets
/// between them inside of it by at most `tolerance` mm (outer radii), sections simplified within as much.
TriMesh revolved(const std::vector<SectionBody>& bodies, double tolerance);

}  // namespace proveout
