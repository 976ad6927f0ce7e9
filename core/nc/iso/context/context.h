// What a channel of a control of the ISO family is made of; every plan and perform function gets it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/nc/control/channels.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/flow/run_watch.h"
#include "core/nc/iso/model/alarm_reporter.h"
#include "core/nc/iso/model/call_stack.h"
#include "core/nc/iso/model/codes.h"
#include "core/nc/iso/model/dialect.h"
#include "core/nc/iso/model/environment.h"
#include "core/nc/iso/model/interrupt_macro.h"
#include "core/nc/iso/model/m_index.h"
#include "core/nc/iso/model/modal_calls.h"
#include "core/nc/iso/model/offset_tables.h"
#include "core/nc/iso/model/output_file.h"
#include "core/nc/iso/model/path_step.h"
#include "core/nc/iso/model/plan.h"
#include "core/nc/iso/model/program_store.h"
#include "core/nc/iso/model/run_clock.h"
#include "core/nc/iso/model/spindles.h"
#include "core/nc/iso/model/state.h"
#include "core/nc/iso/model/system_calls.h"
#include "core/nc/iso/model/tilt_plan.h"
#include "core/nc/iso/model/tool_tables.h"
#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/iso/stages/axis_stage.h"
#include "core/nc/iso/stages/comp_stage.h"
#include "core/nc/iso/stages/contour_alarms.h"
#include "core/nc/iso/stages/dogleg_stage.h"
#include "core/nc/iso/stages/stage_recovery.h"
#include "core/nc/iso/stages/transform_stage.h"
#include "core/nc/iso/stages/virtual_stage.h"
#include "core/nc/iso/stages/zone_stage.h"
#include "core/nc/kinematics/five_axis_model.h"
#include "core/nc/kinematics/frames.h"
#include "core/nc/macro/variables.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/services/drilling.h"
#include "core/nc/stages/motion_pipe.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/rapid_overlap_stage.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Where the last measuring move stopped.
struct SkipPosition {
  /// In workpiece coordinates and in those of a tilted plane (first index 1); with the length offset included
  /// and without it (second index 1).
  std::array<std::array<AxisPoint, 2>, 2> at;
  AxisPoint machine;      ///< machine coordinates
  AxisPoint machine_tip;  ///< without the length offset
};

/// Registers that survive the end of a program.
struct IsoRegisters {
  WorkFrames frames;
  OffsetTables offsets;
  std::shared_ptr<ToolTables> shared_tools = std::make_shared<ToolTables>();
  ToolTables& tools() const { return *shared_tools; }  ///< common to the channels of a control
  ToolInput tool_input;
  Spindles spindles;
  HeadPosition head = HeadPosition::kVertical;
  double tool_time_s = 0.0;  ///< cutting time up to which the life of the tool in the spindle is counted
  SkipPosition skip;
  std::optional<Zone> program_zone;        ///< of G22
  std::array<AxisPoint, 8> dynamic_zeros;  ///< of G54.2 P1 to P8
  TiltInput tilt_input;
  double parts_made = 0.0;    ///< #3901
  double parts_wanted = 0.0;  ///< #3902
};

/// The block that an interrupt macro has interrupted.
struct InterruptedBlock {
  IsoState state;
  int program = 0;  ///< number of its program
};

/// Where a channel waits for others (manual 14.5).
struct WaitingPoint {
  int code = 0;      ///< M code; 0: it does not wait
  ChannelSet whom;   ///< itself among them
  std::string text;  ///< "M501 P12"
};

struct IsoContext;
/// What becomes of a block between G10 L... and G11; the words are those of data blocks, N among them. False:
/// an error was reported.
using DataInput = bool (*)(IsoContext&);

/// The reports of a context by their short names; see AlarmReporter. `Context` has it as `alarms`.
template <class Context>
class AlarmCalls {
 public:
  bool alarm(SharedAlarm what, std::string_view subject, std::string_view detail = {}, Columns at = {}) {
    return reporter().alarm(what, subject, detail, at);
  }
  bool alarm(SharedAlarm what, const Word& at, std::string_view detail = {}) {
    return reporter().alarm(what, at, detail);
  }
  bool fail(const DiagnosticName& name, std::string message, Columns at = {}) {
    return reporter().fail(name, std::move(message), at);
  }
  bool fail(const LexError& error) { return reporter().fail(error); }
  bool failWord(const DiagnosticName& name, std::string message, const Word& at) {
    return reporter().fail(name, std::move(message), at.columns);
  }
  void warn(const DiagnosticName& name, std::string message, Columns at = {},
            Severity severity = Severity::kWarning) {
    reporter().warn(name, std::move(message), at, severity);
  }
  bool firstTime(std::string_view key) { return reporter().firstTime(key); }
  /// A warning that is told once for each key. Where a loop may come by, ask firstTime() before formatting.
  void warnOnce(std::string_view key, const DiagnosticName& name, std::string message, Columns at = {},
                Severity severity = Severity::kWarning) {
    if (firstTime(key)) warn(name, std::move(message), at, severity);
  }

 private:
  AlarmReporter& reporter() { return static_cast<Context*>(this)->alarms; }
};

