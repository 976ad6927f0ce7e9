// The nct milling control: runs a program block by block. Block life: lex, collect codes, plan (all checks,
// on a copy of the modal state), execute (emit motions and events), commit.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/nc/frames.h"
#include "core/nc/interpreter.h"
#include "core/nc/lexer.h"
#include "core/nc/nct/nct_codes.h"
#include "core/nc/nct/nct_parameters.h"
#include "core/nc/path_emitter.h"
#include "core/nc/services/arcs.h"
#include "core/nc/services/cutter_comp.h"
#include "core/nc/services/drilling.h"
#include "core/nc/services/plane_frame.h"
#include "core/nc/source_text.h"

namespace proveout::nc {

/// Words of a drilling cycle that stay in force until the cycle ends. Lengths mm, raw as programmed.
struct CycleWords {
  std::optional<double> r, bottom;
  bool r_incremental = false, bottom_incremental = false;
  double initial = 0.0;  ///< drill axis, program coordinates, at entry
  int drill_axis = 2;
  double peck = 0.0;
  std::optional<double> clearance;
  double dwell = 0.0;
  std::array<double, 3> shift{};  ///< I, J, K, mm
  std::optional<double> retract_percent;
};

/// Everything that a block may change and that stays. A value: blocks work on a copy.
struct NctState {
  std::array<std::int16_t, kGroupCount> active{};  ///< code10 of each group
  WorkSystemId work_system = 1;
  double feed = 0.0;          ///< F as programmed
  double spindle_rpm = 0.0;   ///< S
  int spindle_direction = 0;  ///< +1 M3, -1 M4, 0
  int tool = 0, next_tool = -1;
  int h = 0, d = 0;
  double h_value = 0.0;        ///< mm, read when H was executed
  double d_radius = 0.0;       ///< mm, read when D was executed
  Vec3 length = Vec3::Zero();  ///< length offset in force, machine axes, mm
  CycleWords cycle;

  Plane plane() const {
    const int g = active[kGroupPlane];
    return g == 180 ? Plane::kZX : g == 190 ? Plane::kYZ : Plane::kXY;
  }
  bool incremental() const { return active[kGroupDistance] == 910; }
  bool perTurn() const { return active[kGroupFeedMode] == 950; }
  double unitScale() const { return active[kGroupUnits] == 200 ? 25.4 : 1.0; }
  bool inCycle() const { return active[kGroupCycle] != 800; }
  /// Signed offset of cutter compensation: > 0 left of the path.
  double compOffset() const {
    const int g = active[kGroupRadiusComp];
    return g == 410 ? d_radius : g == 420 ? -d_radius : 0.0;
  }
  bool compOn() const { return active[kGroupRadiusComp] != 400; }
  double signedSpindle() const { return spindle_rpm * spindle_direction; }
};

/// Something to do that may have to wait for cutter compensation's look-ahead.
struct Action {
  enum class Kind { kMove, kSpindle, kToolChange, kDwell, kEvent };
  Kind kind = Kind::kMove;
  bool rapid = false;
  FeedStyle feed;
  double value = 0.0;  ///< kSpindle: rpm, signed; kDwell: s; kToolChange: number
  std::string name;    ///< kEvent: its name; kSpindle: "cw", "ccw", "stop"
  PathEmitter::EventData data;
  SourceRef source;
  std::uint64_t tag = 0;
};

/// One block on its way from words to deeds.
struct BlockPlan {
  NctState next;
  bool frames_changed = false;
  bool flush = false;
  CoordinateChain chain;                             ///< in force for the block's motion
  Vec3 start = Vec3::Zero();                         ///< programmed position at the block's start, in `chain`
  const GCode* governor = nullptr;                   ///< the code that owns the axis words
  std::array<const GCode*, kGroupCount> by_group{};  ///< G codes of this block
  AddressSet claimed;                                ///< words that some code of the block owns
  std::array<const MCode*, 8> m{};
  std::array<int, 8> m_value{};
  int m_count = 0;
  const MCode* flow = nullptr;  ///< M98, M99, M2, M30
  bool spindle_changed = false;
  bool tool_change = false;

