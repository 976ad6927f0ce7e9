#include "core/mesh/cad_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// The corners of a triangle, the same wherever it begins.
using Corners = std::array<std::array<std::uint32_t, 3>, 3>;

Corners cornersOf(const TriMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  Corners out;
  for (std::size_t c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)  // 0 and -0 are one place
      out[c][static_cast<std::size_t>(k)] =
          std::bit_cast<std::uint32_t>(mesh.positions[triangle[c]][k] + 0.0f);
  std::sort(out.begin(), out.end());
  return out;
}

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::uint64_t h = 0x9E3779B97F4A7C15u;
    for (const auto& corner : corners)
      for (const std::uint32_t value : corner) h = (h ^ value) * 0xFF51AFD7ED558CCDu ^ h >> 29;
    return h;
  }
};

}  // namespace

double CadFace::distance(const Vec3& p) const {
  PROVEOUT_ASSERT(kind != SurfaceKind::kOther);
  const Vec3 from = p - origin;
  if (kind == SurfaceKind::kPlane) return from.dot(axis);
  const double along = from.dot(axis), across = (from - along * axis).norm();
  double out = 0.0;
  switch (kind) {
    case SurfaceKind::kCylinder:
      out = across - radius;
      break;
    case SurfaceKind::kCone:
      out = (across - radius) * std::cos(half_angle_rad) - along * std::sin(half_angle_rad);
      break;
    case SurfaceKind::kSphere:
      out = from.norm() - radius;
      break;
    default:
      out = std::hypot(across - radius, along) - tube_radius;
      break;
  }
  return hollow ? -out : out;
}

CadFace CadFace::placed(const MeshPlacement& placement) const {
  CadFace out = *this;
  out.origin = placement(origin);
  out.axis = placement.motion().rotation * axis;
  out.radius *= placement.scale;
  out.tube_radius *= placement.scale;
  return out;
}

CadFaces facesOf(const TriMesh& mesh, const TriMesh& source, CadFaces faces) {
  PROVEOUT_ASSERT(faces.of_triangle.size() == source.triangles.size());
  std::unordered_map<Corners, std::uint32_t, CornersHash> known;
  known.reserve(source.triangles.size());
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
    known.emplace(cornersOf(source, source.triangles[t]), faces.of_triangle[t]);
  faces.of_triangle.assign(mesh.triangles.size(), kNoFace);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto found = known.find(cornersOf(mesh, mesh.triangles[t]));
    if (found != known.end()) faces.of_triangle[t] = found->second;
  }
  return faces;
}

}  // namespace proveout