/// What the pipe runs through; each is linked while it has something to do.
struct IsoStages {
  explicit IsoStages(IsoContext& c);
  ContourAlarms contour_alarms;
  CrossingStage crossing;
  TransformStage transform;
  CornerStage corner;
  CompStage comp;
  VirtualStage virtual_plane;
  FrameStage frame;
  AxisStage axes;
  RapidOverlapStage rapid;
  DoglegStage dogleg;  ///< in place of `rapid`
  ZoneStage zone;
  EmitStage emit;
};

struct IsoContext final : StageRecovery, AlarmCalls<IsoContext> {
  /// What is handed in must outlive the context.
  IsoContext(const IsoDialect& control, const ProgramSource& source, const ControlSettings& control_settings,
             MotionSink& sink, Progress* progress, const ControlHost& control_host,
             InterpretSummary& run_summary);
  IsoContext(const IsoContext&) = delete;
  IsoContext& operator=(const IsoContext&) = delete;

  const IsoDialect& dialect;
  const ControlSettings& settings;
  InterpretSummary& summary;
  const CodeIndex& codes;
  const AxisTable axes;
  FiveAxisModel five_axes;  ///< as the control knows the machine; fixed once its parameters are taken
  PathEmitter emitter;
  IsoParameters parameters;
  ProgramStore programs;
  CallStack calls;
  VariableStore variables;
  const IsoMacroEnvironment environment;
  MacroEvaluator macro;
  mutable OriginRecorder origins;    ///< works the index of here() out when it is asked for
  OriginRecorder::Slot cycle_start;  ///< word of the initial level of a drilling cycle
  WordPatterns word_patterns;
  ModalCalls modals;
  SystemCalls systems;
  MIndex m_index;
  InterruptMacro interrupt;
  Block block;
  AlarmReporter alarms;
  RunWatch watch;
  const ControlHost host;
  const RunClock clock;

  IsoState state;
  IsoRegisters registers;
  CoordinateChain chain;  ///< in force for what the pipe gets
  ProgramMap map;         ///< the transforms in it
  AxisPoint position;     ///< programmed, in chain
  AxisPoint machine;      ///< programmed point in machine coordinates, without cutter compensation
  MotionPipe pipe;        ///< everything that becomes path goes through it
  IsoStages stages;
  // What blocks that stand for many motions have planned.
  std::vector<DrillStep> drill_steps;
  std::vector<Vec2> hole_points;     ///< in the plane, program coordinates (Holes::listed)
  std::vector<PathStep> path_steps;  ///< see performSteps()
  IsoLanguage* language = nullptr;   ///< that reads the lines; null: the family's own
  DataInput data_input = nullptr;    ///< set: blocks are data until G11
  OutputFile output;
  std::optional<InterruptedBlock> interrupted;  ///< while an interrupt macro runs
  const SourceText* last_called = nullptr;      ///< the program that was called last; null: none yet
  ChannelSet channels;                          ///< of the run; empty: it has one
  WaitingPoint waiting;
  std::unique_ptr<MakerData> maker;  ///< of the dialect's rules; null: they keep nothing

  /// Number of this channel, 1 to 8.
  int channel() const { return settings.channel > 0 ? settings.channel : 1; }

  /// The innermost program was opened by a call: a level of locals where its kind has one, its words.
  void enteredCall();
  /// A program of that kind was left: its locals go, its caller is in hand again.
  void leftCall(CallKind kind);
  /// Closes the program in hand. Not for the main program.
  void closeCall();
  /// Another program is in hand.
  void enterProgram();

  /// From here on the rows and variables that all channels share (N1401, N1700, N1701) are those of `owner`,
  /// and so are the tools.
  void shareWith(IsoContext& owner);

  /// The chain of a state, with the rotary axes where the machine has them.
  CoordinateChain chainOf(const IsoState& s) const { return chainOf(s, machine); }
  /// The same with the rotary axes of `at`, machine coordinates.
  CoordinateChain chainOf(const IsoState& s, const AxisPoint& at) const;

  /// Which axes move by which names.
  const AxisMap& axisMap() const { return registers.frames.axes; }
  /// Where the machine is, by the names of its axes (see AxisMap).
  AxisPoint standing() const { return axisMap().namesAt(emitter.machine()); }

  /// The machine stands at `at`, by name, by other means than a programmed motion.
  void settle(const AxisPoint& at);
  /// Lets go what the pipe holds; what comes then starts anew from where the machine is. False: an error was
  /// reported.
  bool flushPipe();
  /// Tells the pipe that the machine or its frames have changed.
  void rebasePipe() { pipe.rebase(chain.workOf(position), state.workPlane()); }
  void recover() override;

  /// Index of the line that runs from here on, and its N number.
  void setBlock(std::size_t line_index, std::int64_t number) {
    calls.setBlock(line_index, number);
    origins.begin(calls.here().line, number);
  }
  /// Where the block in hand stands, with the words in force.
  SourceRef here() const {
    SourceRef ref = calls.here();
    ref.origins = origins.index();
    return ref;
  }
  /// Addresses that the plan of the block in hand has asked for.
  mutable AddressSet asked;
  const Word* word(Address a) const {
    asked.add(a);
    return block.find(a);
  }
  /// The word if it does not belong to another code of the block.
  const Word* ownWord(const BlockPlan& plan, Address a) const {
    return plan.claimed.has(a) ? nullptr : word(a);
  }
  bool anyAxisWord() const { return !(block.present & axes.addresses()).empty(); }
};

}  // namespace proveout::nc
