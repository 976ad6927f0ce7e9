// Triangle mesh, mm.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

struct TriMesh {
  std::vector<Eigen::Vector3f> positions;               ///< mm, workpiece frame
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions, CCW seen from outside
  /// Motion that made the triangle's surface, kNoMotion where it is the blank's own. Empty or one per
  /// triangle.
  std::vector<std::uint32_t> motion;
};

/// What a mesh is topologically. Edges are judged by vertex index.
struct MeshTopology {
  std::size_t boundary_edges = 0;         ///< used by one triangle only
  std::size_t non_manifold_edges = 0;     ///< used by more than two triangles
  std::size_t misoriented_edges = 0;      ///< used by two triangles in the same direction
  std::size_t non_manifold_vertices = 0;  ///< whose triangles form more than one fan
  std::size_t degenerate_triangles = 0;   ///< with two equal indices, or an index out of range
  std::size_t non_finite_positions = 0;
  std::size_t components = 0;        ///< connected through shared edges
  Vec3 first_defect = Vec3::Zero();  ///< a place of the first defect, where `closedManifold()` is false
  bool closedManifold() const {
    return boundary_edges + non_manifold_edges + misoriented_edges + non_manifold_vertices +
               degenerate_triangles + non_finite_positions ==
           0;
  }
};
MeshTopology analyseTopology(const TriMesh& mesh);

/// Volume enclosed by a closed mesh, mm3 (divergence theorem; positive for outward orientation).
double meshVolume(const TriMesh& mesh);
/// Bounds and enclosed volume of a closed mesh in one go; the volume of an empty one is 0.
struct MeshExtent {
  Box3 bounds;
  double volume_mm3 = 0.0;
};
MeshExtent meshExtent(const TriMesh& mesh);
/// Surface area, mm2.
double meshArea(const TriMesh& mesh);
Box3 meshBounds(const TriMesh& mesh);
/// Component number of every triangle (connected through shared edges), numbered by first triangle.
std::vector<std::uint32_t> meshComponents(const TriMesh& mesh, std::uint32_t& count);

/// Merges positions that are equal bit for bit (-0 = 0) and drops triangles that collapse. STL needs it.
TriMesh weldVertices(const TriMesh& mesh);

}  // namespace proveout
