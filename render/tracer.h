// From rays to pixels, a band of rows after the other.
//
// 1. One ray through the middle of every pixel finds what it shows (Seen).
// 2. Every second pixel of every second row takes one ray towards the key light and one to the sky.
// Neighbours
//    take other points of the lights, the same ones again after kPattern pixels; averaged over such a square
//    of one smooth surface, every point of the lights counts once and there is no noise.
// 3. Where a pixel shows another surface than the next one, more rays find what its parts show. Each part
// takes
//    the light of its own surface, so that corners inside do not darken what is beside them.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/image.h"
#include "render/surfaces.h"

namespace proveout::render_detail {

/// What the tracer reads; all must outlive the call.
struct TraceInput {
  const RenderScene& scene;
  const RayScene& rays;
  const MeshNormals& normals;
  Camera camera;
  ImageSize size;
  RenderOptions options;
};

/// The part on its background, without annotations. Runs in the caller's TBB arena.
Result<Image> trace(const TraceInput& input, Progress& progress);

}  // namespace proveout::render_detail
