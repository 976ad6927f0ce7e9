// The machine file with a chain of axes: schema "proveout.machine/1".
#pragma once

#include "io/job/config_table.h"
#include "io/job/job.h"

namespace proveout {

inline constexpr const char* kMachineSchema = "proveout.machine/1";

/// Reads `schema`, `name`, `[[axis]]`, `[spindle]` and `[[body]]` of a machine file into the job's settings:
/// the model, and the axes, rates and limits that the control sees of it. What is wrong with the chain is
/// told with the key and line of the axis; then the settings stay as they are.
void readMachineModel(ConfigTable& machine, Job& job);

}  // namespace proveout
