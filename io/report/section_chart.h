// Drawings of level sections.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// Closed polygons of one body; every second region is material.
using SectionPolygons = std::vector<std::vector<Vec2>>;

/// An SVG file in true size, mm, x to the right and y up: the part, and pieces beside it in a lighter tone.
/// Empty where there is nothing to draw. `title`: any text.
std::string sectionSvgFile(const std::string& title, const SectionPolygons& part,
                           const std::vector<SectionPolygons>& pieces);

}  // namespace proveout