  enum class Deed { kNone, kMove, kDwell, kMachineMove, kReference, kCycle, kFrames, kOffsets };
  Deed deed = Deed::kNone;
  Vec3 target = Vec3::Zero();   ///< programmed end, in `chain`; kMachineMove, kReference: machine point
  Vec3 via = Vec3::Zero();      ///< kReference: intermediate point, programmed
  std::array<bool, 3> named{};  ///< axes with a word
  bool rapid = false;
  bool is_arc = false;
  PlaneArc arc;
  FeedStyle feed;
  double dwell_s = 0.0;
  std::optional<Vec2> direction;  ///< I, J of a G40/G41/G42 block, in the plane, mm
  std::optional<WorkFrames> frames;
  int offset_row = 0;
  int offset_table = 0;  ///< L of G10: 10, 11, 12, 13
  double offset_value = 0.0;
  Vec3 cycle_step = Vec3::Zero();  ///< hole position or step per axis
  std::array<bool, 3> cycle_incremental{};
  std::int64_t repeat = 1;
};

class NctControl {
 public:
  NctControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress);
  InterpretSummary run();

  // Plan functions, named in the code table.
  bool planRapid(BlockPlan& plan);
  bool planLine(BlockPlan& plan);
  bool planArc(BlockPlan& plan);
  bool planDwell(BlockPlan& plan);
  bool planOffsets(BlockPlan& plan);
  bool planReference(BlockPlan& plan);
  bool planLocalShift(BlockPlan& plan);
  bool planMachineMove(BlockPlan& plan);
  bool planSetPosition(BlockPlan& plan);
  bool planCycle(BlockPlan& plan);

 private:
  struct CallFrame {
    SourceText* text = nullptr;
    std::uint32_t file = 0;
    std::size_t line = 0;  ///< index of the next line
    std::int64_t total = 1, done = 0;
    std::int64_t return_block = -1;
  };
  enum class Go { kOn, kStop };

  // Program flow: nct_control.cpp, nct_flow.cpp
  bool loadMain();
  SourceText* load(const ProgramText& text, std::uint32_t& file);
  Go step();
  Go endOfText();
  Go execute();
  Go flow(const BlockPlan& plan);
  Go call();
  bool calledProgram(SubprogramQuery& query);
  Go returnFrom();
  Go alarm();
  Go finish(const std::string& code, ProgramEnd end);
  bool checkHeader();
  bool onlyHeaderAbove() const;
  bool skipKeepsLookAhead();
  bool jump(CallFrame& frame, std::int64_t block);
  bool reachedUntil() const;
  void resetState();

  // Planning: nct_block.cpp
  bool planBlock(BlockPlan& plan);
  bool collectG(BlockPlan& plan);
  bool collectM(BlockPlan& plan);
  bool acceptG(BlockPlan& plan, const Word& word);
  bool refuseG(const Word& word, const GCode* code);
  bool planModal(BlockPlan& plan);
  bool claim(BlockPlan& plan, const GCode& code);
  bool planNumbers(BlockPlan& plan);
  bool planOffsetsHD(BlockPlan& plan);
  bool planLength(BlockPlan& plan);
  bool planToolOffset(BlockPlan& plan, int kind, const Word& p);
  bool planWorkOffset(BlockPlan& plan, int kind, const Word& p);
  bool planWorkSystem(BlockPlan& plan);
  bool planComp(BlockPlan& plan);
  bool govern(BlockPlan& plan);
  bool checkWords(const BlockPlan& plan);
  bool integerWord(const Word& word, std::int64_t min, std::int64_t max, std::int64_t& out);

  // Words: nct_block.cpp
  const Word* word(Address a) const { return block_.find(a); }
  /// The word if it does not belong to another code of the block.
  const Word* ownWord(const BlockPlan& plan, Address a) const {
    return plan.claimed.has(a) ? nullptr : block_.find(a);
  }
  double lengthOf(const BlockPlan& plan, const Word& w) const { return w.value * plan.next.unitScale(); }
  bool axisTarget(BlockPlan& plan, Vec3& target);
  bool anyAxisWord() const { return !(block_.present & AddressSet("XYZUVW")).empty(); }
  bool feedStyle(BlockPlan& plan, FeedStyle& style);
  double radiusTolerance() const;
  bool arcRequest(const BlockPlan& plan, ArcRequest& request);
  bool failArc(const ArcResolution& resolved);
  double turnsPerMinute(const BlockPlan& plan);

