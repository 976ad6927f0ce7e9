// Offsets of tools that the operator enters, held against the tools of the job.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// Length offsets against gauge lengths (on lathes the shifts of the tools against their gauges), of tools
/// that cut: those whose difference is not that of most of the tools, since one that all have in common is
/// made up for by the work offset; wears are meant. Correctors of cutter compensation against the cutter's
/// radius: the diameter in place of the radius, what is neither the radius nor a wear, and (an error) a 0
/// that nobody has entered.
void addToolOffsets(const SetupRun& setup, double least_mm, const RecordingSource& texts,
                    std::vector<Finding>& findings);

}  // namespace proveout
