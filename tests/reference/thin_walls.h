// Walls and gaps of the part that booleans leave which are thinner than a grid can show. All mm.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/triangle_tree.h"
#include "tests/reference/reference_part.h"

namespace proveout::reference {

/// A wall is thin where the material behind a point of the surface ends within `thin` at a surface that faces
/// the other way, to 60 degrees; a gap where the next surface before it does. The tips of wedges are, too.
/// Found from the facets alone, where it is asked for.
class ThinWalls {
 public:
  ThinWalls(std::vector<ReferencePart::Facet> facets, double thin);

  /// Whether a wall or gap is thin within `within` of `p`.
  bool isNear(const Vec3& p, double within);

 private:
  const std::vector<Vec3>& placesOf(std::size_t facet);
  bool endsBehind(const Vec3& p, const Vec3& way, const Vec3& normal) const;

  std::vector<ReferencePart::Facet> facets_;
  TriangleTree tree_;
  double thin_;
  std::vector<std::optional<std::vector<Vec3>>> places_;  ///< of each facet, once they were asked for
};

}  // namespace proveout::reference
