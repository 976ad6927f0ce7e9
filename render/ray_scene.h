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
#include "render/scene.h"

namespace proveout::render_detail {

/// Rays that are traced together. Lanes whose `active` is 0 are left alone.
struct RayPack {
  static constexpr int kRays = 8;
  using Lane = std::array<float, kRays>;
  alignas(32) std::array<Lane, 3> origin{};     ///< x, y, z, units
  alignas(32) std::array<Lane, 3> direction{};  ///< unit vectors
  alignas(32) std::array<int, kRays> active{};  ///< -1 or 0, as Embree has it

  void set(int lane, const Eigen::Vector3f& from, const Eigen::Vector3f& towards) {
    const auto k = static_cast<std::size_t>(lane);
    for (int c = 0; c < 3; ++c) {
      origin[static_cast<std::size_t>(c)][k] = from[c];
      direction[static_cast<std::size_t>(c)][k] = towards[c];
    }
    active[k] = -1;
  }
};

struct Hit {
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  ///< weights of the second and third corner
  float distance = 0;
  int cut_face = -1;  ///< 0 or 1: on the cut face across x or y, not on a triangle
};

/// Immutable after build(); queries may come from any thread.
class RayScene {
 public:
  /// `mesh` has at least one triangle, valid indices and finite positions.
  static Result<RayScene> build(const TriMesh& mesh);
  /// The same mesh, without what `section` cuts away. Shares the search tree.
  RayScene cut(const SectionCut& section) const;

  Eigen::Vector3f toUnit(const Vec3& p) const { return ((p - center_) / radius_).cast<float>(); }
  double radius() const { return radius_; }  ///< mm to one unit
  float floor() const { return floor_; }     ///< lowest z, units
  /// Unit normal of a cut face, out of the solid.
  const Eigen::Vector3f& cutNormal(int cut_face) const {
    return cut_normals_[static_cast<std::size_t>(cut_face)];
  }
  /// Whether the point (mm) is in the quarter that is cut away.
  bool cutAway(const Vec3& p) const;

  /// Nearest hits along rays without end, units: one for each lane with a bit in the result.
  std::uint32_t intersect(const RayPack& rays, std::array<Hit, RayPack::kRays>& hits) const;
  /// Bits of the lanes that meet anything within `reach`, units.
  std::uint32_t occluded(const RayPack& rays, float reach) const;
  bool occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const;

 private:
  RayScene() = default;

  struct Impl;
  std::shared_ptr<const Impl> impl_;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 1.0;
  float floor_ = 0.0F;
  bool has_cut_ = false;
  Eigen::Vector3f cut_at_ = Eigen::Vector3f::Zero();  ///< a point of the axis, units
  std::array<Eigen::Vector3f, 2> cut_normals_ = {Eigen::Vector3f::Zero(),
                                                 Eigen::Vector3f::Zero()};  ///< into the quarter

  /// Where a ray is within the quarter: from `enter` to `leave`, out of it through cut face `face`.
  struct CutSpan {
    float enter = 0, leave = 0;
    int face = -1;  ///< -1: the ray stays in it
  };
  bool cutSpan(const RayPack& rays, std::size_t lane, CutSpan& span) const;

  using Lanes = std::array<float, RayPack::kRays>;
  /// Rays without what they run through the quarter: up to `to` for the lanes of `first`, then from `behind`
  /// for those of `second`.
  struct Stretches {
    std::uint32_t first, second;
    Lanes to, behind;
    std::array<CutSpan, RayPack::kRays> spans;
  };
  Stretches split(const RayPack& rays, float reach) const;
  /// Those of the rays' lanes with a bit in `lanes`, from `from` to `to` along them. Bits of `back`: the hit
  /// triangle shows its back.
  std::uint32_t nearest(const RayPack& rays, std::uint32_t lanes, const Lanes& from, const Lanes& to,
                        std::array<Hit, RayPack::kRays>& hits, std::uint32_t& back) const;
  std::uint32_t anyHit(const RayPack& rays, std::uint32_t lanes, const Lanes& from, const Lanes& to) const;
};

}  // namespace proveout::render_detail
