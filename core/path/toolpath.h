// The tool path: the narrow waist of the program. What a virtual control made of an NC program, in the
// workpiece frame; nothing behind it knows which dialect made a motion.
//
// Workpiece frame: the machine frame moved to the work offset that the job gives for the first work
// coordinate system (G54; zero by default), as it was when the program started. Stock and nominal
// are given in the same frame. A program that changes G54 later really moves the tool elsewhere.
//
// Control point: the tool tip on the tool axis (mills, drills). With `gauge_length` of the tool at 0 (the
// default) it is the programmed point plus active length offset; with a gauge length, that is subtracted.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/geometry/types.h"
#include "core/path/path_event.h"
#include "core/path/word_origin.h"

namespace proveout {

/// kProbe: a measuring move; it may touch the stock, where it ends, and removes nothing.
enum class MotionKind : std::uint8_t { kRapid, kFeed, kThread, kProbe };
enum class MotionShape : std::uint8_t { kLine, kArc };
std::string_view motionKindName(MotionKind kind);  ///< "rapid", "feed", "thread", "probe"

/// Index of a motion in the tool path (`Toolpath::motions`). Also the "id" of the path stream.
using MotionId = std::uint32_t;
inline constexpr MotionId kNoMotion = 0xFFFFFFFFu;

/// Arc, helix, spiral or conical helix about an axis with constant direction.
/// Position at parameter u in 0..1: angle a = u * sweep about `normal` (right-hand rule) from the start;
/// the radius (distance to the axis) and the height along the axis go linearly from start to end.
struct ArcGeometry {
  Vec3 center = Vec3::Zero();   ///< a point on the axis, mm, at the height of the start point
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double sweep_rad = 0.0;       ///< signed, right-hand rule about `normal`; more than a turn is allowed
};

/// Where a rotary axis stands, degrees.
struct RotaryPosition {
  std::array<char, 4> name{};  ///< of the axis, ended by NUL
  double from = 0.0, to = 0.0;
  bool in_path = false;  ///< the motion's points are turned by it; false: the position is only told
};
/// Rotary axes that a path may tell of.
inline constexpr int kMaxRotaryAxes = 6;

/// How a tool goes whose axis turns. The point that a law holds on the motion's line or arc is the tip, or
/// one beside it on the tool's axis (PoseSweep::beyond, pose_sweep.h).
enum class PoseLaw : std::uint8_t {
  kVector,  ///< the point on the line or arc, the axis turning in one plane from start to end, less than 180
            ///< deg
  kTip,     ///< the point on the line or arc, the rotary axes of the machine going linearly
  kCone,    ///< the point on an arc, azimuth about the arc's axis and inclination to it going linearly
  kAxes,    ///< all axes of the machine going linearly: the tip's way is what follows from that
};
std::string_view poseLawName(PoseLaw law);  ///< "vector", "tip", "cone", "axes"

struct PoseSweep;

/// The direction of the tool during a motion, and the rotary axes of the machine.
struct AxisSweep {
  Vec3 from = Vec3::UnitZ();  ///< tool axis, unit, workpiece frame, from the tip to the spindle
  Vec3 to = Vec3::UnitZ();    ///< the same at the end
  int rotary_count = 0;
  std::array<RotaryPosition, kMaxRotaryAxes> rotary;
  PoseLaw law = PoseLaw::kVector;
  /// See pose_sweep.h. Null: kVector or kCone, of the tip itself. Where it is not, the axis turns.
  std::shared_ptr<const PoseSweep> pose;

  bool alongZ() const { return from == Vec3::UnitZ() && to == Vec3::UnitZ() && pose == nullptr; }
  /// Whether the tip may leave the motion's line or arc between its ends.
  bool tipLeaves() const;
};

/// Where one point of a wire goes at its height, mm, workpiece frame: along a line, or a circular arc.
struct WireTrack {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  Vec2 center = Vec2::Zero();  ///< arcs
  double sweep_rad = 0.0;      ///< signed, counterclockwise seen from +z; 0: a line
};

/// What the machine does with its wire during a motion.
struct WireState {
  bool threaded = true;  ///< false: it is cut off; the motion removes nothing and touches nothing
  /// A rapid between a stop and the next cut: the operator may cut the wire before it and thread it behind.
  bool by_hand = false;
  bool runs = true;       ///< it is drawn off, so that it does not burn through
  bool fluid = true;      ///< the gap is flushed
  bool condition = true;  ///< the generator has a cutting condition
};

/// A motion of a wire: a straight line through a point of the lower and one of the upper track, both at the
/// same share of their way (length on a line, angle on an arc). On an arc whose ends are not equally far from
/// the center the radius goes linearly with the angle.
struct WireSweep {
  double z_low = 0.0, z_high = 0.0;  ///< heights of the tracks, mm, z_low < z_high; the wire is longer
  WireTrack lower, upper;
  WireState state = {};
};

struct Motion {
  Vec3 from = Vec3::Zero();  ///< mm, workpiece frame
  Vec3 to = Vec3::Zero();    ///< mm, workpiece frame
  double feed = 0.0;         ///< mm/min along the path; 0 for rapids
  double time_s = 0.0;       ///< duration of this motion
  double spindle = 0.0;      ///< rpm, negative: M4, 0: stopped
  std::int32_t tool = 0;     ///< number of the tool in the spindle; 0: none named by the program
  std::int32_t arc = -1;     ///< index into Toolpath::arcs, or -1 for a line
  std::int32_t axis = -1;    ///< index into Toolpath::axes, or -1: tool along +z, no rotary axis
  std::int32_t wire =
      -1;  ///< index into Toolpath::wires, or -1: no wire; from and to are ends of its lower track
  /// kThread: angle of the spindle at the start, degrees, 0 <= angle < 360, counted from the marker pulse in
  /// the direction in which the spindle turns during this motion (the sign of `spindle`): k turns
  /// after the start the part stands at sign(spindle) * (thread_start_deg + 360 * k).
  float thread_start_deg = 0.0F;
  SourceRef source;
  MotionKind kind = MotionKind::kRapid;
  std::uint8_t channel = 0;  ///< number of the control's channel; 0: it has one
  bool compensated = false;  ///< the control keeps the path off the contour by a nose or cutter radius
  /// kThread: by which the lead grows with each turn, mm; 0: constant lead. After k of all n turns (see
  /// threadTurns()) the way is l k / n + change * k (k - n) / 2, l being its length along the axis that the
  /// lead is told of.
  float thread_pitch_change = 0.0F;

