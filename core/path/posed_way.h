// How a tool goes whose axis turns while it moves: place and direction at any share of the motion, and bounds
// of how fast both change.
//
// Workpiece frame, mm. The tool is round: what turns it about its own axis does not count.
#pragma once

#include "core/path/pose_sweep.h"
#include "core/path/toolpath.h"

namespace proveout {

class PosedWay {
 public:
  /// `axis` of the motion; `arc` is null on lines. Keeps nothing of them but the chain.
  PosedWay(const Motion& motion, const ArcGeometry* arc, const AxisSweep& axis);

  /// At a share of the motion, 0 to 1: of its length or angle, and of the ways of all axes.
  ToolPose at(double share) const;
  /// How tip and axis change there, by the share.
  struct Rates {
    Vec3 tip = Vec3::Zero();   ///< mm
    Vec3 axis = Vec3::Zero();  ///< rad, across the axis
  };
  struct Moving {
    ToolPose pose;
    Rates rates;
  };
  Moving movingAt(double share) const;
  /// Most lengths of the first and second derivatives of tip and axis by the share, between two shares.
  struct Bounds {
    MachineChain::MotionBounds tip, axis;
  };
  Bounds boundsOn(double low, double high) const;
  /// Bounds of the tip between two shares, mm; a little wide.
  Box3 tipBounds(double low, double high) const;
  /// Length of the tip's way, mm, to 1e-6 of it or a nanometre.
  double length() const;

 private:
  MachineChain::PointMotion pointAt(double share) const;
  MachineChain::MotionBounds pointBounds() const;
  MachineChain::PointMotion axisAt(double share) const;

  PoseLaw law_;
  Vec3 from_, to_;       ///< of the point on the line or arc
  bool is_arc_ = false;  ///< arcs
  ArcGeometry arc_;
  ArcFrame frame_{};
  Vec3 axis_from_, axis_to_;
  double angle_ = 0.0;                      ///< kVector: that the axis turns, rad
  Vec3 about_ = Vec3::UnitZ();              ///< kVector: about it
  double azimuth_ = 0.0;                    ///< kCone: from start to end, rad, about the arc's normal
  double tilt_from_ = 0.0, tilt_to_ = 0.0;  ///< kCone: from the arc's normal to the axis, rad
  Vec3 azimuth_at_ = Vec3::UnitX();         ///< kCone: of the start, unit, across the normal
  std::shared_ptr<const PoseSweep> pose_;
};

/// The way of a motion of the path whose axis turns.
PosedWay posedWayOf(const Toolpath& path, const Motion& motion);

}  // namespace proveout
