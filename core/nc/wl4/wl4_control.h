// The WL4 control, milling and turning: runs a program block by block (digest wl4). Block life: read
// (variables are assigned on the way), plan on a copy of the modal state, perform, commit.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/nc/block_budget.h"
#include "core/nc/contour_stage.h"
#include "core/nc/control_host.h"
#include "core/nc/control_settings.h"
#include "core/nc/loop_watch.h"
#include "core/nc/motion_pipe.h"
#include "core/nc/origin_recorder.h"
#include "core/nc/program_source.h"
#include "core/nc/run_summary.h"
#include "core/nc/services/arcs.h"
#include "core/nc/services/contour_offset.h"
#include "core/nc/services/contour_passes.h"
#include "core/nc/wl4/wl4_block.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_comp_stage.h"
#include "core/nc/wl4/wl4_programs.h"
#include "core/nc/wl4/wl4_state.h"
#include "core/nc/wl4/wl4_variables.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

class Wl4Control final : private Wl4System, private ContourReport, private Wl4CompReport {
 public:
  Wl4Control(bool lathe, const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress, const ControlHost& host);
  InterpretSummary run();

 private:
  enum class Go : std::uint8_t {
    kOn,
    kReturn,  ///< from the subprogram
    kStop     ///< the run is over
  };
  /// An open program.
  struct Level {
    const Wl4Program* program = nullptr;
    std::size_t line = 0;  ///< of the block in hand
    std::int64_t number = -1;
    std::uint64_t run = 0;  ///< number of the call
  };
  /// What a block does. `next` is the state behind it.
  struct Plan {
    Wl4State next;
    int deed = 0;
    bool exact_stop = false, measures = false, cycle_off = false;
    bool moves = false;  ///< words of axes that are to move, even by nothing
    AxisSet named;       ///< axes with such a word
    AxisPoint target;    ///< machine coordinates
    double chamfer = 0.0;
  };

  // wl4_control.cpp: the run loop
  bool start();
  Go runProgram(const Wl4Program& program);
  Go endOfText(const Wl4Program& program);
  Go block(std::size_t& next_line);
  Go execute(std::size_t& next_line);
  bool carryOut(Plan& p);
  bool isOwnError(std::size_t here) const;
  Go failed();
  Go finish(const std::string& code, ProgramEnd end);
  bool workOver();
  bool goesRound();
  bool reachedUntil() const;
  Go call(const std::string& name, int times);
  Go jump(std::int64_t label, std::size_t& next_line);
  Go subprograms();

  // wl4_plan.cpp: all checks of a block
  bool plan(Plan& p);
  /// G76, and G77 and G78 with P and Q.
  bool isContourCycle(int deed) const;
  bool planCodes(Plan& p);
  void planCode(Plan& p, const Wl4GCode& code);
  void selectTool(Wl4State& s, int number) const;
  bool planWords(Plan& p);
  bool planLengths(Plan& p);
  bool planMirror(Plan& p);
  bool planOffsets(Plan& p);
  bool planAxes(Plan& p);
  bool planAxis(Plan& p, int axis, char absolute, char incremental);
  bool planSetSystem(Plan& p);
  bool checkFunctions();
  void remember(Plan& p);

  // wl4_motion.cpp: motions
  bool move(const Plan& p);
  bool straight(const Plan& p, bool rapid);
  bool arc(const Plan& p);
  bool arcOf(const Plan& p, PlaneArc& arc, bool& moves);
  bool corner(const Plan& p);
  bool cornerOf(const Plan& p, Vec2& center, double& sweep);
  bool thread(const Plan& p);
  bool referenceMove(const Plan& p);
  bool measure(const Plan& p);
  bool touch(const Plan& p, const PathItem& item, double& part, bool& touched);
  bool thereAndBack(const Plan& p, PathItem& item, double part, bool touched);
  bool dwell();
  bool pushArc(const Plan& p, const Vec2& center, double sweep);
  void fill(const Plan& p, PathItem& item) const;
  bool send(const Plan& p, PathItem& item);
  bool feedOf(const Plan& p, FeedStyle& feed);
  PlaneFrame plane(const Wl4State& s) const;
  bool flipped(const Wl4State& s) const;
  double compRadius(const Wl4State& s) const;
  /// Of the touch-off point from the nose centre, (z, x), mm.
  Vec2 tipOf(const Wl4State& s) const;

  // wl4_functions.cpp: M, S, T
  bool functions(Plan& p, Wl4Phase phase);
  bool function(Plan& p, int m);
  /// M6: takes the machine to where it changes tools, before anything else of the block is planned.
  bool goToToolChange();
  bool spindle(const Wl4State& s);
  double rpm(const Wl4State& s, double diameter) const;
  double topSpeed(const Wl4State& s) const;
  double meanRpm(const Wl4State& s, double from, double to) const;
  void warnOfUnlimitedSpeed(const Wl4State& s, double from, double to);
  PathItem functionItem(PathItem::Kind kind) const;
  bool sendEvent(EventKind what, double time_s = 0.0);

