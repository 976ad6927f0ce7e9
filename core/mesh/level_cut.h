// The section of a mesh at a height.
#pragma once

#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Closed polygons, the material on their left, where the plane at height z meets a closed mesh; corners at
/// the height itself count as above. mm. Open meshes give open chains, which are left out.
std::vector<std::vector<Vec2>> cutAtHeight(const TriMesh& mesh, double z);

/// Signed, mm2: hollows count below 0.
double areaOf(const std::vector<std::vector<Vec2>>& polygons);

}  // namespace proveout
