// Cutter radius compensation in the working plane with bounded look-ahead.
//
// Input: the programmed blocks in order, in plane coordinates (plane_frame.h), after every transformation.
// Output: the path of the tool centre as pieces in order; consecutive pieces join without gaps. Rules: NCT
// milling manual 15.5 (digest nct-3, section 3); what differs between controls is in CutterCompPolicy.
//
// Use: reset(position); push() every block from the one that switches compensation on up to and with the one
// that switches it off (blocks pushed while it is off go straight through); flush() before anything that
// stops look-ahead, and at the end of the program. Pieces of a block may come out several pushes later: what
// else the block does has to wait for its pieces, so push functions, dwells and moves outside the plane as
// kNone blocks.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

enum class CompError {
  kNone,
  kStartInArc,       ///< compensation switched on in a circular block
  kCancelInArc,      ///< compensation switched off in a circular block
  kNoIntersection,   ///< inner corner whose offset curves do not meet
  kInterference,     ///< compensated path runs against the programmed one
  kBufferFull,       ///< too many blocks without plane motion in a row
  kSideChange,       ///< change of side that has no solution
  kCornerArcInside,  ///< corner arc block on an inner corner, or without a block before or after it
  kNotActive,        ///< keep-vector or corner-arc block while compensation is off
  kNotFinite,        ///< an input is NaN or infinite
};

enum class CompWarning {
  kRepaired,         ///< interference repaired by leaving out blocks; tag: the first block left out
  kNearTangent,      ///< nearly tangent inner corner without intersection, joined by a short line
  kManyPassThrough,  ///< more blocks without plane motion than the control promises to look over
};

enum class CompRamp { kA, kB };  ///< how compensation starts and ends at outer corners (A direct, B around)
enum class CompOuterCorner {
  kLines,  ///< offset tangents, met or prolonged by the radius
  kArc,    ///< arc about the corner
};

struct CutterCompPolicy {
  CompRamp start_ramp = CompRamp::kB;
  CompRamp cancel_ramp = CompRamp::kB;
  CompOuterCorner outer_corner = CompOuterCorner::kLines;
  double arc_threshold = 0.0;  ///< mm; corners whose arc would have a shorter chord, or this one, get none
  double arc_least_turn_rad = 0.0;  ///< corners that turn by less get no arc
  bool switch_in_arc = false;       ///< compensation may begin and end in an arc, which becomes a spiral
  bool interference_check = true;
  bool interference_alarm = false;  ///< true: always alarm; false: leave out blocks where that mends it
  int extra_look_ahead = 0;         ///< 0..8 further elements seen by the interference check
  /// mm; what the cutter does not reach of the contour by no more than this, or would cut in to reach it, is
  /// rounding of coordinates and no interference: the path goes past it, blocks that the cutter does not
  /// touch have no motion. Points rounded to a decimal q are up to q / sqrt(2) off on either side, hence 2 q:
  /// for blocks with a coarser decimal than half of this twice that one counts. 0: off.
  double rounding_tolerance = 0.002;
  double min_step = 0.001;     ///< mm, neighbouring corner points closer than this in u and v are merged
  int max_pass_through = 100;  ///< blocks without plane motion in a row

  // Rules of other controls than nct.
  bool start_waits = false;   ///< switched on in a block without plane motion, the next motion is the way in
  bool cancel_waits = false;  ///< switched off without plane words, the next motion is the way out
  int most_idle = 0;  ///< blocks without plane motion (idle()) that a corner is looked for beyond; 0: any
  bool flush_square = false;  ///< flush() ends the last element square on its offset
  bool keeps_vector = false;  ///< rebase() moves the tool centre along, see forgetVector()
  bool contour_check = true;  ///< corners that would cut into what follows are mended where that is rounding
  bool chord_check = true;    ///< ways over several blocks may not run against the programmed ones
  bool arc_needs_room = false;      ///< an arc inside with the radius of the cutter is interference too
  bool square_side_change = false;  ///< a change of side without intersection goes from square to square
};

