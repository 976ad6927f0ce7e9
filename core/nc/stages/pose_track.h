// A motion during which rotary axes turn while the control holds the tool's tip on its way (manual 25.14 to
// 25.16).
#pragma once

#include <functional>
#include <optional>

#include "core/machine/axis_point.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// What the control computes of such a motion with its own data: of the machine and of the tool's length.
/// Where they are true the tip goes along the programmed line or arc; else the machine shows it.
struct PoseTrack {
  PoseLaw law = PoseLaw::kTip;  ///< kTip, kVector on lines, kCone on arcs
  /// Machine positions of all axes at a share of the way, 0 to 1.
  std::function<AxisPoint(double)> at;
  double length = 0.0;  ///< of the tool, mm: what the control adds along it
  double held_mm =
      0.0;  ///< from the point that is held on the way to the tip, along the tool; 0: it is the tip
  double tip_mm = 0.0;  ///< length of the tip's way
  /// Of arcs: where the linear axes would be with the tip at the centre, and a millimetre from there along
  /// the normal; both with the rotary axes as at the start.
  struct Arc {
    AxisPoint center, above;
    double sweep_rad = 0.0;  ///< about the normal, right-handed
  };
  std::optional<Arc> arc;
};

}  // namespace proveout::nc
