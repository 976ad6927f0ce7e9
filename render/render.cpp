#include "render/render.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "render/annotations.h"
#include "render/drawn_mesh.h"
#include "render/tracer.h"

namespace proveout {
namespace {

using render_detail::PageLayout;
using render_detail::RayScene;

constexpr int kMaxSamples = 64;
constexpr ImageSize kLeastAnnotated{160, 120};

Status checkMesh(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return inputError("the mesh has no triangles: there is nothing to draw");
  for (const Eigen::Vector3f& p : mesh.positions) {
    if (!p.allFinite()) return inputError("the mesh has a position that is not a finite number");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      if (v >= mesh.positions.size()) return inputError("the mesh has a triangle with an index out of range");
    }
  }
  return Done{};
}

Status checkScene(const RenderScene& scene, ImageSize size, const RenderOptions& options) {
  if (Status ok = validateImageSize(size); !ok) return ok;
  if (options.samples < 1 || options.samples > kMaxSamples) {
    return inputError(
        fmt::format("{} samples a pixel are out of range: 1 to {}", options.samples, kMaxSamples));
  }
  if (Status ok = checkMesh(scene.mesh); !ok) return ok;
  const ScalarField& field = scene.field;
  const bool per_vertex = field.per == ScalarField::Per::kVertex;
  const std::size_t expected = per_vertex ? scene.mesh.positions.size() : scene.mesh.triangles.size();
  if (!field.values.empty() && field.values.size() != expected) {
    return inputError(fmt::format("the heat map has {} values for {} {}", field.values.size(), expected,
                                  per_vertex ? "vertices" : "triangles"));
  }
  const DeviationScale& scale = field.scale;
  if (!field.values.empty() && !(scale.gouge > 0 && scale.excess > 0 && std::isfinite(scale.limit) &&
                                 scale.limit > std::max(scale.gouge, scale.excess))) {
    return inputError("the heat map's scale needs tolerances above 0 and a limit above them");
  }
  if (scene.show_legend && field.values.empty()) return inputError("a legend needs a heat map");
  if (!scene.triangle_colors.empty() && scene.triangle_colors.size() != scene.mesh.triangles.size()) {
    return inputError(fmt::format("there are {} colours for {} triangles", scene.triangle_colors.size(),
                                  scene.mesh.triangles.size()));
  }
  const bool annotated = scene.show_legend || !scene.markers.empty() || !scene.caption.empty();
  if (annotated && (size.width < kLeastAnnotated.width || size.height < kLeastAnnotated.height)) {
    return inputError(fmt::format("a picture with legend, findings or caption needs at least {}x{} pixels",
                                  kLeastAnnotated.width, kLeastAnnotated.height));
  }
  if (const auto& cut = scene.section;
      cut && !(cut->axis.allFinite() && std::abs(cut->side_x) == 1 && std::abs(cut->side_y) == 1)) {
    return inputError("a section needs an axis of finite numbers and sides of 1 or -1");
  }
  for (const Marker& marker : scene.markers) {
    if (!marker.at.allFinite())
      return inputError("a finding to draw has a place that is not a finite number");
  }
  return Done{};
}

std::optional<SectionCut> sectionOf(const RenderScene& scene, const View& view) {
  if (scene.section || !view.section) return scene.section;
  const Vec3 middle = meshBounds(scene.mesh).center();
  return SectionCut{Vec2(middle.x(), middle.y()), view.back.x() < 0 ? -1 : 1, view.back.y() < 0 ? -1 : 1};
}

Result<std::shared_ptr<const DrawnMesh>> drawnMesh(const TriMesh& mesh) {
  // One thread builds the tree (see RayScene): the normals are found beside it.
  std::optional<Result<RayScene>> rays;
  std::optional<render_detail::MeshNormals> normals;
  parallelFor(0, 2, [&](int part) {
    if (part == 0) {
      rays.emplace(RayScene::build(mesh));
    } else {
      normals.emplace(mesh);
    }
  });
  if (!*rays) return rays->error();
  return std::shared_ptr<const DrawnMesh>(
      std::make_shared<DrawnMesh>(std::move(**rays), std::move(*normals)));
}

/// Calls `work` on so many threads, 0: all cores.
template <typename Work>
auto onThreads(int threads, const Work& work) {
  // Embree limits TBB to the cores there are and would complain of a larger arena.
  const int cores = tbb::info::default_concurrency();
  return tbb::task_arena(threads > 0 ? std::min(threads, cores) : cores).execute(work);
}

/// The mesh as the view's section leaves it.
RayScene raysOf(const RenderScene& scene, const View& view, const DrawnMesh& drawn) {
  const std::optional<SectionCut> section = sectionOf(scene, view);
  return section ? drawn.rays().cut(*section) : drawn.rays();
}

Result<std::shared_ptr<const DrawnMesh>> drawnMeshOf(const RenderScene& scene) {
  if (scene.drawn) return scene.drawn;
  return drawnMesh(scene.mesh);
}

Result<Image> drawPart(const RenderScene& scene, const DrawnMesh& drawn, const View& view, ImageSize size,
                       const RenderOptions& options, Progress& progress) {
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted while drawing"};
  PROVEOUT_ASSERT(drawn.normals().faces.size() == scene.mesh.triangles.size());
  const RayScene rays = raysOf(scene, view, drawn);
  const Camera camera = sceneCamera(scene, view, size);
  return render_detail::trace({scene, rays, drawn.normals(), camera, size, options}, progress);
}

void drawOver(const RenderScene& scene, const DrawnMesh& drawn, const View& view, Image& image) {
  const RayScene rays = raysOf(scene, view, drawn);
  const ImageSize size{image.width, image.height};
  const Camera camera = sceneCamera(scene, view, size);
  const Eigen::Vector3f back = camera.back.cast<float>();
  const auto visible = [&](const Vec3& p) {
    constexpr float kSlack =
        0.01F;  // a finding lies on the nominal or in the middle of a patch, not on this mesh
    return !rays.cutAway(p) && !rays.occluded(rays.toUnit(p) + back * kSlack, back, 4.0F);
  };
  render_detail::drawAnnotations(scene, render_detail::layoutPage(scene, size), camera, visible, image);
}

}  // namespace

