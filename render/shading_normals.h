// Normals for shading: smooth over faces that meet at a small angle, sharp over edges.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout::render_detail {

/// Faces that meet at less than this are shaded as one surface: above what faceting of curved walls and
/// ball-end scallops gives on usual grids, below any edge that a drawing would show.
inline constexpr double kCreaseAngleDeg = 25.0;

/// Unit normal per triangle; zero for triangles without area.
std::vector<Eigen::Vector3f> faceNormals(const TriMesh& mesh);

/// Unit normal per corner of each triangle: mean of the normals of the faces around the vertex that lie
/// within kCreaseAngleDeg of the triangle's own, weighted by their angle at the vertex.
std::vector<std::array<Eigen::Vector3f, 3>> cornerNormals(const TriMesh& mesh,
                                                          const std::vector<Eigen::Vector3f>& faces);

/// Both of a mesh.
struct MeshNormals {
  explicit MeshNormals(const TriMesh& mesh) : faces(faceNormals(mesh)), corners(cornerNormals(mesh, faces)) {}
  std::vector<Eigen::Vector3f> faces;                   ///< by triangle
  std::vector<std::array<Eigen::Vector3f, 3>> corners;  ///< by corner of a triangle
};

}  // namespace proveout::render_detail
