// The main path: job -> tool path -> stock -> surface -> comparison -> findings. Each stage is a function
// that can be called alone; runPipeline calls them in order.
#pragma once

#include <optional>

#include "app/blank.h"
#include "app/run_result.h"
#include "removal/compare/nominal.h"

namespace proveout {

/// A run before anything is cut: programs interpreted, files read, memory and time predicted.
struct PreparedRun {
  RunResult run;
  Blank blank;
  std::optional<PreparedMesh> nominal;
  bool placement_told = false;  ///< what would bring the nominal onto the blank
};

/// The first part of a run. An error of a program is not an Error: it is in the result, with `alarm` set.
/// Errors: files that cannot be read, a start inside the blank, more memory needed than allowed.
Result<PreparedRun> prepareRun(const Job& job, const RunSources& sources, Progress& progress);
/// The second part. Does nothing after an alarm.
Result<RunResult> finishRun(const Job& job, const RunSources& sources, PreparedRun prepared,
                            Progress& progress);

/// Runs everything, one clamping for each of `sources`. An error of a program is not an Error: it is in the
/// result, with `alarm` set.
Result<RunResult> runPipeline(const Job& job, const RunSources& sources, Progress& progress);

}  // namespace proveout
