// The frame of a tool whose axis stands still but leans: there the tool is upright.
//
// Tool frame: the workpiece frame turned about its origin, so that the tool's axis is +z. Which way x and y
// point is open, tools being round, but the same for the same axis.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/path/toolpath.h"

namespace proveout {

/// An axis this near to +z is upright: rounding of a chain of rotary axes.
inline constexpr double kUprightAxis = 1e-12;
/// A way this near to the tool's axis, or to a plane across it, goes along it or in that plane: rounding of
/// the frames that a program is turned through. Share of the way, which may be short.
inline constexpr double kAlongAxis = 1e-9;

class ToolFrame {
 public:
  /// `axis`: the tool's, workpiece frame, from the tip to the spindle; any length above 0.
  explicit ToolFrame(const Vec3& axis) {
    const Vec3 z = axis.normalized();
    int least = 0;
    z.cwiseAbs().minCoeff(&least);
    const Vec3 x = (Vec3::Unit(least) - z[least] * z).normalized();
    turn_ << x, z.cross(x), z;
  }

  /// Of points and directions alike.
  Vec3 toTool(const Vec3& v) const { return turn_.transpose() * v; }
  Vec3 toPart(const Vec3& v) const { return turn_ * v; }
  /// Of a way. What goes along the tool's axis does so to the last digit, and what goes across it: sweeps
  /// tell such ways by that.
  Vec3 wayToTool(const Vec3& way) const {
    Vec3 v = toTool(way);
    const double aside = v.head<2>().norm(), along = std::abs(v.z());
    if (aside <= kAlongAxis * along) v.head<2>().setZero();
    if (along <= kAlongAxis * aside) v.z() = 0.0;
    return v;
  }
  Vec3 axis() const { return turn_.col(2); }  ///< unit, workpiece frame
  ArcGeometry toTool(const ArcGeometry& arc) const {
    ArcGeometry out{toTool(arc.center), toTool(arc.normal), arc.sweep_rad};
    // What turns about the tool's axis does so to the last digit.
    if (out.normal.head<2>().norm() < kUprightAxis)
      out.normal = Vec3(0.0, 0.0, std::copysign(1.0, out.normal.z()));
    return out;
  }

 private:
  Eigen::Matrix3d turn_;  ///< from the tool frame to the workpiece frame
};

/// A motion with what its path keeps elsewhere of the way; must not outlive either.
struct MotionWay {
  const Motion& motion;
  const ArcGeometry* arc = nullptr;  ///< null for lines
  const AxisSweep* axis = nullptr;   ///< null: along +z

  /// The axis stands still, but leans from +z.
  bool leans() const { return axis != nullptr && !turns() && !isUpright(axis->from); }
  /// The axis turns on the way, also where it comes back, or the part turns under it: a way of PosedWay.
  bool turns() const {
    return axis != nullptr && (axis->pose != nullptr || axis->law == PoseLaw::kCone ||
                               (axis->to - axis->from).norm() > kUprightAxis);
  }
  /// Requires that the axis does not turn. Unit, workpiece frame, from the tip to the spindle.
  Vec3 direction() const { return leans() ? Vec3(axis->from.normalized()) : Vec3::UnitZ(); }

 private:
  static bool isUpright(const Vec3& a) { return (a - Vec3::UnitZ()).norm() <= kUprightAxis; }
};

inline MotionWay wayOf(const Toolpath& path, const Motion& motion) {
  return {motion, motion.arc < 0 ? nullptr : &path.arcs[static_cast<std::size_t>(motion.arc)],
          motion.axis < 0 ? nullptr : &path.axes[static_cast<std::size_t>(motion.axis)]};
}

}  // namespace proveout
