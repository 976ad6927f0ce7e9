// Entry point of the virtual controls: program text in, motions and events out.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/nc/control/channel_program.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_info.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/control/run_summary.h"
#include "core/path/toolpath.h"

namespace proveout {

/// Runs the main program of `source` once. Everything goes to `sink` in program order, diagnostics too
/// (bad settings are diagnostics without a place). Never throws for bad input. `progress` may be null. What
/// `host` points to must live as long as the call.
InterpretSummary interpret(ControlId control, const ProgramSource& source, const ControlSettings& settings,
                           MotionSink& sink, Progress* progress = nullptr, const ControlHost& host = {});

/// Runs the programs of several channels together, in the order of simulated time, as interpret() does for
/// one. The sink gets one path in order of start times. An error in a channel stops all at its time; so does
/// `until`, where the first channel has it. Cycle time is the end of the last channel; the other times are
/// sums. Errors: no channel, too many, or two of one number.
InterpretSummary interpretChannels(ControlId control, const std::vector<ChannelProgram>& channels,
                                   MotionSink& sink, Progress* progress = nullptr,
                                   const ControlHost& host = {});

}  // namespace proveout
