// What a run of the WL4 control is made of. Free functions plan and perform over it.
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/nc/control/program_source.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/flow/run_watch.h"
#include "core/nc/kinematics/frames.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/stages/contour_stage.h"
#include "core/nc/stages/motion_pipe.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/rolling_comp_stage.h"
#include "core/nc/wl4/macro/wl4_system.h"
#include "core/nc/wl4/wl4_block.h"
#include "core/nc/wl4/wl4_levels.h"
#include "core/nc/wl4/wl4_origins.h"
#include "core/nc/wl4/wl4_report.h"
#include "core/nc/wl4/wl4_setup.h"
#include "core/nc/wl4/wl4_state.h"

namespace proveout::nc {

struct Wl4Context {
  /// What is referred to must outlive the context.
  Wl4Context(bool lathe, const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress, const ControlHost& host);
  Wl4Context(const Wl4Context&) = delete;
  Wl4Context& operator=(const Wl4Context&) = delete;

  Wl4Setup setup;
  InterpretSummary summary;
  PathEmitter emitter;

  // Where the run is.
  Wl4Programs programs;
  Wl4Levels levels;
  Wl4State state;
  AxisPoint machine;  ///< the programmed point, without cutter compensation
  /// Of the spindle where the next block of the sequence of threads (G32) begins, degrees; nothing: a block
  /// of G32 begins a sequence. Other motions, exact stops, dwells and the spindle's functions end one.
  std::optional<double> thread_angle;

  // The block in hand.
  Wl4Block block;
  OriginRecorder recorder;
  Wl4SystemValues system;
  Wl4Variables variables;
  Wl4Evaluator evaluator;
  Wl4Reader reader;
  Wl4Origins origins;
  Wl4Report report;
  RunWatch watch;

  // The way to the path.
  CoordinateChain chain;  ///< the pipe's work space is the machine's
  CornerStage corner_stage;
  RollingCompStage comp_stage;
  FrameStage frame_stage;
  EmitStage emit_stage;
  MotionPipe pipe;
};

}  // namespace proveout::nc
