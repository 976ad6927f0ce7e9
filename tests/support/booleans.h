// Booleans of closed meshes by CGAL: what tests build nominals with and compare volumes against.
#pragma once

#include "core/mesh/tri_mesh.h"

namespace proveout {

enum class BooleanKind { kUnion, kIntersection, kDifference };

/// Both closed and oriented outwards, without faces through themselves; exact but for the rounding of the
/// result to float. Throws std::runtime_error where the result is no 2-manifold.
TriMesh booleanOf(const TriMesh& a, const TriMesh& b, BooleanKind kind);

}  // namespace proveout
