// What all pictures of one mesh share.
#pragma once

#include "render/ray_scene.h"
#include "render/shading_normals.h"

namespace proveout {

class DrawnMesh {
 public:
  DrawnMesh(render_detail::RayScene rays, render_detail::MeshNormals normals)
      : rays_(std::move(rays)), normals_(std::move(normals)) {}
  const render_detail::RayScene& rays() const { return rays_; }
  const render_detail::MeshNormals& normals() const { return normals_; }

 private:
  render_detail::RayScene rays_;
  render_detail::MeshNormals normals_;
};

}  // namespace proveout
