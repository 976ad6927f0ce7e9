// Straight edges of a plane that meet where they should not.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// Of a loop or of a mesh, as it holds it: corners are floats.
struct PlaneSegment {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< mm
  std::uint32_t start = 0, end = 0;             ///< numbers of the corners: what has one is joined there
};

/// Pairs of edges that cross or touch elsewhere than in a corner that they share, or lie on each other from
/// there; the lower number first, in order. Fast where edges with following numbers are close together.
std::vector<std::array<std::uint32_t, 2>> meetingSegments(const std::vector<PlaneSegment>& segments);

}  // namespace proveout
