// Legend, numbered findings and caption, drawn over the traced picture.
#pragma once

#include <functional>

#include "render/canvas.h"
#include "render/scene.h"

namespace proveout::render_detail {

/// Where things go; pixels.
struct PageLayout {
  double cell = 1.0;         ///< dot of the font
  double legend_cell = 1.0;  ///< of the legend, which reports show at half their width
  PixelRect part;            ///< the part is fitted into it
  PixelRect bar;             ///< colour bar of the legend
  Vec2 caption = Vec2::Zero();
};
PageLayout layoutPage(const RenderScene& scene, ImageSize size);

/// `visible(p)` tells whether the camera sees the point; hidden findings are drawn hollow.
void drawAnnotations(const RenderScene& scene, const PageLayout& page, const Camera& camera,
                     const std::function<bool(const Vec3&)>& visible, Image& image);

}  // namespace proveout::render_detail
