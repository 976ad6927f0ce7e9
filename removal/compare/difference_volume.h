// What lies between two closed surfaces, counted in columns.
#pragma once

#include <vector>

#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "removal/compare/comparison.h"

namespace proveout {

/// A closed surface and its tree.
struct TreedSurface {
  const SurfaceMesh* mesh;
  const TriangleTree* tree;
};

/// Volume, mm3, of the pieces of "machined without nominal" (excess) or "nominal without machined" (gouge)
/// that the `places` lie on: in columns along each axis in turn, of which those count that hit most; good to
/// some tenths of a per cent. `bounds`: of the places at least; the pieces may reach further. Layers thinner
/// than `least_mm` along a column are left out, so that pieces do not hang together by them.
double differenceVolume(const TreedSurface& machined, const TreedSurface& nominal, DeviationKind kind,
                        const Box3& bounds, const std::vector<Vec3>& places, double least_mm);

}  // namespace proveout
