// The size of a mesh's triangles.
#pragma once

#include <cstddef>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Mean length of some of the edges, mm; 0 without triangles.
inline double meanEdge(const TriMesh& mesh) {
  constexpr std::size_t kEach = 64;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += kEach, ++count)
    sum += (mesh.positions[mesh.triangles[t][0]] - mesh.positions[mesh.triangles[t][1]]).norm();
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace proveout
