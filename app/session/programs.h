// The first stage of a run: the programs of all clampings on their controls.
#pragma once

#include "app/session/run_result.h"

namespace proveout {

/// Runs the programs and adds a SetupRun for each clamping. Sets `alarm` where one is wrong. Errors:
/// cancelled, a path that outgrows the memory, a stock that cannot be measured.
Status interpretAll(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                    Progress& progress);

}  // namespace proveout
