// From rays to pixels.
//
// Every pixel takes `samples` rays; each hit takes one shadow ray towards a disc of light and one occlusion
// ray. What is smooth by nature (the share of light that arrives, the share of sky seen) is then averaged
// over the neighbouring pixels that show the same smooth surface, which removes the noise; colour and the
// angle to the light stay per pixel, so edges and texture stay sharp.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/image.h"
#include "render/ray_scene.h"
#include "render/render.h"

namespace proveout::render_detail {

/// What the tracer reads; all must outlive the call.
struct TraceInput {
  const RenderScene& scene;
  const RayScene& rays;
  const std::vector<Eigen::Vector3f>& faces;
  const std::vector<std::array<Eigen::Vector3f, 3>>& corners;
  Camera camera;
  ImageSize size;
  RenderOptions options;
};

/// The part on its background, without annotations. Runs in the caller's TBB arena.
Result<Image> trace(const TraceInput& input, Progress& progress);

}  // namespace proveout::render_detail
