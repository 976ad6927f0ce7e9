// The chain of a machine's axes: from their positions to the tool as the part sees it.
#pragma once

#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/machine/axis_point.h"
#include "core/machine/machine_model.h"

namespace proveout {

/// The tool as the part sees it.
struct ToolPose {
  Vec3 tip = Vec3::Zero();    ///< mm
  Vec3 axis = Vec3::UnitZ();  ///< unit, from the tip to the holder
};

/// Works in a frame that is fixed to the part: the machine frame with all axes that carry the part at 0,
/// moved to an origin. The workpiece frame is one. Every axis is seen as it moves the tool against the part,
/// so that it does not matter which of both it carries.
class MachineChain {
 public:
  MachineChain() = default;
  /// `origin`: of the part's frame, machine frame, mm. Requires a model without faults.
  MachineChain(const MachineModel& model, const Vec3& origin);

  /// Any rotary axes that carry tool or part?
  bool anyRotary() const { return !rotary_.empty(); }
  /// Does any of them turn from `a` to `b`?
  bool turns(const AxisPoint& a, const AxisPoint& b) const;
  /// Are all of them at 0 (whole turns aside)?
  bool atZero(const AxisPoint& machine) const;
  /// Sum of the angles that they turn from `a` to `b`, rad, >= 0.
  double turned(const AxisPoint& a, const AxisPoint& b) const;
  /// Whether it is one of them.
  bool carries(int axis) const;

  /// Where a point that is fixed to the tool is, with the axes at `machine`. `at_zero`: with all axes at 0.
  Vec3 point(const AxisPoint& machine, const Vec3& at_zero) const;
  /// The same of a direction.
  Vec3 direction(const AxisPoint& machine, const Vec3& at_zero) const;
  /// Direction of the tool with all axes at 0.
  const Vec3& toolAtZero() const { return tool_; }
  /// Are X, Y and Z the axes of the machine frame?
  bool isLevel() const { return level_; }
  /// Direction of the tool, from tip to holder.
  Vec3 toolAxis(const AxisPoint& machine) const { return direction(machine, tool_); }
  /// The pose of a tool whose tip is so far before the gauge point, mm.
  ToolPose pose(const AxisPoint& machine, double gauge_length) const {
    return {point(machine, tipAtZero(gauge_length)), toolAxis(machine)};
  }
  /// A moving point (or a direction) and bounds of how it moves while the axes go linearly, the share of
  /// their way growing from 0 to 1: mm (or nothing).
  struct PointMotion {
    Vec3 at = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();  ///< there, by the share
  };
  struct MotionBounds {
    double velocity = 0.0, acceleration = 0.0;  ///< most length of the first and second derivative
  };
  /// Where a point that is fixed to the tool is at `share`, and how it moves.
  PointMotion follow(const AxisPoint& from, const AxisPoint& to, double share, const Vec3& at_zero) const;
  /// The same of a direction.
  PointMotion followDirection(const AxisPoint& from, const AxisPoint& to, double share,
                              const Vec3& at_zero) const;
  /// Bounds over the shares from `low` to `high`, whichever the chain; they are near the truth where it is
  /// short.
  MotionBounds pointBounds(const AxisPoint& from, const AxisPoint& to, double low, double high,
                           const Vec3& at_zero) const;
  /// The same chain seen from a frame that `move` leads to.
  MachineChain moved(const RigidTransform& move) const;

  /// Its tip with all axes at 0.
  Vec3 tipAtZero(double gauge_length) const { return gauge_ - gauge_length * tool_; }

  /// An axis that turns the tool against the part, as a line.
  struct Turn {
    int axis;        ///< index
    double sign;     ///< +1: a positive angle turns the tool right-handed about `direction`, else -1
    Vec3 point;      ///< mm
    Vec3 direction;  ///< unit
  };
  /// The only axis that turns from `a` to `b`, as a line with the axes at `a`; axis -1: none or several.
  Turn onlyTurn(const AxisPoint& a, const AxisPoint& b) const;
  /// The rotary axes in the order in which they turn the tool: `direction` and `point` with all axes at 0.
  std::vector<Turn> rotaryAxes() const;

 private:
  struct Link {
    int axis;
    bool rotary;
    double sign;  ///< rotary: as in Turn
    Vec3 direction;
    Vec3 point;
  };
  Vec3 through(const Link& link, const AxisPoint& machine, const Vec3& p) const;

  std::vector<Link> links_;    ///< from the tip to the bed, then from the bed to the part
  std::vector<Link> rotary_;   ///< of these
  Vec3 gauge_ = Vec3::Zero();  ///< of the gauge point with all axes at 0, in the part's frame
  Vec3 tool_ = Vec3::UnitZ();
  bool level_ = true;
};

}  // namespace proveout
