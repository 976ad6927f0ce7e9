// What a ray from the camera sees: the surface that it meets and its colour.
#pragma once

#include <array>
#include <vector>

#include "render/ray_scene.h"
#include "render/camera.h"
#include "render/scene.h"
#include "render/shading_normals.h"
#include "render/srgb.h"

namespace proveout::render_detail {

struct Seen {
  enum class What : std::uint8_t { kNothing, kGround, kPart } what = What::kNothing;
  Eigen::Vector3f point = Eigen::Vector3f::Zero();   ///< units
  Eigen::Vector3f face = Eigen::Vector3f::Zero();    ///< unit normal of the triangle, to the viewer
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, for shading
  Eigen::Vector3f color = Eigen::Vector3f::Zero();   ///< linear
  bool hatched = false;                              ///< a cut face: its colour is drawn, not measured
};

class Surfaces {
 public:
  /// All must outlive it.
  Surfaces(const RenderScene& scene, const RayScene& rays, const MeshNormals& normals, const Camera& camera);

  /// The surface of the part at a hit. `known`: seen beside it; its deviation is taken if it is of the same
  /// face. Null: nothing is known.
  Seen at(const Eigen::Vector3f& point, const Hit& hit, const Seen* known) const;

 private:
  Eigen::Vector3f hatch(const Eigen::Vector3f& point, int cut_face) const;
  Eigen::Vector3f colorOf(const Hit& hit, const Eigen::Vector3f& face, const Seen* known) const;
  bool linearOver(const std::array<std::uint32_t, 3>& t) const;

  const RenderScene& scene_;
  const RayScene& rays_;
  const MeshNormals& normals_;
  const Eigen::Vector3f back_;
  const float pixel_;  ///< units
  const SrgbTable srgb_;
  const Eigen::Vector3f cut_color_, part_color_;
};

}  // namespace proveout::render_detail
