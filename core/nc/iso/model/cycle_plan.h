// What a block with a drilling cycle plans.
#pragma once

#include <cstdint>

#include "core/machine/axis_point.h"
#include "core/nc/services/drilling.h"

namespace proveout::nc {

/// The holes of a block. Heights of the drill axis are in work space: transforms apply to points of the
/// program, not to pecks, clearances and shifts.
struct Holes {
  AxisPoint step;       ///< position or step per axis, mm
  AxisSet incremental;  ///< axes with a step
  std::int64_t repeat = 1;
  DrillCode code = DrillCode::kDrill;       ///< what is done at each
  bool listed = false;                      ///< they are IsoContext::hole_points
  bool polar = false;                       ///< G16: plan.motion.target is the first hole
  bool from_hole = false;                   ///< the radius counts from hole to hole
  double radius = 0.0;                      ///< mm
  double angle_step = 0.0;                  ///< degrees from hole to hole
  double initial = 0.0, r = 0.0;            ///< program space
  double work_initial = 0.0, work_r = 0.0;  ///< the same in work space
  double work_bottom = 0.0;
};

}  // namespace proveout::nc