  MotionShape shape() const { return arc < 0 ? MotionShape::kLine : MotionShape::kArc; }
};

/// Receives what a virtual control does, in program order; of several channels in order of start times.
/// Called from one thread. `arc` is null for lines, `axis` where the tool is along +z and no rotary axis is
/// there; what is kept of them is copied. Motion::arc and Motion::axis have no meaning here.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  /// Called before the first motion of a file is sent. `index` counts from 0.
  virtual void file(std::uint32_t index, const std::string& name) = 0;
  virtual void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis = nullptr) = 0;
  /// A motion of a wire, in place of motion(). Sinks that know no wires leave it out.
  virtual void wireMotion(const Motion& /*motion*/, const WireSweep& /*wire*/) {}
  virtual void event(const PathEvent& event) = 0;
  virtual void diagnostic(const Diagnostic& diagnostic) = 0;

  // Rows of OriginTables, counted from 0 in the order of the calls; each comes before what refers to it.
  virtual void originWord(const WordOrigin& /*word*/) {}
  virtual void originData(const DataInForce& /*data*/) {}
  virtual void originModal(const ModalOrigins& /*modal*/) {}
  virtual void originSet(const OriginSet& /*set*/) {}
};

/// The whole path in memory.
struct Toolpath {
  std::vector<std::string> files;
  std::vector<Motion> motions;
  std::vector<ArcGeometry> arcs;
  std::vector<AxisSweep> axes;
  std::vector<WireSweep> wires;
  struct EventAt {
    MotionId before;  ///< index of the motion that follows the event
    PathEvent event;
  };
  std::vector<EventAt> events;
  OriginTables origins;
  Diagnostics diagnostics;
  std::uint64_t blocks = 0;  ///< executed blocks (set by the interpreter's caller)

  /// Point of motion `m` at parameter u in 0..1 (see ArcGeometry, PosedWay).
  Vec3 pointAt(const Motion& m, double u) const;
  /// Bounds of the control point's path, exact for arcs, a little wide where AxisSweep::tipLeaves().
  Box3 bounds(const Motion& m) const;
  /// Length of the control point's path, mm (spirals: to 1e-9 relative by Simpson's rule; see
  /// PosedWay::length()).
  double length(const Motion& m) const;
};

/// Turns of the spindle during a thread motion: its length / feed * |spindle|. 0 where the spindle or the
/// feed is 0, as for other motions. `motion` is one of the path or has its arc there.
double threadTurns(const Toolpath& path, const Motion& motion);

/// Sink that builds a Toolpath.
class ToolpathBuilder : public MotionSink {
 public:
  explicit ToolpathBuilder(Toolpath& path) : path_(path) {}
  void file(std::uint32_t index, const std::string& name) override;
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis = nullptr) override;
  void wireMotion(const Motion& motion, const WireSweep& wire) override;
  void event(const PathEvent& event) override;
  void diagnostic(const Diagnostic& diagnostic) override;
  void originWord(const WordOrigin& word) override;
  void originData(const DataInForce& data) override;
  void originModal(const ModalOrigins& modal) override;
  void originSet(const OriginSet& set) override;

 private:
  Toolpath& path_;
};

/// An orthonormal frame of an arc: `u` points from the axis to the start, `v` = normal x u.
struct ArcFrame {
  Vec3 u, v, n;
  double radius_start, radius_end;  ///< mm
  double rise;                      ///< mm along n from start to end
};
ArcFrame arcFrame(const Vec3& from, const Vec3& to, const ArcGeometry& arc);
/// Point of an arc at parameter t in 0..1.
Vec3 arcPoint(const ArcFrame& frame, const ArcGeometry& arc, double t);

}  // namespace proveout
