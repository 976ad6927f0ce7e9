// Pieces that turning cut off.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// One note for each body of a turned part that was cut off, or stayed on the bar, beside the part.
void addPartedBodies(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);

}  // namespace proveout
