// Places where sheets of surface touch.
//
// Where both cells of a face join its four crossings to one sheet each, two dual edges would coincide. So
// each gets a vertex of its own, and the quads around become fans about their crossings.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/surface/mesh/surface_quads.h"

namespace proveout {

struct FaceSplit {
  int after = 0;             ///< corner of the quad that it follows
  std::array<int, 7> key{};  ///< voxel of the face, its axis, voxel of the corner that is cut off
  Eigen::Vector3f p;         ///< mm
};

/// A quad with such faces; its middle becomes a vertex.
struct SplitQuad {
  std::array<std::uint32_t, 4> v;  ///< vertex numbers of the grid
  std::uint32_t motion = kNoMotion;
  Eigen::Vector3f middle;  ///< mm
  std::vector<FaceSplit> faces;
};

/// `quad` is the one around the edge (axis, x, y, z) of the leaf, with bits in `split`.
SplitQuad splitQuad(const SurfaceGrid& grid, const SurfaceLeaf& leaf, int axis, int x, int y, int z,
                    const Quad& quad, const Crossing& c);

}  // namespace proveout
