// Heights of crests over the surface of a part, to be drawn.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/compare/part/part_feature.h"

namespace proveout {

/// For each triangle the height of the crest that is nearest to its middle, mm; NaN where none is within
/// two of the widest's widths, or one and a half of the distance that those have that were measured.
std::vector<float> crestHeights(const TriMesh& mesh, const std::vector<CrestSample>& crests);

}  // namespace proveout
