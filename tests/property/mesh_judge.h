// A mesh judged by CGAL, which knows nothing of the engine.
#pragma once

#include <cstddef>
#include <string>

#include "core/mesh/tri_mesh.h"

namespace proveout::test {

struct MeshVerdict {
  bool manifold = false;     ///< CGAL takes the triangles for a valid 2-manifold; else nothing more is known
  bool closed = false;       ///< without border
  std::size_t meetings = 0;  ///< pairs of triangles that run through each other
  std::string places;        ///< of some of them, mm
};

MeshVerdict judgeMesh(const TriMesh& mesh);

}  // namespace proveout::test
