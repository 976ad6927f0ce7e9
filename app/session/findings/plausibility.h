// Values of a program that can hardly be meant.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// Warnings, one a tool: a feed per revolution above the nose radius of an insert (the nose leaves a thread)
/// or above the width of a blade, in motions that cut. No cutting data are known: these are values that no
/// setup has.
void addImplausible(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);

}  // namespace proveout
