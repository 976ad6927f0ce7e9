// Whether a piece that a leaning wire cut free can leave.
#pragma once

#include <cstddef>

#include "removal/wire/lean/lean_solid.h"

namespace proveout {

/// Straight along Z, without a turn. What an upright wire cuts goes both ways.
struct BodyExit {
  bool down = true, up = true;
};

/// Of a body of one solid past one of the same or another one of the same blank, by the sections at up to
/// nine heights: what overlaps by less than 0.001 mm passes.
BodyExit exitOf(const LeanSolid& solid, std::size_t body, const LeanSolid& past_solid, std::size_t past);

}  // namespace proveout
