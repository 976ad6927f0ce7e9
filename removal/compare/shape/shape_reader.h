// The heights of curved faces over the facets of a mesh. Internal to NominalShape.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/surface_mesh.h"

namespace proveout::shape_detail {

/// What is read of a mesh, per triangle.
struct ShapeReading {
  std::vector<std::array<float, 6>> bulge;  ///< see NominalShape
  std::vector<float> doubt;                 ///< empty: there is none
  std::vector<float> misfit;                ///< by how much neighbours leave what is read; empty: all is flat
};

ShapeReading readShape(const SurfaceMesh& mesh);

}  // namespace proveout::shape_detail
