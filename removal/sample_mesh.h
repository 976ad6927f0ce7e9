// A mesh with enough vertices on its large triangles to be sampled at its vertices alone.
#pragma once

#include "core/mesh/tri_mesh.h"
#include "removal/signed_distance.h"

namespace proveout {

struct SampleMesh {
  SurfaceMesh surface;                ///< the vertices of the source come first, in their order
  std::vector<std::uint32_t> parent;  ///< per triangle: the triangle of the source that it is a part of
  double spacing_mm = 0.0;            ///< no edge is longer
};

/// Splits edges longer than `spacing_mm` at their middle until none is left; neighbours stay joined. The
/// spacing is widened as far as needed to stay below about `max_triangles` (more only where the source itself
/// has more).
SampleMesh makeSampleMesh(const TriMesh& mesh, double spacing_mm, std::size_t max_triangles);

}  // namespace proveout
