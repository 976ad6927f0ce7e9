// Running the program on its virtual control.
#pragma once

#include <vector>

#include "app/session/run/interpreted.h"
#include "app/session/run/recording_source.h"
#include "core/nc/registry/interpreter.h"
#include "core/path/origin_query.h"
#include "core/path/toolpath.h"
#include "io/job/job.h"
#include "io/report.h"

namespace proveout {

struct ProbedStock;

/// Settings of the job, with the places that it leaves open taken from a blank that has these bounds; see
/// placeMachine and giveWireHeights.
ControlSettings controlSettings(const Job& job, const Box3& blank);

/// Runs the job's program, or those of its channels.
InterpretSummary interpretJob(const Job& job, ControlId control, const RecordingSource& source,
                              const ControlSettings& settings, MotionSink& sink, Progress& progress,
                              const ControlHost& host);

/// `stock`: what measuring moves meet; null, or with several channels: nothing.
Interpreted interpretProgram(const Job& job, const RecordingSource& source, const ControlSettings& settings,
                             Progress& progress, const ProbedStock* stock = nullptr);

/// Tools that the control calls and the job does not have get the shape that their offset row tells (D of a
/// row with a corner radius, event tool_shape); a note says so. The first row that a tool is used with
/// counts.
void addOffsetTools(Toolpath& path, std::vector<Tool>& tools);

/// Gives motions that name no tool the lowest tool of the job and checks that every tool used is defined.
/// What it finds goes to `path.diagnostics`; false after an error.
bool assignTools(Toolpath& path, const std::vector<Tool>& tools, const RecordingSource& source);

}  // namespace proveout
