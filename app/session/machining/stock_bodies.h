// The pieces that a mesh bounds.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/process/stock_body.h"

namespace proveout {

/// Connected pieces of the stock, the part first: the one whose bounds are most like the wanted ones, without
/// such the largest. Others fell off. A closed hollow counts against the piece around it. Loose pieces have
/// the volume that the mesh encloses, the part what is left of `volume_mm3`, the exact integral over all of
/// them: facets and thin walls leave the mesh off from it.
std::vector<StockBody> stockBodies(const TriMesh& mesh, const MeshTopology& topology,
                                   const MeshExtent& extent, double volume_mm3,
                                   const std::optional<Box3>& wanted = {});

/// Bounds of the piece that holds a point; none: the point is in no material.
std::optional<Box3> pieceAround(const TriMesh& mesh, const Vec3& point);

}  // namespace proveout
