// What the machine allows on its way along the path: feeds, accelerations, corners (manual chapters 6 and 7).
#pragma once

#include <array>

#include "core/machine/axis_point.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Limits of an axis; 0: none. mm and seconds, rotary axes degrees and seconds.
struct AxisMotionLimits {
  double acceleration = 0.0;  ///< along the path
  double max_feed = 0.0;      ///< a minute
  double normal = 0.0;        ///< acceleration across the path
  double jump = 0.0;          ///< of the acceleration, between lines
  double jump_arc = 0.0;      ///< of the acceleration, where an arc begins or ends
  double speed_change = 0.0;  ///< that a corner may make, a minute
};

/// Limits of a channel. All off: every motion takes length / feed.
struct MotionLimits {
  std::array<AxisMotionLimits, kMaxAxes> axes;
  bool accelerations = false;     ///< any axis has one: speeds are planned
  bool feeds = false;             ///< any axis has a limit of feed or of acceleration on arcs
  bool corner_by_angle = false;   ///< corners by their angle instead of the speed change of the axes
  double corner_angle_deg = 0.0;  ///< a sharper change of direction is a corner; 0: none is
  double corner_feed = 0.0;       ///< feed there, mm/min
  double least_arc_feed = 0.0;    ///< the limit of acceleration across arcs goes no lower, mm/min
  double bell_time_s = 0.0;       ///< in which the acceleration comes up; 0: at once
};

/// How a motion may run, and how its path begins and ends, for the plan of speeds. Machine axes.
struct MotionPace {
  double length = 0.0;                                        ///< mm; degrees count as mm
  double speed = 0.0;                                         ///< mm/s
  double acceleration = 0.0;                                  ///< along the path, mm/s^2
  AxisPoint begin, end;                                       ///< direction: travel of the axes per length
  Vec3 begin_curve = Vec3::Zero(), end_curve = Vec3::Zero();  ///< of arcs: towards the centre, 1/mm
  Vec3 corner_curve = Vec3::Zero();                           ///< of a line behind a line: see cornerCurve()
  bool rapid = false;
  bool arc = false;
};

/// An arc in the machine frame as feeds see it.
struct ArcPace {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  ArcGeometry arc;
  double length = 0.0;
};

/// The feed that the axes allow on a line with this travel per length, mm/min.
double allowedFeed(const MotionLimits& limits, const AxisPoint& direction, int axes, double feed);
/// The same on an arc; the acceleration across the path counts as well.
double allowedArcFeed(const MotionLimits& limits, const ArcPace& arc, double feed);

/// The acceleration that the axes allow along a line, mm/s^2; infinite where none of them has a limit.
double lineAcceleration(const MotionLimits& limits, const AxisPoint& direction, int axes);
/// Fills directions, curvatures and acceleration of an arc.
void setArcPace(const MotionLimits& limits, const ArcPace& arc, MotionPace& pace);

/// What a corner of two short lines is to the acceleration: their change of direction over their lengths,
/// 1/mm. 0 where one of them is an arc.
Vec3 cornerCurve(const MotionPace& before, const MotionPace& after);
/// The highest speed from one feed motion into the next without a stop, mm/s; may be infinite.
double cornerSpeed(const MotionLimits& limits, const MotionPace& before, const MotionPace& after, int axes);

}  // namespace proveout::nc
