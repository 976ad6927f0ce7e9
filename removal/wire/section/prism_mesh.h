// The surface of upright prisms over sections, as a triangle mesh.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {

/// The bodies from z_low to z_high, closed and outwards, a shell each. Corners of the sections are exact (to
/// a float); chords leave arcs by no more than `tolerance` mm, their ends on the arcs. Walls carry the
/// motions of their edges, faces kNoMotion. Bodies that are too thin for floats at their place are left out.
TriMesh prismMesh(const std::vector<PlaneBody>& bodies, double z_low, double z_high, double tolerance);

}  // namespace proveout
