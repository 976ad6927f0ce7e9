// The mesh as Embree sees it: moved to its centre and scaled to unit radius, so that float is exact enough
// for parts of any size and place.
//
// With a section a quarter of the part is not there. A ray then skips the stretch in which it is within the
// quarter; where it leaves the quarter it meets the cut face if the next triangle behind shows its back,
// since the point is then inside the solid.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"
#include "render/render.h"

namespace proveout::render_detail {

struct Hit {
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  ///< weights of the second and third corner
  float distance = 0;
  int cut_face = -1;  ///< 0 or 1: on the cut face across x or y, not on a triangle
};

/// Immutable after build(); queries may come from any thread.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;

  /// `mesh` has at least one triangle, valid indices and finite positions.
  static Result<RayScene> build(const TriMesh& mesh, const std::optional<SectionCut>& section);

  Eigen::Vector3f toUnit(const Vec3& p) const { return ((p - center_) / radius_).cast<float>(); }
  double radius() const { return radius_; }  ///< mm to one unit
  float floor() const { return floor_; }     ///< lowest z, units
  /// Unit normal of a cut face, out of the solid.
  const Eigen::Vector3f& cutNormal(int cut_face) const {
    return cut_normals_[static_cast<std::size_t>(cut_face)];
  }
  /// Whether the point (mm) is in the quarter that is cut away.
  bool cutAway(const Vec3& p) const;

  /// Nearest hit along a ray in units, or false.
  bool intersect(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, Hit& hit) const;
  bool occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 1.0;
  float floor_ = 0.0F;
  bool has_cut_ = false;
  Eigen::Vector3f cut_at_ = Eigen::Vector3f::Zero();  ///< a point of the axis, units
  std::array<Eigen::Vector3f, 2> cut_normals_;        ///< into the quarter

  /// Where a ray is within the quarter: from `enter` to `leave`, out of it through cut face `face`.
  struct CutSpan {
    float enter = 0, leave = 0;
    int face = -1;  ///< -1: the ray stays in it
  };
  bool cutSpan(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, CutSpan& span) const;
  bool nearest(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float from, float to,
               Hit& hit, bool& back_face) const;
  bool anyHit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float from, float to) const;
};

}  // namespace proveout::render_detail
