// Pieces that came free of a part.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/process/stock_body.h"

namespace proveout {

/// A mesh without the pieces that it may hold as shells of their own: a shell whose bounds are those of a
/// piece is that piece. Vertices stay, motions go.
TriMesh withoutPieces(const TriMesh& mesh, const std::vector<TriMesh>& pieces);

/// The part with its pieces above or below it, as a picture shows them: where a piece leaves, as `bodies`
/// tell (the part first, then the pieces in their order). Where both ways are free, or none is, slugs go up
/// and frames, which are larger than the part, down.
TriMesh takenApart(const TriMesh& mesh, const std::vector<TriMesh>& pieces,
                   const std::vector<StockBody>& bodies);

}  // namespace proveout
