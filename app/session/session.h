// A run as a library: job in, RunResult out. No command line, no streams, no files written.
//
// The main path: job -> tool path (programs.h) -> machined workpiece (machining.h) -> comparison
// (comparison.h) -> findings.
#pragma once

#include <functional>

#include "app/session/run/prepared_run.h"

namespace proveout {

/// Runs a job whose programs are files. Reports progress to `progress` and stops when that is cancelled. An
/// error of a program is not an Error: it is in the result, with `alarm` set and as findings. Errors: files
/// that cannot be read, a start inside the blank, limits of memory or time that the run would not keep,
/// cancelled (ErrorKind::kInterrupted).
Result<RunResult> runJob(const Job& job, Progress& progress);
/// The same with programs from elsewhere, one source a clamping; see MemoryProgramSource.
Result<RunResult> runJob(const Job& job, const std::vector<const ProgramSource*>& programs,
                         Progress& progress);

/// The first part of a run, for those who want to know what it will take. Errors: as runJob.
Result<PreparedRun> prepareRun(const Job& job, const RunSources& sources, Progress& progress);
/// Work on the finished part that goes on while it is compared, on other threads, or alone where there is no
/// comparison. It may read the last clamping's mesh, freed pieces and turned bodies. Ends soon after its
/// `progress` is cancelled; its error ends the run.
using WorkOnPart = std::function<Status(const SetupRun& last, Progress& progress)>;
/// The second part. Does nothing after an alarm. `meanwhile`: not called where nothing is left of the part.
Result<RunResult> finishRun(const Job& job, const RunSources& sources, PreparedRun prepared,
                            Progress& progress, const WorkOnPart& meanwhile = {});
/// Both.
Result<RunResult> runRecorded(const Job& job, const RunSources& sources, Progress& progress);

}  // namespace proveout
