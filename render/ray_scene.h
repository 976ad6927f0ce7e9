// The mesh as Embree sees it: moved to its centre and scaled to unit radius, so that float is exact enough
// for parts of any size and place.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout::render_detail {

struct Hit {
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  ///< weights of the second and third corner
  float distance = 0;
};

/// Immutable after build(); queries may come from any thread.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;

  /// `mesh` has at least one triangle, valid indices and finite positions.
  static Result<RayScene> build(const TriMesh& mesh);

  Eigen::Vector3f toUnit(const Vec3& p) const { return ((p - center_) / radius_).cast<float>(); }
  double radius() const { return radius_; }  ///< mm to one unit
  float floor() const { return floor_; }     ///< lowest z, units

  /// Nearest hit along a ray in units, or false.
  bool intersect(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, Hit& hit) const;
  bool occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 1.0;
  float floor_ = 0.0F;
};

}  // namespace proveout::render_detail
