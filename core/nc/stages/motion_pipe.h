// The way of motions, functions and events from block to path: one carrier and a row of stages.
//
//   slot        space    what it does
//   contour     program  holds a block back while the next one may still move its end
//   transform   program  takes items to work space (mirror, scale, rotation, local shift)
//   corner      work     chamfers and roundings between two blocks
//   comp        work     cutter compensation
//   virtual     work     planes with a virtual axis: to the axes of the machine
//   frame       work     takes items to machine space (basic rotation, offsets)
//   axes        machine  exchanged, coupled and parked axes: from names to the axes that move
//   rapids      machine  rapids that overlap: rounded corners
//   zones       machine  areas that the axes must not enter
//   emit        machine  PathEmitter: motions and events of the path; look-ahead of speeds is behind it
//
// Items go through in program order, functions among the motions. A slot whose stage is not linked costs
// nothing: the stage before passes on to the one behind.
//
// To add a stage: derive from PathStage with its slot, make it a member of the channel's context, and link()
// it to the pipe where its mode begins, unlink() it where the mode ends and nothing waits in it (a stage may
// do so itself, inside push() and flush() too). push() handles an item and passes it on, or takes it
// (std::move) and passes it on later; items that are not its own (functions, other spaces) keep their place
// in the order. What it makes of one item it passes on as further items.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/nc/kinematics/axes.h"
#include "core/nc/kinematics/frames.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/pose_track.h"

namespace proveout::nc {

/// A motion as the stages know it; trivially copyable. Lengths mm.
struct PathMotion {
  enum class Kind : std::uint8_t {
    kLine,
    kArc,
    kStay,       ///< moves nothing by itself: cutter compensation may start or end here
    kCornerArc,  ///< arc of cutter compensation about the corner (G39)
    // Functions.
    kSpindle,
    kToolChange,
    kDwell,
    kEvent,
  };
  /// Coordinates of the points.
  enum class Space : std::uint8_t { kProgram, kWork, kMachine };
  /// What stands between this motion and the next.
  enum class Join : std::uint8_t { kSharp, kChamfer, kRound };
  /// Whether the corner with the block before is calculated, and which of two common points it is. kOpen: a
  /// line by its direction alone, whose end the next block calculates.
  enum class Meet : std::uint8_t { kNo, kOpen, kFirst, kSecond };

  Kind kind = Kind::kEvent;
  Space space = Space::kProgram;
  bool rapid = false;
  bool in_plane = false;  ///< a word of the plane's axes is in the block
  bool comp_on = false;   ///< cutter compensation in the block
  bool idle = false;      ///< kStay: tells compensation that a block without motion in the plane goes by
  bool keep_vector = false;
  std::uint8_t tip = 0;  ///< with compensation: code of the point that the path is told of, 0 to 9
  bool level = false;    ///< no axis outside the plane moves; told only of blocks with a join, and behind one
  Join join = Join::kSharp;
  Meet meet = Meet::kNo;
  double angle = 0.0;      ///< rad: of a line with `meet`
  double radius = 0.0;     ///< of an arc with `meet`; its sweep then only has the sign
  double join_size = 0.0;  ///< chamfer or radius, as programmed
  /// Of a block along one axis with a join: the next one has to go along the other axis, that way. 0: as it
  /// likes.
  std::int8_t join_turn = 0;
  WorkPlane plane;
  AxisPoint to;              ///< end; of functions the programmed position where they run
  Vec3 center;               ///< kArc: (u, v, w of the start) of the plane; in machine space x, y, z
  Vec2 start;                ///< kArc, lines with a join or `meet`: (u, v); not in machine space
  Vec3 normal;               ///< kArc in machine space only
  double sweep = 0.0;        ///< kArc: rad, signed, > 0 from u to v
  double offset = 0.0;       ///< of cutter compensation, > 0 left of the path
  double decimal = 0.0;      ///< with compensation: mm, to which the coordinates are rounded; 0: not known
  double rapid_speed = 0.0;  ///< of a rapid, mm/min along the way of all axes; 0: as fast as they can
  bool by_radius = false;    ///< kArc: its centre came from R
  bool in_polar = false;  ///< in machine space: a line or arc of the plane `polar`, the centre in that plane
  PolarPlane polar;
  std::optional<Vec2> direction;  ///< I, J of a block that switches compensation, or of G39; in the plane
  FeedStyle feed;

