// Points of the nominal surface at which trials are judged.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Points of the mesh within `box`, spread over the area; the same for the same input. At most `most`.
std::vector<Vec3> nominalSamples(const TriMesh& mesh, const Box3& box, std::size_t most);

}  // namespace proveout
