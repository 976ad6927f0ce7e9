// Vertices with normals for viewers that know no creases.
#pragma once

#include "io/exchange/deviation_mesh.h"

namespace proveout {

/// Each vertex as often as faces with different normals meet at it, by the rule of the pictures: faces within
/// 25 degrees are shaded as one surface.
ShadedVertices shadedVertices(const DeviationMesh& mesh);

}  // namespace proveout