  // wl4_cycles.cpp: open cycles and contour cycles
  struct CycleGeometry {
    Vec2 from;             ///< A
    PlaneContour contour;  ///< as programmed
    double side;           ///< +1: tool and allowance left of it in (u, v)
    double nose;           ///< radius of the nose, where compensation is on
  };
  Go openCycle(const Plan& p);
  bool contourCycle(Plan& p);
  bool cutContour(Plan& p, bool sided);
  bool allowed(const CycleGeometry& cycle, const ContourAllowance& allowance, PlaneContour& out);
  bool passes(const Plan& p, const Wl4Block& b, const CycleGeometry& cycle, std::vector<ContourMove>& moves);
  bool approachPasses(const Wl4Block& b, const CycleGeometry& cycle, std::vector<ContourMove>& moves);
  bool runPasses(Plan& p, const Wl4Block& b, bool sided, const std::vector<ContourMove>& moves);
  bool readContour(const Plan& p, PlaneContour& contour);
  bool contourBlock(PlaneContour& contour, std::vector<double>& chamfers);

  // wl4_origins.cpp: where words were written
  /// Words that gave the end of a piece of a contour, and the block that has it.
  struct ContourWords {
    OriginRecorder::Slot u, v, block;
  };
  /// Kinds of the plain words of a block; `steps` are incremental.
  struct PlainWords {
    KindSet kinds, steps;
    bool operator==(const PlainWords&) const = default;
  };
  /// What the kinds of the words of a plain motion block depend on.
  struct BlockShape {
    AddressSet letters;
    AxisSet named;
    int g = -1, motion = -1, distance = -1;
    bool chamfer = false;
    bool operator==(const BlockShape&) const = default;
  };
  void beginBlock(std::string_view line);
  std::optional<BlockShape> shapeOf(const Plan& p) const;
  bool shownByText() const;
  void recordLetter(char letter, OriginKind kind, bool step = false, bool by_text = true);
  void recordCode(const Wl4Block::Code& code, OriginKind kind);
  void tellPlainWords();
  void recordWords(const Plan& p);
  void recordBlock(const Plan& p);
  void recordCodes(bool contour);
  void recordAxes(const Plan& p);
  void recordData(const Plan& p);
  void recordSetters();
  void recordToolChange();
  void recordFixedCycle();
  void recordContourCycle(const Plan& p);
  ContourWords wordsInPlane(const WorkPlane& plane) const;
  ContourWords recordContourBlock(const WorkPlane& plane);
  void recordPass(const WorkPlane& plane, const ContourWords& words);
  std::uint32_t systemOrigin(int number) const override;

  // wl4_report.cpp
  bool fail(std::string code, std::string message, Columns at = {});
  void warn(std::string code, std::string message, Columns at = {}, Severity severity = Severity::kWarning);
  void warnOnce(const std::string& key, std::string code, std::string message, Columns at = {});
  Diagnostic diagnosticAt(Severity severity, std::string code, std::string message, const SourceRef& at,
                          Columns columns) const;
  SourceRef here() const;
  SourceRef place() const;  ///< the same without the words in force
  bool contourError(const char* code, const char* message, const PathItem& at) override;
  void compError(const char* code, const std::string& message, const SourceRef& at) override;
  void recover();

  std::optional<double> systemVariable(int number) const override;
  double programmed(const Wl4State& s, int axis) const {
    return s.sign(axis) * (machine_[axis] - s.acting[axis]);
  }
  bool wantsDiameter(int axis) const { return lathe_ && axis == 0; }

  const bool lathe_;
  const ControlSettings settings_;
  Progress* progress_;
  const ControlHost host_;
  Wl4Parameters parameters_;
  InterpretSummary summary_;
  const AxisTable axes_;
  PathEmitter emitter_;
  Wl4Programs programs_;
  Wl4Variables variables_;
  Wl4Evaluator evaluator_;
  Wl4Reader reader_;
  mutable OriginRecorder origins_;        ///< works the index of here() out when it is asked for
  PlainWords plain_words_;                ///< of the block in hand, not told yet
  PlainWords told_words_;                 ///< told last
  std::optional<BlockShape> told_shape_;  ///< of the block that told them
  bool data_told_ = false;
  std::array<std::uint32_t, 3> system_by_{};  ///< words of G92
  std::vector<ContourWords> contour_words_;   ///< by ContourElement::source
  ContourWords contour_start_;
  CoordinateChain chain_;  ///< the pipe's work space is the machine's
  CornerStage corner_stage_;
  Wl4CompStage comp_stage_;
  FrameStage frame_stage_;
  EmitStage emit_stage_;
  MotionPipe pipe_;

  Wl4State state_;
  AxisPoint machine_;  ///< the programmed point, without cutter compensation
  Wl4Block block_;
  std::vector<Level> levels_;
  bool in_cycle_ = false;  ///< inside a fixed cycle: motions do not call it again
  bool until_hit_ = false;
  /// Of the spindle where the next block of the sequence of threads (G32) begins, degrees; nothing: a block
  /// of G32 begins a sequence. Other motions, exact stops, dwells and the spindle's functions end one.
  std::optional<double> thread_angle_;
  BlockBudget budget_;
  LoopWatch watch_;
  std::uint64_t runs_ = 0;                                                     ///< programs opened
  std::array<double, 9> touch_machine_{}, touch_system_{}, touch_distance_{};  ///< G38, by axis
  std::set<std::string, std::less<>> told_;
};

}  // namespace proveout::nc