  // Execution: nct_execute.cpp
  bool perform(BlockPlan& plan);
  bool performDeed(BlockPlan& plan);
  bool performFunctions(BlockPlan& plan, MPhase phase);
  bool function(const BlockPlan& plan, int m);
  bool switchCompInPlace(BlockPlan& plan);
  void setSpindleAction(Action& action, double rpm) const;
  bool act(Action action, const NctState& state);
  void run(Action& action);
  bool moveTo(BlockPlan& plan);
  void emitMove(const Action& action, const Vec3& to_machine, const PlaneArc* arc,
                const CoordinateChain& chain);
  bool performReference(BlockPlan& plan);
  bool performCycle(BlockPlan& plan);
  bool planCycleWords(BlockPlan& plan);
  bool planCycleVectors(BlockPlan& plan, DrillCode code);
  bool checkCycle(const BlockPlan& plan, DrillCode code);
  void cycleEvent(BlockPlan& plan, const DrillStep& step);
  bool expandCycle(BlockPlan& plan);
  bool cycleHole(BlockPlan& plan, Vec3 hole, bool first);
  bool cycleStep(BlockPlan& plan, const DrillStep& step, Vec3& at);
  void setFrames(const BlockPlan& plan);
  void settle(const Vec3& machine);
  bool overLimit();

  // Cutter compensation: nct_comp.cpp
  bool engageComp(const BlockPlan& plan);
  bool pushComp(const CompBlock& block, Action action);
  bool flushComp();
  void rebaseComp();
  bool drainComp(const CompStatus& status);
  void runPiece(const CompPiece& piece, Action& action);
  Vec3 workPlanePosition() const;

  // Reports
  bool fail(std::string code, std::string message, Columns columns = {});
  bool failWord(std::string code, std::string message, const Word& word) {
    return fail(std::move(code), std::move(message), word.columns);
  }
  void warn(std::string code, std::string message, Columns columns = {},
            Severity severity = Severity::kWarning);
  void warnOnce(const std::string& key, std::string code, std::string message, Columns columns = {});
  void report(Severity severity, std::string code, std::string message, Columns columns);
  Diagnostic diagnosticAt(Severity severity, std::string code, std::string message, const SourceRef& at,
                          Columns columns) const;
  SourceRef here() const;

  const ProgramSource& source_;
  const ControlSettings& settings_;
  MotionSink& sink_;
  Progress* progress_;
  InterpretSummary summary_;
  PathEmitter emitter_;
  NctParameters parameters_;
  Lexer lexer_;
  Block block_;

  std::vector<std::unique_ptr<SourceText>> texts_;  ///< by file index
  std::unordered_map<std::string, std::uint32_t> text_by_path_;
  std::unordered_map<std::string, std::uint32_t> text_by_call_;  ///< caller and name -> file
  std::vector<CallFrame> stack_;
  std::size_t line_index_ = 0;  ///< of the block in hand
  bool until_hit_ = false;
  std::uint64_t work_ = 0;  ///< blocks and repeated holes, against the block limit

  NctState state_;
  WorkFrames frames_;
  CoordinateChain chain_;
  Vec3 position_ = Vec3::Zero();  ///< programmed, in chain_
  Vec3 machine_ = Vec3::Zero();   ///< programmed point in machine coordinates, without cutter compensation
  std::map<int, OffsetValue> length_table_, radius_table_;

  CutterComp comp_;
  bool comp_engaged_ = false;
  CompOutput comp_out_;
  std::deque<Action> waiting_;  ///< actions inside comp_, by tag
  std::uint64_t next_tag_ = 1;

  std::vector<DrillStep> steps_;
  std::set<std::string> warned_;
};

/// Nesting of subprogram calls (manual 14.4.2).
inline constexpr std::size_t kMaxNesting = 16;

}  // namespace proveout::nc
