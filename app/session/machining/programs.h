// The first stage of a run: the programs of all clampings on their controls.
#pragma once

#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"

namespace proveout {

/// Runs the programs and adds a SetupRun for each clamping. Sets `alarm` where one is wrong. Errors:
/// cancelled, a path that outgrows the memory, a stock that cannot be measured.
Status interpretAll(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                    Progress& progress);

/// A program that was read for its own sake: nothing is cut.
struct ReadProgram {
  SetupRun setup;                 ///< name, job and what the control made of the program; nothing else
  std::vector<Finding> findings;  ///< that need no machining; alarms are the path's diagnostics
};
/// Reads the program of clamping `k` on its control and looks for what a run would tell before it cuts.
/// `blank`: null where the job has none; what depends on its place is left out then, and without tools in the
/// job what depends on these. Measuring moves meet nothing. At least `max_errors` errors are collected.
/// Errors: as interpretAll.
Result<ReadProgram> readProgram(const Job& job, std::size_t k, const Blank* blank,
                                const RecordingSource& source, int max_errors, Progress& progress);

}  // namespace proveout
