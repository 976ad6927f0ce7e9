// Raster image handed from the renderer to the PNG writer.
#pragma once

#include <cstdint>
#include <vector>

namespace proveout {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3, sRGB, row 0 on top
};

}  // namespace proveout
