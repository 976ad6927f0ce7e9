// Cracks in a mesh: borders of its facets that face each other across next to nothing.
#pragma once

#include <cstddef>
#include <string>

#include "core/mesh/tri_mesh.h"

namespace proveout {

/// What the open edges of a mesh are.
struct BorderGaps {
  std::size_t crack_edges = 0;  ///< another border runs along them, no farther off than kWidestCrackMm
  std::size_t hole_edges = 0;   ///< the others
  double width_mm = 0.0;        ///< of the cracks: the largest distance between borders that face each other
  Vec3 widest = Vec3::Zero();   ///< where that is, mm
  Vec3 first_hole = Vec3::Zero();  ///< the middle of the first edge of a hole, mm
  bool onlyCracks() const { return crack_edges > 0 && hole_edges == 0; }
};

/// Wider ones are holes, mm; in a mesh smaller than a hundred times that those wider than a hundredth of it.
inline constexpr double kWidestCrackMm = 0.05;

/// Edges that other than one or two facets use count as holes where their number is odd.
BorderGaps findBorderGaps(const TriMesh& mesh);

/// "cracks of up to 0.0002 mm, the widest at X..". Widths have one digit.
std::string crackText(const BorderGaps& gaps);

/// What was done to close cracks.
struct CrackRepair {
  std::size_t merged = 0;  ///< vertices
  std::size_t split = 0;   ///< facets, at vertices of others that lie on their edges
};

/// Merges border vertices within `reach` mm of each other, and splits facets at border vertices that lie as
/// near to their border edges. Facets that collapse are dropped. Whether that closed the mesh is not judged.
CrackRepair closeCracks(TriMesh& mesh, double reach);

}  // namespace proveout