  bool function() const { return kind >= Kind::kSpindle; }
};

/// How the spindle goes from here on.
enum class SpindleState : std::uint8_t { kStopped, kClockwise, kCounterClockwise, kOriented, kPositionLoop };

/// One thing on its way to the path: a motion or a function.
struct PathItem : PathMotion {
  double value = 0.0;  ///< kSpindle: rpm, signed; kDwell, kEvent: s; kToolChange: number
  SpindleState spindle = SpindleState::kStopped;
  std::unique_ptr<EventKind> event;  ///< kEvent; kToolChange, kSpindle: what else its event tells
  std::unique_ptr<PoseTrack> pose;   ///< of a line in machine space: how it really goes
  SourceRef source;
  std::uint32_t record =
      0;                  ///< what the control remembers of the block for alarms that come late; 0: nothing
  std::uint64_t tag = 0;  ///< for a stage's own book-keeping

  /// The same motion, for a stage that makes several of one.
  PathItem copyMotion() const {
    PathItem copy;
    static_cast<PathMotion&>(copy) = *this;
    copy.source = source;
    copy.record = record;
    return copy;
  }
};

enum class StageSlot : std::uint8_t {
  kContour,
  kTransform,
  kCorner,
  kComp,
  kVirtual,
  kFrame,
  kAxes,
  kRapids,
  kZones,
  kEmit
};
inline constexpr std::size_t kStageSlots = 10;

/// Why stages have to let go what they hold.
enum class FlushReason : std::uint8_t {
  kTransform,  ///< program space changes: only what waits in it has to leave
  kBuffer,     ///< a code that ends look-ahead along the path
  kEnd,        ///< end of the program: everything
};

class MotionPipe;

/// One stage. Reports its own errors; false from push() and flush() means one was reported.
class PathStage {
 public:
  explicit PathStage(StageSlot slot) : slot_(slot) {}
  virtual ~PathStage() = default;
  PathStage(const PathStage&) = delete;
  PathStage& operator=(const PathStage&) = delete;

  /// The next item. It is the stage's to change and to take.
  virtual bool push(PathItem& item) = 0;
  /// Passes on what it holds, as the reason asks.
  virtual bool flush(FlushReason) { return true; }
  /// After flush(kBuffer): the machine stands at `work` by other means than items, or the frames changed.
  virtual void rebase(const AxisPoint& /*work*/, const WorkPlane& /*plane*/) {}
  /// Forgets what it holds, and its mode: the run goes on behind an error.
  virtual void clear() {}

  StageSlot slot() const { return slot_; }
  bool linked() const { return linked_; }

 protected:
  bool pass(PathItem& item) { return next_->push(item); }

 private:
  friend class MotionPipe;
  StageSlot slot_;
  bool linked_ = false;
  PathStage* next_ = nullptr;
};

/// The row of stages of a channel. Stages must outlive it or be unlinked.
class MotionPipe {
 public:
  void link(PathStage& stage);
  void unlink(PathStage& stage);

  bool push(PathItem& item) { return first_->push(item); }
  /// First stage to last. Stops at an error.
  bool flush(FlushReason reason);
  void rebase(const AxisPoint& work, const WorkPlane& plane);
  void clear();

 private:
  void join();

  std::array<PathStage*, kStageSlots> stages_{};
  PathStage* first_ = nullptr;
};

/// Work space to machine space.
class FrameStage final : public PathStage {
 public:
  explicit FrameStage(const CoordinateChain& chain) : PathStage(StageSlot::kFrame), chain_(chain) {}
  bool push(PathItem& item) override;

 private:
  const CoordinateChain& chain_;
};

/// The end of the pipe: items become motions and events of the path.
class EmitStage final : public PathStage {
 public:
  EmitStage(PathEmitter& emitter, double tool_change_s)
      : PathStage(StageSlot::kEmit), emitter_(emitter), tool_change_s_(tool_change_s) {}
  bool push(PathItem& item) override;

 private:
  void function(PathItem& item);
  void polar(const PathItem& item);

  PathEmitter& emitter_;
  double tool_change_s_;
};

}  // namespace proveout::nc
