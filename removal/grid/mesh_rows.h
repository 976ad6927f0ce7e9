// Where the lines of a grid meet a closed mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"
#include "removal/grid/coord.h"
#include "removal/grid/leaf_bits.h"

namespace proveout {

/// All lines of a grid along the axes, each with its meetings with the mesh in order. Whether a sample is
/// inside is the parity of what its line along z meets below it, so that gaps of the mesh count down to
/// single samples.
class MeshRows {
 public:
  /// `origin`: of voxel (0, 0, 0), mm; `h`: spacing, mm. The mesh must be closed and outlive this.
  MeshRows(const TriMesh& mesh, const Vec3& origin, double h);

  struct Meeting {
    double at;  ///< along the axis, in voxels
    std::uint32_t triangle;
  };
  /// Samples inside, of the leaf whose first sample is `first`.
  LeafBits material(const Coord& first) const;
  /// On the edge from `start` to the next sample along the axis, the meeting nearest to that end, or null.
  const Meeting* onEdge(const Coord& start, int axis, bool nearest_to_start) const;
  /// Unit, outwards.
  Vec3 normal(std::uint32_t triangle) const;

 private:
  /// Lines along one axis, by their voxel along the two others.
  struct Rows {
    int first_u = 0, first_v = 0, count_u = 0, count_v = 0;
    std::vector<std::uint32_t> start;  ///< of each line in `meetings`, one more than lines
    std::vector<Meeting> meetings;
    std::span<const Meeting> line(int u, int v) const;
  };
  Rows rowsAlong(int axis) const;

  const TriMesh& mesh_;
  std::vector<Vec3> points_;  ///< of the mesh, in voxels
  std::array<Rows, 3> rows_;
};

}  // namespace proveout