Camera sceneCamera(const RenderScene& scene, const View& view, ImageSize size) {
  const PixelRect part = render_detail::layoutPage(scene, size).part;
  Camera camera = fitCamera(scene.mesh, view, part);
  if (scene.focus) {
    // The target stays in its plane across the line of sight: what is traced begins before the part.
    const Vec3 aside = scene.focus->at - camera.target;
    camera.target += camera.right * aside.dot(camera.right) + camera.up * aside.dot(camera.up);
    camera.mm_per_pixel = std::min(camera.mm_per_pixel, scene.focus->width_mm / part.width());
  }
  return camera;
}

Result<std::shared_ptr<const DrawnMesh>> prepareDrawing(const TriMesh& mesh, int threads) {
  if (const Status ok = checkMesh(mesh); !ok) return ok.error();
  return onThreads(threads, [&] { return drawnMesh(mesh); });
}

Result<Image> renderPart(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress) {
  if (const Status ok = checkScene(scene, size, options); !ok) return ok.error();
  return onThreads(options.threads, [&]() -> Result<Image> {
    const auto drawn = drawnMeshOf(scene);
    if (!drawn) return drawn.error();
    return drawPart(scene, **drawn, view, size, options, progress);
  });
}

Status annotate(const RenderScene& scene, const View& view, Image& image) {
  if (const Status ok = checkScene(scene, {image.width, image.height}, {}); !ok) return ok;
  const auto drawn = drawnMeshOf(scene);
  if (!drawn) return drawn.error();
  drawOver(scene, **drawn, view, image);
  return Done{};
}

Result<Image> renderMesh(const RenderScene& scene, const View& view, ImageSize size,
                         const RenderOptions& options, Progress& progress) {
  if (const Status ok = checkScene(scene, size, options); !ok) return ok.error();
  return onThreads(options.threads, [&]() -> Result<Image> {
    const auto drawn = drawnMeshOf(scene);
    if (!drawn) return drawn.error();
    Result<Image> image = drawPart(scene, **drawn, view, size, options, progress);
    if (image) drawOver(scene, **drawn, view, *image);
    return image;
  });
}

}  // namespace proveout
