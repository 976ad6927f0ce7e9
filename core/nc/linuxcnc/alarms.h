// The errors of LinuxCNC: they have texts and no numbers.
#pragma once

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Codes of diagnostics begin with "linuxcnc-".
const AlarmTable& linuxCncAlarms();

}  // namespace proveout::nc
