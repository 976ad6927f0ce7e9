// How deep a piece that a tool meets lies in a half section.
#pragma once

#include <vector>

#include "removal/turning/section/section_area.h"

namespace proveout {

struct SectionDepth {
  double depth_mm = 0.0;   ///< distance to the nearest edge of the area
  Vec2 at = Vec2::Zero();  ///< (r, z), mm
};

/// The point of a piece of `area` that lies deepest in it. `outline`: closed, at least three points. The
/// depth is exact where a corner of the piece is the deepest point, else to kSectionDepthMm.
SectionDepth deepestPoint(const SectionArea& area, const std::vector<Vec2>& outline);
inline constexpr double kSectionDepthMm = 5e-4;

/// How deep a tool that takes the piece `outline` of the area goes into it: the deepest point that it
/// reaches, or, where it cuts off what is thin, the farthest that material is from the surface that is left.
SectionDepth contactDepth(const SectionArea& area, const std::vector<Vec2>& outline);

}  // namespace proveout
