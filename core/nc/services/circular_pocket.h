// A round pocket milled in circles from its centre. Knows of no control; plane coordinates about the centre
// of the pocket, mm.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// A line or arc of the tool's centre; it begins where the one before ended.
struct PocketMove {
  enum class Kind : std::uint8_t {
    kLine,
    kArc,
    kOver  ///< out of the material, across, and down again
  };
  Kind kind = Kind::kLine;
  Vec2 to = Vec2::Zero();
  Vec2 center = Vec2::Zero();  ///< kArc
  double sweep_rad = 0.0;      ///< kArc: > 0 counter-clockwise
};

/// Radii of the pocket's wall.
struct CircularPocket {
  double first = 0.0;  ///< of the first circle, or of the only one
  double last = 0.0;   ///< of the last circle; 0: there is one circle
  double step = 0.0;   ///< from circle to circle, with `last`
  double tool_radius = 0.0;
  bool counter_clockwise = true;
};

enum class CircularPocketError {
  kNone,
  kTooSmall,   ///< the first circle is not larger than the tool
  kBackwards,  ///< the last circle is smaller than the first one
  kNoStep,     ///< several circles without a step above 0
  kTooMany,    ///< more than kMaxPocketCircles
  kNotFinite
};
inline constexpr int kMaxPocketCircles = 10000;

/// From the centre on a half circle to the first circle on +u, round it, on half circles from circle to
/// circle, to the other side each time, and on a half circle back to the centre.
CircularPocketError circularPocket(const CircularPocket& pocket, std::vector<PocketMove>& moves);

}  // namespace proveout
