// Turns machine-frame moves into motions of the tool path: workpiece frame, tool, spindle, time.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/machine/machine_chain.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/stages/pose_track.h"
#include "core/nc/stages/time_stage.h"
#include "core/path/pose_sweep.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// How a feed motion goes.
struct FeedStyle {
  MotionKind kind = MotionKind::kFeed;
  bool compensated = false;  ///< see Motion
  double feed = 0.0;         ///< mm/min
  /// What of an arc the feed is the speed of: the circle in the plane, the whole path in space, or the
  /// start radius (constant angular speed).
  enum class Along { kPlane, kSpace, kStartRadius } along = Along::kSpace;
  double spindle = 0.0;       ///< rpm, signed, where it changes along the motion (G96); 0: as it turns anyway
  double acceleration = 0.0;  ///< along the path, of what turns with the motion (taps), mm/s^2; 0: no limit
  MotionJoin join;
  float thread_start_deg = 0.0F;     ///< kThread: see Motion
  float thread_pitch_change = 0.0F;  ///< kThread: see Motion
  double paced_mm = 0.0;  ///< of lines: the length that the feed is the speed of; 0: that of all axes
  AxisSet slaves;  ///< of arcs and in polar planes: axes that carry nothing and whose ways the feed is no
                   ///< speed of
};

/// An arc in the machine frame; `center` at the height of the start. In a plane with an axis besides X Y Z
/// the centre is (u, v, w) of that plane and the normal has no meaning.
struct MachineArc {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  double sweep_rad = 0.0;
  WorkPlane plane = WorkPlane(PlaneFrame());
};

/// A plane of a linear and a rotary axis taken for a rectangular one (G12.1): where its origin is.
struct PolarPlane {
  int linear = 0, rotary = 0;  ///< axes
  double zero = 0.0;           ///< machine position of the linear axis at the rotary axis' centre, mm
  double zero_deg = 0.0;       ///< machine position of the rotary axis on the linear axis
  double sign = 1.0;           ///< side of the centre that the linear axis stays on, +1 or -1

  /// Point of the plane with the axes at `machine`.
  Vec2 of(const AxisPoint& machine) const;
};
/// A circle in such a plane.
struct PolarArc {
  Vec2 center = Vec2::Zero();
  double sweep_rad = 0.0;
};
/// A line or a circle in such a plane.
struct PolarLeg {
  Vec2 from, to;
  std::optional<PolarArc> arc;
  Vec2 at(double t) const;  ///< t in 0..1
  double length() const;    ///< mm
};

/// Holds what the machine is doing; one owner. Positions are machine coordinates of the controlled point, mm.
class PathEmitter {
 public:
  /// `axes` must outlive the emitter.
  PathEmitter(const ControlSettings& settings, const AxisTable& axes, MotionSink& sink,
              InterpretSummary& summary);

  const AxisPoint& machine() const { return machine_; }
  /// Where the machine stands at power-on.
  const Vec3& home() const { return home_; }
  /// Lowers that to a height at most, machine frame, mm. Before any motion.
  void lowerStart(double height);
  /// An axis besides X Y Z that carries nothing stands there at power-on, mm or deg. Before any motion.
  void placeIdle(int axis, double position) { machine_[axis] = position; }
  /// The tool stands in another head from here on: unit direction from tip to holder, and the gauge point
  /// seen from the control point, mm, both with all axes at 0.
  void turnHead(const Vec3& direction, const Vec3& gauge);

  /// From stand to stand; with a `speed` (mm/min along the way of all axes) as a part of a longer way, whose
  /// speeds are known.
  void rapidTo(const AxisPoint& to, const SourceRef& source, double speed = 0.0);
  void lineTo(const AxisPoint& to, const FeedStyle& style, const SourceRef& source);
  void arcTo(const AxisPoint& to, const MachineArc& arc, const FeedStyle& style, const SourceRef& source);

  /// A straight line or, with `arc`, a circle in a polar plane, at rapid without a feed. `to` is the end on
  /// the machine's axes, turns of the rotary axis counted.
  void polarTo(const AxisPoint& to, const PolarPlane& plane, const std::optional<PolarArc>& arc,
               const FeedStyle* style, const SourceRef& source);

  /// A way of the tip while rotary axes turn; at rapid without a feed, else the feed is the speed of the tip,
  /// or of the rotary axes (degrees as mm) where the tip stays.
  void poseTo(const AxisPoint& to, const PoseTrack& track, const FeedStyle* style, const SourceRef& source);

  /// The line that lineTo() would send now, without feed and time, for questions about it. Nothing: tables
  /// turn on the way, so that the tool goes along no line in the part.
  struct Line {
    Motion motion;
    AxisSweep axis;
    bool has_axis = false;  ///< `axis` holds something
  };
  std::optional<Line> lineOf(const AxisPoint& to, const SourceRef& source);

  /// How far the plane's origin is from the centre that the rotary axis turns the part about, mm; 0 where it
  /// turns nothing.
  double polarError(const PolarPlane& plane) const;

  /// The axes stand still for all events but those that only tell something.
  void event(EventKind what, double time_s, const SourceRef& source);
  void diagnostic(const Diagnostic& diagnostic);

  /// The machine counts from the nose centres of these inserts, where they have no gauge: the path tells of
  /// the touch-off points all the same. Before any motion.
  void countFromNose(int tool);

