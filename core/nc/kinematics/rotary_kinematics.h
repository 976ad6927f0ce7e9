// How rotary tables carry the part: from the axes of the machine to points and directions of the workpiece
// frame.
#pragma once

#include <vector>

#include "core/geometry/types.h"
#include "core/nc/kinematics/axes.h"

namespace proveout::nc {

/// The tables of a machine, in the order of its axes: the first stands on the bed, the last carries the part.
/// A positive angle turns the tool right-handed about the table's direction as seen from the part.
class RotaryKinematics {
 public:
  /// `origin` is that of the workpiece frame in the machine frame; a table without a centre turns about it.
  RotaryKinematics(const AxisTable& axes, const Vec3& origin);

  bool any() const { return !tables_.empty(); }
  /// Does any table turn from `a` to `b`?
  bool turns(const AxisPoint& a, const AxisPoint& b) const;
  /// Is every table at 0 (whole turns aside)?
  bool atZero(const AxisPoint& machine) const;
  /// Sum of the angles that the tables turn from `a` to `b`, rad, >= 0.
  double turned(const AxisPoint& a, const AxisPoint& b) const;
  bool carries(int axis) const;

  /// A point given in the workpiece frame with all tables at 0, with the tables at `machine`.
  Vec3 point(const AxisPoint& machine, const Vec3& p) const;
  Vec3 direction(const AxisPoint& machine, const Vec3& d) const;

  /// The only table that turns from `a` to `b`, or -1.
  int turningTable(const AxisPoint& a, const AxisPoint& b) const;
  /// Axis of that table in the part, with the tables at `machine`: a point and the direction.
  void tableAxis(int table, const AxisPoint& machine, Vec3& point, Vec3& direction) const;
  /// Angle of that table, deg.
  double angle(int table, const AxisPoint& machine) const {
    return machine[tables_[static_cast<std::size_t>(table)].axis];
  }

 private:
  struct Table {
    int axis;
    Vec3 direction;  ///< unit
    Vec3 center;     ///< workpiece frame
  };
  std::vector<Table> tables_;
};

}  // namespace proveout::nc
