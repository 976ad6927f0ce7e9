// A picture by many rays, each held against every triangle in double: slow, without search tree, grid of
// light or filter. What the renderer draws is to look like it.
#pragma once

#include <array>
#include <vector>

#include "render/render.h"

namespace proveout::test {

struct SlowPixel {
  int x = 0, y = 0;
  std::array<int, 3> color{};  ///< sRGB bytes
};

/// Pixels of a picture of the scene's mesh alone, in the part's own colour: no field, tints, section or
/// annotations. `step_x`, `step_y`: one pixel of so many is drawn, in steps of the picture's rows and
/// columns. `samples`: rays from the camera through a pixel, each with one to the key light and one to the
/// sky.
std::vector<SlowPixel> slowPixels(const RenderScene& scene, const View& view, ImageSize size, int step_x,
                                  int step_y, int samples);

}  // namespace proveout::test