  /// Accelerations, corners and look-ahead.
  TimeStage& time() { return time_; }
  const TimeStage& time() const { return time_; }

  int tool() const { return tool_; }
  void setTool(int tool);
  double spindle() const { return spindle_; }
  void setSpindle(double rpm) { spindle_ = rpm; }  ///< negative: counter-clockwise, 0: stopped
  /// 1/min per second; 0: at once.
  void setSpindleAcceleration(double acceleration) { spindle_acceleration_ = acceleration; }
  /// Time that the spindle takes to another speed, s.
  double spindleRamp(double rpm) const {
    return spindle_acceleration_ > 0.0 ? std::abs(rpm - spindle_) / spindle_acceleration_ : 0.0;
  }

 private:
  void send(Motion& motion, const AxisPoint& to, const ArcGeometry* arc, const MotionPace* pace = nullptr,
            const MotionJoin& join = {});
  MotionPace linePace(const AxisPoint& to, double length, double speed) const;
  Vec3 alongTool(const Vec3& gauge) const;
  /// The controlled point of the tool in the workpiece frame.
  Vec3 toolPoint(const AxisPoint& machine) const;
  using MachineCurve = std::function<AxisPoint(double)>;  ///< of 0..1
  /// Where shapes of ways are compared: no fractions of a turn that an arc of several turns repeats.
  static constexpr std::array<double, 4> kProbes{0.137, 0.389, 0.618, 0.871};
  struct Shape {
    enum class Kind { kLine, kArc, kOther } kind = Kind::kOther;
    ArcGeometry arc;
  };
  /// Whether the controlled point, the axes going along `at`, keeps to a line or to the arc.
  Shape shapeOf(const MachineCurve& at, const ArcGeometry* arc) const;
  void sendCurve(const Motion& whole, const MachineCurve& at, const ArcGeometry* arc);
  void sendPiece(Motion& piece, const AxisPoint& to, const ArcGeometry* arc, double length,
                 const AxisSweep* sweep);
  void sendTurned(const Motion& motion, const AxisPoint& to);
  void sendByAxes(Motion motion, const AxisPoint& to);
  bool sendHeld(Motion motion, const AxisPoint& to, const PoseTrack& track, const MotionPace* pace,
                const MotionJoin& join);
  /// A piece of such a way by a law that may serve for it.
  struct PosedPart {
    Motion motion;
    AxisSweep sweep;
    std::optional<ArcGeometry> arc;
  };
  PosedPart partTo(const AxisPoint& to, PoseLaw law, const ArcGeometry* arc);
  /// Whether the machine goes along it from one share of its way to another.
  bool follows(const PosedPart& part, const PoseTrack& track, double low, double high) const;
  void sendFollowed(const Motion& motion, const PoseTrack& track);
  void checkSwing(const PoseTrack& track, double low, double high, const SourceRef& source);
  MotionPace trackPace(const PoseTrack& track, const FeedStyle* style) const;
  PoseSweep poseTowards(const AxisPoint& to) const;
  ToolPose toolPose(const AxisPoint& machine) const {
    return {toolPoint(machine), chain_->toolAxis(machine)};
  }
  void takeChain(const MachineModel& model);
  void placeTool();
  void furtherArc(const AxisPoint& to, const MachineArc& arc, const FeedStyle& style,
                  const SourceRef& source);
  double polarMinutes(const PolarPlane& plane, const PolarLeg& leg, const FeedStyle& style,
                      double others) const;
  std::optional<ArcGeometry> polarCircle(const PolarPlane& plane, const PolarArc& arc) const;
  bool plainArc(const AxisPoint& to, const MachineArc& arc, const AxisSet& slaves) const;
  void checkMachineTravel(const AxisPoint& from, const SourceRef& source);
  double furtherTravel(const AxisPoint& to, const AxisSet& slaves = {}) const;
  double furtherRapidTime(const AxisPoint& to) const;
  const AxisSweep* sweepTo(const AxisPoint& to);
  void checkFurtherTravel(const AxisPoint& to, const SourceRef& source);
  void overtravel(int axis, double value, double limit, const SourceRef& source);
  void checkTravel(const Motion& motion, const ArcGeometry* arc, const SourceRef& source);

  const ControlSettings& settings_;
  InterpretSummary& summary_;
  TimeStage time_;
  const AxisTable& axes_;
  const int more_;  ///< axes besides X Y Z
  bool plain_;      ///< X, Y, Z alone, along the machine's own axes, and an upright tool
  int rotary_ = 0;  ///< of these, the rotary ones
  Vec3 origin_;
  std::shared_ptr<const MachineChain> chain_;  ///< the path shares it; never null
  AxisPoint machine_;
  Vec3 home_;
  AxisSweep sweep_;
  /// The tool's controlled point with all axes at 0, workpiece frame; what is added to a machine point where
  /// no axis turns.
  Vec3 to_workpiece_;
  std::map<int, Vec3> gauges_;  ///< by tool: from its control point to what the machine counts from
  int tool_ = 0;
  double spindle_ = 0.0;
  double spindle_acceleration_ = 0.0;
  bool any_limit_ = false;
};

/// Length of an arc, helix, spiral or cone, mm; closed form (Simpson where the radii nearly agree).
double arcLength(double radius_start, double radius_end, double sweep_rad, double rise);

}  // namespace proveout::nc
