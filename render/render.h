// Headless pictures of a part: ray traced with a soft key light, ambient occlusion and a ground shadow;
// optionally coloured by deviation, with a legend, numbered findings and a caption.
//
// The same scene, view, size and options give the same bytes for any number of threads.
#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/image.h"
#include "core/mesh/tri_mesh.h"
#include "render/camera.h"
#include "render/scene.h"

namespace proveout {

/// Of a mesh that several pictures show. `threads` as in RenderOptions. Errors as of renderMesh.
Result<std::shared_ptr<const DrawnMesh>> prepareDrawing(const TriMesh& mesh, int threads);

/// Draws the scene. Errors (kInput): empty mesh, positions that are not finite, indices out of range, fields
/// of the wrong length, a section without a quarter, samples or size out of range, annotations on a picture
/// below 160 x 120. kInterrupted when cancelled.
Result<Image> renderMesh(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress);

/// The two halves of renderMesh, for pictures of one view that differ in their annotations alone: the part
/// without legend, markers and caption, at the place that the scene leaves for it, and these over a picture
/// of a scene with the same mesh, section, legend and room. Errors as of renderMesh.
Result<Image> renderPart(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress);
Status annotate(const RenderScene& scene, const View& view, Image& image);

/// The camera that renderMesh uses for this scene, to find where a point of the part lies in the picture.
Camera sceneCamera(const RenderScene& scene, const View& view, ImageSize size);

}  // namespace proveout
