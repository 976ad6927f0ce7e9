// The pairs of triangles that intersect, in a group whose triangles change.
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "core/mesh/intersections.h"
#include "core/mesh/mesh_editor.h"
#include "removal/surface/repair/repair_regions.h"

namespace proveout {

class IntersectingPairs {
 public:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  /// A triangle beside others.
  struct Near {
    std::uint32_t triangle = 0;
    Box3 box;
  };

  /// `reach_mm`: how far triangles may change beyond what they take up. `seen`: one a triangle of the mesh, 0
  /// at first; shared by all groups. All must outlive this.
  IntersectingPairs(const MeshEditor& edit, const RepairBlocks& blocks, double reach_mm,
                    const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& seen);

  /// To be called for each triangle whose change is kept.
  void insert(std::uint32_t t);
  /// Sets near() to the triangles that are near these but not among them.
  void findNear(const std::vector<std::uint32_t>& triangles);
  const std::vector<Near>& near() const { return near_; }
  /// The number of pairs with one of these triangles, counted up to the first beyond `most`; sets near().
  std::size_t find(const std::vector<std::uint32_t>& triangles, std::size_t most,
                   std::vector<TrianglePair>* found = nullptr);
  /// Whether two triangles intersect, or the triangle of a pair with itself is a needle.
  bool meets(const TrianglePair& pair) const;
  /// All pairs of these triangles, ascending as they are.
  std::vector<TrianglePair> among(const std::vector<std::uint32_t>& triangles);

 private:
  std::array<Vec3, 3> points(std::uint32_t t) const { return cornersOf(edit_.mesh(), t); }

  const MeshEditor& edit_;
  const RepairBlocks& space_;
  double reach_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> blocks_;
  std::vector<std::uint32_t>& seen_;  ///< number of the last search that met a triangle
  std::uint32_t search_ = 0;
  std::vector<Near> near_;
};

}  // namespace proveout
