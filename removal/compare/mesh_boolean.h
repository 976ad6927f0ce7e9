// Booleans of closed meshes, exact but for the rounding of the result to float. By CGAL's corefinement.
#pragma once

#include <optional>

#include "core/mesh/tri_mesh.h"

namespace proveout {

enum class BooleanKind { kUnion, kIntersection, kDifference };

/// Both closed and oriented outwards, without triangles of no area. None where the result is no 2-manifold,
/// or where the surfaces run through themselves next to each other.
std::optional<TriMesh> booleanOf(const TriMesh& a, const TriMesh& b, BooleanKind kind);

/// Whether a triangle of `a` and one of `b` have a point in common. Triangles of no area are left out: their
/// neighbours hold all their points.
bool surfacesMeet(const TriMesh& a, const TriMesh& b);

}  // namespace proveout
