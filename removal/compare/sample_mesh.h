// A mesh with enough vertices on its large triangles to be sampled at its vertices alone.
#pragma once

#include "core/mesh/signed_distance.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

struct SampleMesh {
  SurfaceMesh surface;                ///< the vertices of the source come first, in their order
  std::vector<std::uint32_t> parent;  ///< per triangle: the triangle of the source that it is a part of
  double spacing_mm = 0.0;            ///< distance between points, about
};

/// Puts points on edges longer than `spacing_mm` and into triangles, so that every place of the surface has
/// one within about that distance; neighbours stay joined. The spacing is widened as far as needed to stay
/// below about `max_triangles`, or four times what the source has, whichever is more.
SampleMesh makeSampleMesh(const TriMesh& mesh, double spacing_mm, std::size_t max_triangles);

}  // namespace proveout
