// Gaps between bodies whose faces stand next to each other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {

/// Faces of two bodies that face each other across air.
struct BodyGap {
  double width_mm = 0.0;              ///< the largest between them
  Vec3 where = Vec3::Zero();          ///< where that is, mm
  std::vector<std::uint32_t> facets;  ///< of the first body, in order
  double area_mm2 = 0.0;              ///< of these facets
};

/// Facets of `body` with one of `other` in front of them, no farther off than `reach` mm and facing them,
/// within 25 degrees. None where there are no such.
std::optional<BodyGap> findGap(const SurfaceMesh& body, const TriangleTree& body_tree,
                               const SurfaceMesh& other, const TriangleTree& other_tree, double reach);

/// Moves the facets by `by_mm` along their normals; what they share corners with follows.
TriMesh withFacetsMoved(const TriMesh& mesh, const std::vector<std::uint32_t>& facets, double by_mm);

}  // namespace proveout
