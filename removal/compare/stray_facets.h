// Facets of a mesh that bound nothing: doubled ones, and strays without area.
#pragma once

#include <cstddef>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Removes the triangles whose flag is set; `motion` goes along.
void dropTriangles(TriMesh& mesh, const std::vector<char>& drop);

/// Of facets over the same three vertices keeps one, none or all, as it leaves fewer edges open: a facet that
/// a file has twice is one; two that face each other are where bodies touch, or a fin; two that face the same
/// way may be the common face of bodies that overlap. Where nothing is open either way one is kept, or none
/// of two that face each other. Returns how many were dropped.
std::size_t dropDoubledFacets(TriMesh& mesh);

/// Removes facets no higher than rounding (1e-4 mm) most of whose edges are open: they close nothing. Returns
/// how many.
std::size_t dropFlatStrays(TriMesh& mesh);

}  // namespace proveout
