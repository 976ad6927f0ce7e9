// The way of a block whose tip the control holds: in programmed coordinates, and where the machine is on it.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The rotary axes of a machine position, of those that there are.
inline void setAngles(const FiveAxisModel& model, const RotaryAngles& angles, AxisPoint& machine) {
  if (model.first >= 0) machine[model.first] = angles.first;
  if (model.second >= 0) machine[model.second] = angles.second;
}

/// Where the frame of the workpiece is that directions of the tool are told in; coordinates depend on the
/// rotary axes alone.
inline const AxisPoint kTablesAtZero;

/// From where the context's machine stands to the target of the plan. Both must outlive it, and stay as they
/// are.
class TipWay {
 public:
  TipWay(const IsoContext& c, const BlockPlan& plan)
      : c_(c),
        plan_(plan),
        from_(c.chainOf(plan.next, c.machine).programOf(c.machine)),
        plane_(plan.next.workPlane()) {}

  /// Its start, programmed: where a call of G54.2 has moved the zero, another than the position that the
  /// program holds.
  const AxisPoint& from() const { return from_; }

  /// The tip where the point on the tool's axis that the plan holds (PlannedMotion::pivot_mm) stays and the
  /// rotary axes are those of `to`; all programmed.
  Vec3 pivoted(const AxisPoint& to) const;
  /// Programmed coordinates at a share of the way, 0 to 1; rotary axes go linearly.
  AxisPoint programAt(double share) const;
  /// Machine position there, the rotary axes going linearly.
  AxisPoint machineAt(double share) const;
  /// The same with the rotary axes elsewhere.
  AxisPoint machineAt(double share, const RotaryAngles& angles) const;
  /// Machine position of a programmed point with the rotary axes of `angles`, machine coordinates.
  AxisPoint machineOf(const AxisPoint& program, const AxisPoint& angles) const {
    return c_.chainOf(plan_.next, angles).machineOf(program);
  }
  /// Of the tip in the workpiece, mm.
  double length() const;
  /// Of arcs: seen with the rotary axes of `angles`.
  PoseTrack::Arc arc(const AxisPoint& angles) const;

 private:
  double scale() const;
  Vec3 directionAt(const AxisPoint& program) const;

  const IsoContext& c_;
  const BlockPlan& plan_;
  AxisPoint from_;
  WorkPlane plane_;
};

}  // namespace proveout::nc
