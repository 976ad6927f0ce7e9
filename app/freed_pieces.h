// Pieces that came free of a part.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// A mesh without the pieces that it may hold as shells of their own: a shell whose bounds are those of a
/// piece is that piece. Vertices stay, motions go.
TriMesh withoutPieces(const TriMesh& mesh, const std::vector<TriMesh>& pieces);

}  // namespace proveout
