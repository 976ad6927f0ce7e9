// A triangle mesh in double precision.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Triangles that share vertices.
struct SurfaceMesh {
  std::vector<Vec3> points;                             ///< mm
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< CCW seen from outside

  /// Twice the area of a triangle along its normal, mm2.
  Vec3 areaVector(std::size_t t) const {
    const Vec3 &a = points[triangles[t][0]], &b = points[triangles[t][1]], &c = points[triangles[t][2]];
    return (b - a).cross(c - a);
  }
  Vec3 middle(std::size_t t) const {
    return (points[triangles[t][0]] + points[triangles[t][1]] + points[triangles[t][2]]) / 3.0;
  }
};

inline SurfaceMesh toSurface(const TriMesh& mesh) {
  SurfaceMesh out;
  out.points.reserve(mesh.positions.size());
  for (const auto& p : mesh.positions) out.points.push_back(p.cast<double>());
  out.triangles = mesh.triangles;
  return out;
}

}  // namespace proveout
