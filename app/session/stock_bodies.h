// The pieces that a mesh bounds.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/process/stock_body.h"

namespace proveout {

/// Connected pieces of the stock: the largest is the part, others fell off. A closed hollow counts against
/// the piece around it.
std::vector<StockBody> stockBodies(const TriMesh& mesh, const MeshTopology& topology,
                                   const MeshExtent& extent);

}  // namespace proveout
