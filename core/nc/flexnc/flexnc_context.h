// What a run of the FlexNC control is made of. Free functions perform over it.
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/flexnc_block.h"
#include "core/nc/flexnc/flexnc_parameters.h"
#include "core/nc/flexnc/flexnc_program.h"
#include "core/nc/flexnc/flexnc_rapid_stage.h"
#include "core/nc/flexnc/flexnc_report.h"
#include "core/nc/flexnc/flexnc_state.h"
#include "core/nc/flow/run_watch.h"
#include "core/nc/kinematics/frames.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/stages/motion_pipe.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/rolling_comp_stage.h"

namespace proveout::nc {

/// What contour blocks and threads leave for the blocks behind them.
struct FlexCycleMemory {
  bool approached = false;              ///< the last motion was that of G81.1 to G81.3
  std::optional<ContourChain> chain;    ///< of the contour block before
  std::vector<CycleMove> chain_return;  ///< due where no contour block follows
  SourceRef chain_source;               ///< of the block that they belong to
  std::optional<ThreadData> thread;     ///< of the G76 data block before
};

struct FlexContext {
  /// What is referred to must outlive the context; `progress` may be null.
  FlexContext(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
              Progress* progress);
  FlexContext(const FlexContext&) = delete;
  FlexContext& operator=(const FlexContext&) = delete;

  /// Of the part's zero, (x, z), machine frame.
  Vec2 origin() const;
  /// What is added to a coordinate of the program, (x, z): part zero, corrector, G52.
  Vec2 offset() const { return origin() + state.corrector + state.shift; }
  Vec2 at() const { return {machine[0], machine[2]}; }  ///< (x, z), machine frame

  const ProgramSource& source;
  const ControlSettings settings;
  MotionSink& sink;
  FlexParameters parameters;
  const AxisTable axes;
  InterpretSummary summary;
  PathEmitter emitter;

  // Where the run is.
  FlexProgram program;
  FlexLevels levels;
  FlexState state;
  FlexCycleMemory cycle;
  AxisPoint machine;  ///< the programmed point, without compensation

  // The block in hand.
  FlexBlock block;
  OriginRecorder recorder;
  FlexVariables variables;
  FlexEvaluator evaluator;
  FlexReader reader;
  FlexReport report;
  RunWatch watch;

  // The way to the path.
  CoordinateChain chain;  ///< the pipe's work space is the machine's
  RollingCompStage comp_stage;
  FrameStage frame_stage;
  FlexRapidStage rapid_stage;
  EmitStage emit_stage;
  MotionPipe pipe;
};

}  // namespace proveout::nc
