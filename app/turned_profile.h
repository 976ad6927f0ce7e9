// The profile chart of a run.
#pragma once

#include "app/outputs.h"
#include "app/session/run/run_result.h"

namespace proveout {

/// Writes the profile chart of the part, or nothing where it is not one that only turned.
void writeTurnedProfile(const Job& job, const RunResult& run, StagingFolder& staging, Report& report,
                        OutputFailures& failures);

}  // namespace proveout
