// Heights of crests over the surface of a part, to be drawn.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/compare/part/part_feature.h"

namespace proveout {

/// For each triangle the height of the highest crest near its middle, mm: within two of the widest's widths,
/// or one and a half of the distance between those that were measured. NaN where none is, and where no motion
/// cut.
std::vector<float> crestHeights(const TriMesh& mesh, const std::vector<CrestSample>& crests);

}  // namespace proveout
