// A block less polyhedra, by the booleans of CGAL in exact arithmetic. All mm.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/grid/stock_shape.h"
#include "tests/reference/swept_polyhedron.h"

namespace proveout::reference {

class ReferencePart {
 public:
  explicit ReferencePart(const BoxShape& block);
  ~ReferencePart();
  ReferencePart(ReferencePart&&) noexcept;
  ReferencePart& operator=(ReferencePart&&) noexcept;

  /// False where the result is no 2-manifold, as where solids touch in an edge; the part is lost then.
  bool subtract(const Polyhedron& solid);
  double volume() const;

  struct Facet {
    std::array<Vec3, 3> corners;
    std::array<int, 3> vertices;
    std::array<int, 3> beside;  ///< facet behind the edge from corner i to the next
    Vec3 normal;                ///< unit, exact but for its last digits however thin the facet is
  };
  std::vector<Facet> facets() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Distances to segments, by a tree.
class DistanceToEdges {
 public:
  explicit DistanceToEdges(const std::vector<std::array<Vec3, 2>>& edges);
  ~DistanceToEdges();
  /// Infinite where there are none.
  double at(const Vec3& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proveout::reference
