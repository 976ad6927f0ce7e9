// The second stage of a run: the workpiece through all clampings.
#pragma once

#include "app/session/run/prepared_run.h"

namespace proveout {

/// Machines the workpiece in all clampings, one after the other, and looks at what each made. Ends with the
/// clamping that leaves nothing.
Status machineAll(const Job& job, const RunSources& sources, PreparedRun& prepared, Progress& progress);

}  // namespace proveout
