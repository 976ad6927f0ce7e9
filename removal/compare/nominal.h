// Checks that both meshes of a comparison pass.
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// An edge that does not bound a solid: not used as often one way as the other.
struct OpenEdges {
  std::size_t odd = 0;        ///< used an odd number of times: a hole, or a wall without thickness
  std::size_t opposed = 0;    ///< used an even number of times, but with mixed orientation
  Vec3 first = Vec3::Zero();  ///< the middle of the first of them, odd ones first
  bool closed() const { return odd + opposed == 0; }
};
OpenEdges findOpenEdges(const TriMesh& mesh);

/// What makes a mesh unusable before its edges are looked at: empty, not finite, beyond 1 km, bad index, two
/// equal indices.
std::optional<Error> findBadElements(const TriMesh& mesh, const std::string& name);

}  // namespace proveout