/// One programmed block.
struct CompBlock {
  enum class Shape {
    kNone,  ///< no plane axis word: function, dwell, move outside the plane
    kLine,  ///< plane axis words; may have no displacement
    kArc,
    kCornerArc,  ///< no motion words; arc about the corner (G39)
  };
  Shape shape = Shape::kNone;
  Vec3 to = Vec3::Zero();      ///< programmed end (u, v, w), mm; of kNone and kCornerArc only w counts
  Vec2 center = Vec2::Zero();  ///< kArc, mm
  double sweep_rad = 0.0;      ///< kArc, signed, > 0 counter-clockwise, more than a turn is allowed
  bool active = false;         ///< compensation on in this block
  double offset = 0.0;         ///< mm, > 0: tool left of the path, < 0: right; 0 allowed while active
  double decimal = 0.0;        ///< mm, > 0: to which its coordinates are rounded; 0: not known
  /// In-plane centre words of a line or kNone block that switches on or off (direction of the auxiliary
  /// line), or of a kCornerArc block (direction of the path after the corner).
  std::optional<Vec2> direction;
  bool keep_vector = false;  ///< the block ends with the vector that it began with (G38)
  std::uint64_t tag = 0;     ///< the caller's; comes back with each piece
};

/// A piece of the tool centre's path, or the place where a block without plane motion is to be carried out.
struct CompPiece {
  enum class Role {
    kOwn,          ///< the block's own compensated motion
    kCorner,       ///< inserted: start-up move, corner, corner arc; belongs to block `tag`
    kPassThrough,  ///< carry out the kNone block `tag` here; from and to differ in w at most
  };
  Role role = Role::kOwn;
  bool is_arc = false;
  Vec3 from = Vec3::Zero();    ///< (u, v, w), mm
  Vec3 to = Vec3::Zero();      ///< (u, v, w), mm
  Vec2 center = Vec2::Zero();  ///< arcs, mm; radius, angle and w go linearly together, as in PlaneArc
  double sweep_rad = 0.0;      ///< arcs, signed
  std::uint64_t tag = 0;
};

struct CompNote {
  CompWarning warning = CompWarning::kRepaired;
  std::uint64_t tag = 0;
};

/// Receives what push() and flush() make; they append. The caller clears it.
struct CompOutput {
  std::vector<CompPiece> pieces;
  std::vector<CompNote> notes;
  void clear() {
    pieces.clear();
    notes.clear();
  }
};

struct [[nodiscard]] CompStatus {
  CompError error = CompError::kNone;
  std::uint64_t tag = 0;       ///< the offending block
  std::uint64_t stop_tag = 0;  ///< the block before which (kNoIntersection: in which) the control stops
  bool ok() const { return error == CompError::kNone; }
};

namespace comp_detail {

/// A block without plane motion that waits for the element before it.
struct PassThrough {
  double w = 0.0;  ///< mm, after the block
  std::uint64_t tag = 0;
};

/// The points that the tool centre visits between two elements.
struct Corner {
  std::vector<Vec2> points;  ///< at least one unless `error` is set
  bool arc_join = false;     ///< from the first to the last point by an arc about the corner
  bool chord_arc = false;    ///< change of side: the arc before runs with its programmed radius
  bool near_tangent = false;
  CompError error = CompError::kNone;
};

enum class ElementKind { kLine, kArc, kZero, kCornerArc };
enum class ElementPhase { kStartUp, kInside, kCancel };

/// A block that takes part in the look-ahead.
struct Element {
  ElementKind kind = ElementKind::kLine;
  ElementPhase phase = ElementPhase::kInside;
  bool keep_vector = false;
  bool perpendicular_start = false;  ///< first element after a start without plane words
  bool pivot = false;                ///< the cutter touches nothing of it but its start point
  bool square_end = false;           ///< it ends square on its offset, whatever follows
  Vec3 p0 = Vec3::Zero(), p1 = Vec3::Zero();
  Vec2 center = Vec2::Zero();
  double sweep = 0.0;
  double decimal = 0.0;                   ///< mm, to which it is rounded; 0: not known
  double rho_start = 0.0, rho_end = 0.0;  ///< signed offset that rules the start and the end corner
  std::optional<Vec2> direction;
  std::uint64_t tag = 0;
  std::vector<PassThrough> after;
  std::optional<Corner> corner;  ///< between this element and the next, once known

  bool plain() const {
    return phase == ElementPhase::kInside && !keep_vector &&
           (kind == ElementKind::kLine || kind == ElementKind::kArc);
  }
};

struct RollPlace;

}  // namespace comp_detail

