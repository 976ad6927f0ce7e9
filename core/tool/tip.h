// Where the tip of a lathe tool lies, as tables of tools count it.
#pragma once

#include <algorithm>

#include "core/geometry/types.h"

namespace proveout {

/// (x, z): -1, 0 or 1 each, from the nose centre to the touch-off point of an orientation of 1 to 8; zero of
/// others, of which 0 and 9 mean the centre itself.
inline Vec2 tipDirection(int orientation) {
  constexpr int kTips[10][2] = {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1},
                                {0, 1}, {1, 0}, {0, -1}, {-1, 0},  {0, 0}};
  const auto& tip = kTips[std::clamp(orientation, 0, 9)];
  return {tip[0], tip[1]};
}

}  // namespace proveout
