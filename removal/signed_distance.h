// Signed distance to a closed triangle mesh.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace proveout {

/// A triangle soup in double precision that shares vertices.
struct SurfaceMesh {
  std::vector<Vec3> points;                             ///< mm
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< CCW seen from outside
};

/// The nearest place of a surface.
struct SurfaceDistance {
  double distance = 0.0;  ///< mm; positive outside, negative inside
  Eigen::Vector3f gradient =
      Eigen::Vector3f::Zero();  ///< unit, of the signed distance; the normal where distance is 0
  std::uint32_t triangle = 0;   ///< that holds the nearest point
};

/// The sign comes from the normal of the nearest feature: of the face, of the two faces at an edge, or the
/// angle-weighted normal at a vertex, which is exact for closed manifolds (J. A. Baerentzen, H. Aanaes,
/// "Signed distance computation using the angle weighted pseudonormal", 2005). Where the normal is not to be
/// trusted (slivers, edges of more than two faces, nearly tangential directions) rays decide by majority.
class SignedDistance {
 public:
  /// `mesh` must outlive this, be closed and have proper triangles; at least one.
  explicit SignedDistance(const SurfaceMesh& mesh);
  ~SignedDistance();
  SignedDistance(const SignedDistance&) = delete;
  SignedDistance& operator=(const SignedDistance&) = delete;

  /// Distances of all points, in parallel. The result does not depend on the number of threads. Points that
  /// follow each other should lie near each other. Returns an empty vector where `progress` was cancelled.
  std::vector<SurfaceDistance> at(const std::vector<Vec3>& points, Progress& progress, double from,
                                  double to) const;

  /// By rays alone; for points not closer to the surface than rounding.
  bool inside(const Vec3& point) const;

  /// Triangles that a ray from `origin` meets; those that it touches at a border may be missing or counted
  /// twice.
  std::vector<std::uint32_t> crossings(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Three directions that no drawing uses, for rays that shall not run along faces.
const std::array<Vec3, 3>& oddDirections();

}  // namespace proveout
