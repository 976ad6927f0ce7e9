// `[[machine.event]]`, `gantry` and `tandem` of a machine: what M codes do to axes, and axes with two drives.
#pragma once

#include "core/nc/control/control_settings.h"
#include "io/job/config_table.h"

namespace proveout {

/// Reads them into the settings, where they stand for those read before. The axes must be there
/// already; what is wrong with one is told with key and line.
void readMachineEvents(ConfigTable& machine, ControlSettings& settings);

}  // namespace proveout
