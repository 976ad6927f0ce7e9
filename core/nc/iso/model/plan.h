// One block on its way from words to deeds.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <variant>

#include "core/nc/control/channels.h"
#include "core/nc/iso/model/codes.h"
#include "core/nc/iso/model/cycle_plan.h"
#include "core/nc/iso/model/frame_plan.h"
#include "core/nc/iso/model/measuring_plan.h"
#include "core/nc/iso/model/motion_plan.h"
#include "core/nc/iso/model/offset_plan.h"
#include "core/nc/iso/model/state.h"
#include "core/nc/iso/model/tilt_plan.h"
#include "core/nc/iso/model/tool_plan.h"
#include "core/nc/iso/model/zone_plan.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/services/arcs.h"
#include "core/nc/stages/motion_pipe.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

struct BlockPlan;
struct MFunction;
struct IsoContext;

/// Carries a planned block out. False: an error was reported.
using PerformFunction = bool (*)(IsoContext&, BlockPlan&);

/// What a plan function leaves for its perform function. A chapter adds its struct, which owns no memory.
using PlanPayload =
    std::variant<std::monostate, Dwell, MachineMove, ThreadStart, CurveMove, Smoothing, SkipMove, LengthMove,
                 Holes, ZoneChange, OffsetChange, FrameChange, ToolTableInput, TiltInput>;
static_assert(std::is_trivially_destructible_v<PlanPayload>);

/// What the motion codes share: axisTarget() fills target and named, the rest belongs to the motion.
struct PlannedMotion {
  AxisPoint target;  ///< programmed end, in the plan's chain
  AxisSet named;     ///< axes with a word
  bool rapid = false;
  bool is_arc = false;
  bool by_radius = false;  ///< of an arc: its centre came from R
  PlaneArc arc;
  FeedStyle feed;
  double polar_turn_deg = 0.0;    ///< of a polar angle word: from the old angle to the new one
  std::optional<Vec2> direction;  ///< I, J of a G40/G41/G42 or G39 block, in the plane, mm
  PathMotion::Join join = PathMotion::Join::kSharp;
  PathMotion::Meet meet = PathMotion::Meet::kNo;
  double join_size = 0.0;            ///< mm
  int join_turn = 0;                 ///< see PathMotion
  double angle = 0.0, radius = 0.0;  ///< of over-determined blocks, see PathMotion
  std::optional<Vec3> tool_vector;   ///< I, J, K of G43.5, as programmed, any length
  bool about_tip = false;            ///< the tip is held on its way while rotary axes turn (G53.6)
  double pivot_mm = 0.0;             ///< with it: from the point that is held to the tip, along the tool
};

/// Plain motion blocks that agree in these have words for the same things.
struct WordPattern {
  AddressSet letters;
  KindSet codes;
  const GCode* governor = nullptr;
  std::int32_t distance = 0, units = 0;  ///< codes in force, tenfold
  bool operator==(const WordPattern&) const = default;
};
/// Patterns of the last blocks and what their words are for.
struct WordPatterns {
  struct Entry {
    WordPattern pattern;
    KindSet kinds, steps;
  };
  std::array<Entry, 16> entries;
  const Entry* last = nullptr;  ///< of the block before; null: it had none
};

/// Lines of the program in hand, by index: from `first` to the one in front of `end`.
struct LineRange {
  std::size_t first = 0, end = 0;
};

struct BlockPlan {
  /// `state`: of the control before the block.
  explicit BlockPlan(const IsoState& state) : next(state) {}
  BlockPlan(const BlockPlan&) = delete;  // `chain` may point into it
  BlockPlan& operator=(const BlockPlan&) = delete;

  IsoState next;
  bool frames_changed = false;
  bool transforms_changed = false;  ///< mirroring, scaling, rotation
  bool flush = false;
  const CoordinateChain* chain = nullptr;    ///< in force for the block's motion
  std::optional<CoordinateChain> new_chain;  ///< where one of these changed: what `chain` points to
  /// Of the way by which the length changes: what only moves the coordinates. The rest is held.
  AxisPoint length_shift;
  AxisPoint start;                                   ///< programmed position at the block's start, in `chain`
  const GCode* governor = nullptr;                   ///< the code that owns the axis words
  std::array<const GCode*, kGroupCount> by_group{};  ///< G codes of this block
  bool exact_stop = false;                           ///< G9 in this block
  bool any_group = false;                            ///< one of them at least is there
  KindSet code_kinds;                                ///< what these codes are for
  AddressSet claimed;                                ///< words that some code of the block owns
  std::array<const MFunction*, 8> m{};               ///< rows of the M index
  std::array<int, 8> m_value{};
  int m_count = 0;
  std::optional<LineRange> lines;    ///< run behind the deed as a part of the block
  std::optional<std::size_t> go_on;  ///< index of the line of its program that follows; none: the next one
  const MCode* flow = nullptr;       ///< M98, M99, M2, M30
  int wait_code = 0;                 ///< waiting code of the block; 0: none
  ChannelSet wait_whom;              ///< with it: the channels that meet
  std::bitset<3> auxiliary;          ///< auxiliary functions of the block (N1333 to N1335)
  bool spindle_changed = false;
  /// What S or a spindle's position means in this block.
  struct Spindle {
    int index = -1;  ///< the spindle; -1: none is named
    int gear = 0;    ///< chosen for its speed; 0: none
    bool turns = false;
    double rpm = 0.0, turn_deg = 0.0;
  } spindle;
  bool tool_change = false;
  bool tool_called = false;  ///< T in this block
  bool tool_shape = false;   ///< D of a row that has a corner radius: the shape of the tool

  /// Null: nothing moves (cutter compensation may still start or end on the spot).
  PerformFunction perform = nullptr;
  PlanPayload payload;
  /// The deed leaves the machine or its frames elsewhere: cutter compensation starts anew from there.
  bool rebases = false;
  /// The deed itself carries out the functions that stand before it (drilling: at the first hole).
  bool runs_functions = false;

  PlannedMotion motion;
};

}  // namespace proveout::nc