/// Not thread-safe; one owner. After an error only reset() makes sense, and halt() where push() refused the
/// block: that leaves the blocks before it as they are. Copyable.
class CutterComp {
 public:
  explicit CutterComp(const CutterCompPolicy& policy = {}) : policy_(policy) {}

  /// Forgets everything; compensation off; tool centre and programmed point at `position` (u, v, w).
  void reset(const Vec3& position);

  /// Takes the next block; appends the pieces that are certain by now.
  CompStatus push(const CompBlock& block, CompOutput& out);

  /// Ends look-ahead: the last element runs to its programmed end, its vector becomes 0, everything comes
  /// out. Compensation stays on; the next element starts at the programmed point and ends on its normal
  /// corner.
  CompStatus flush(CompOutput& out);

  /// Ends look-ahead before a block that was refused, or that the caller refuses: all blocks before it come
  /// out, the last one to the end of its offset. On the way in that end is perpendicular to the start of
  /// `refused`, if it has a direction. Only reset() makes sense behind it.
  CompStatus halt(const CompBlock& refused, CompOutput& out);

  /// After flush(), or while inactive: the machine has moved by other means (reference point, new origin).
  void rebase(const Vec3& position);

  /// A block without plane motion has gone by, whatever it was pushed as (most_idle).
  void idle();

  /// After flush(): the machine has moved without compensation. The next motion is a way in again.
  void forgetVector();

  bool active() const { return active_; }              ///< on, as of the last block pushed
  bool pending() const { return !elements_.empty(); }  ///< blocks still wait
  /// Compensation is off and the tool still beside the path: the next motion is the way out.
  bool displaced() const;
  const Vec3& programmed() const { return programmed_; }  ///< end of the last block pushed
  const Vec3& center() const { return center_; }          ///< end of the last piece that came out

 private:
  using Element = comp_detail::Element;
  using Corner = comp_detail::Corner;

  CompStatus passThrough(const CompBlock& block, CompOutput& out);
  CompStatus uncompensated(const CompBlock& block, CompOutput& out);
  CompStatus leave(const CompBlock& block, CompOutput& out);
  bool startWaits(const CompBlock& block) const;
  bool standsStill(const CompBlock& block) const;
  bool lacksRoom(std::size_t index) const;
  Element makeElement(const CompBlock& block) const;
  CompStatus checkBlock(const CompBlock& block) const;
  CompStatus process(bool drain, CompOutput& out);
  CompStatus finishFront(CompOutput& out);
  const Corner& cornerAfter(std::size_t index);
  Vec2 startOf(std::size_t index);
  Vec2 frontStart() const;

  CompStatus checkInterference(CompOutput& out);
  CompStatus checkFront(CompOutput& out);
  std::size_t lookAhead() const;
  std::size_t lastOfRun() const;
  double roundingTolerance() const;
  bool waitsForContour() const;
  bool missesContour();
  bool frontRunsBackwards();
  std::optional<comp_detail::RollPlace> rollStart() const;
  bool rollsOver(std::size_t index);
  void endFrontAt(const comp_detail::RollPlace& stop, std::size_t last, Corner corner);
  std::size_t firstInterference(bool& by_chord);
  bool repairableLater(std::size_t k);
  bool repair(std::size_t k, bool extend, CompOutput& out);
  void dropBehindFront(std::size_t count, Corner corner);

  void emitFront(CompOutput& out);
  void emitOwn(const Element& element, const Corner& corner, CompOutput& out);
  void emitCorner(const Element& element, const Corner& corner, CompOutput& out);
  void emitLine(const Vec3& to, CompPiece::Role role, std::uint64_t tag, CompOutput& out);
  void emitArc(const Vec3& to, const Vec2& center, double sweep, CompPiece::Role role, std::uint64_t tag,
               CompOutput& out);
  void emitPassThrough(const comp_detail::PassThrough& pass, CompOutput& out);

  CutterCompPolicy policy_;
  bool active_ = false;
  bool start_pending_ = false;  ///< switched on without plane words; the next element starts perpendicular
  double last_offset_ = 0.0;    ///< of the last element
  bool starts_anew_ = false;    ///< the next element is a way in although compensation is on
  int pass_through_run_ = 0;
  int idle_run_ = 0;
  std::uint64_t last_motion_tag_ = 0;
  Vec3 programmed_ = Vec3::Zero();
  Vec3 center_ = Vec3::Zero();
  std::deque<Element> elements_;
};

}  // namespace proveout
