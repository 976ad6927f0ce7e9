// What a block of the WL4 control is to do.
#pragma once

#include "core/nc/kinematics/axes.h"
#include "core/nc/wl4/wl4_state.h"

namespace proveout::nc {

struct Wl4GCode;

/// Filled by all checks of the block, before anything of it happens. Lengths mm.
struct Wl4BlockPlan {
  Wl4State next;                   ///< behind the block
  const Wl4GCode* deed = nullptr;  ///< in place of a motion
  // Flags of the codes.
  bool exact_stop = false, measures = false;
  bool mirror_off = false, mirror = false;  ///< G50; G51, whose words of axes are no coordinates
  bool thread = false;                      ///< the words F, I, P are those of a thread
  bool sets_system = false;                 ///< G92
  bool contour = false;                     ///< a cycle over a contour
  bool moves = false;                       ///< words of axes that are to move, even by nothing
  AxisSet named;                            ///< axes with such a word
  AxisPoint target;                         ///< machine coordinates
  double chamfer = 0.0;                     ///< leg behind the motion

  /// The block is, or would be, an arc with words for its centre or radius.
  bool arc() const { return deed == nullptr && (next.motion == 2 || next.motion == 3); }
};

}  // namespace proveout::nc
