// What a path keeps of a motion during which the tool's axis turns.
#pragma once

#include <memory>

#include "core/machine/machine_chain.h"

namespace proveout {

/// The machine behind a motion during which the tool's axis turns.
struct PoseSweep {
  /// Of kTip and kAxes: in the workpiece frame; not null there.
  std::shared_ptr<const MachineChain> chain;
  AxisPoint axes_from, axes_to;     ///< where its axes are; between them all go linearly
  Vec3 tip_at_zero = Vec3::Zero();  ///< kAxes: the tip with all axes at 0, workpiece frame, mm
  /// Others: from the point on the line or arc to the tip, along the tool's axis, mm. Above 0 where the
  /// control takes the tool for longer than it is.
  double beyond = 0.0;
};

}  // namespace proveout
