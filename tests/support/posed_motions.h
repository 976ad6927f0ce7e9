// Motions during which the tool's axis turns, for tests.
#pragma once

#include <memory>

#include "core/path/posed_way.h"
#include "removal/sweep/tool_frame.h"
#include "tests/support/test_machines.h"

namespace proveout::test {

/// A motion with all that a path keeps of it.
struct PosedMotion {
  Motion motion;
  ArcGeometry arc;
  bool is_arc = false;
  AxisSweep axis;

  PosedWay way() const { return {motion, is_arc ? &arc : nullptr, axis}; }
  MotionWay asked() const { return {motion, is_arc ? &arc : nullptr, &axis}; }
  /// A path of this motion alone, by tool 1.
  Toolpath path() const {
    Toolpath out;
    out.files = {"test"};
    out.axes.push_back(axis);
    if (is_arc) out.arcs.push_back(arc);
    Motion m = motion;
    m.axis = 0;
    m.arc = is_arc ? 0 : -1;
    m.tool = 1;
    m.spindle = 1000.0;
    m.kind = MotionKind::kFeed;
    m.source.line = 1;
    out.motions.push_back(m);
    return out;
  }
};

inline AxisPoint axesAt(const Vec3& xyz, double first, double second = 0.0) {
  AxisPoint p(xyz);
  p.more[0] = first;
  p.more[1] = second;
  return p;
}

/// All axes of a machine from one place to another, with a tool of this length. `origin`: of the part.
inline PosedMotion axesMotion(const MachineModel& machine, const AxisPoint& from, const AxisPoint& to,
                              double length, const Vec3& origin = Vec3::Zero()) {
  auto pose = std::make_shared<PoseSweep>();
  const auto chain = std::make_shared<const MachineChain>(machine, origin);
  pose->chain = chain;
  pose->axes_from = from;
  pose->axes_to = to;
  pose->tip_at_zero = chain->tipAtZero(length);
  PosedMotion m;
  const ToolPose a = chain->pose(from, length), b = chain->pose(to, length);
  m.motion.from = a.tip;
  m.motion.to = b.tip;
  m.axis.from = a.axis;
  m.axis.to = b.axis;
  m.axis.law = PoseLaw::kAxes;
  m.axis.pose = pose;
  return m;
}

/// The tip on a line, the axis turning in one plane.
inline PosedMotion vectorMotion(const Vec3& from, const Vec3& to, const Vec3& axis_from,
                                const Vec3& axis_to) {
  PosedMotion m;
  m.motion.from = from;
  m.motion.to = to;
  m.axis.from = axis_from.normalized();
  m.axis.to = axis_to.normalized();
  return m;
}

}  // namespace proveout::test
