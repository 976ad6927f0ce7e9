// Checks of a mesh around some of its vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

inline constexpr std::uint32_t kNoWatch = 0xFFFFFFFFu;

/// For each vertex whose `name` is not kNoWatch: whether its triangles form one closed fan. Adds the names of
/// those that do not to `broken`, in the order of the vertices, and the names of their neighbours with more
/// than two triangles on the common edge.
void findBrokenFans(const TriMesh& mesh, const std::vector<std::uint32_t>& name,
                    std::vector<std::uint32_t>& broken);

}  // namespace proveout
