// PNG pictures.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/mesh/image.h"

namespace proveout {

/// Encodes as 8-bit sRGB PNG. The bytes depend on the picture alone: no time stamp. Error: empty or
/// inconsistent image.
Result<std::string> encodePng(const Image& image);
/// Encodes and writes; whole file or none.
Status writePng(const Image& image, const std::string& path);

}  // namespace proveout
