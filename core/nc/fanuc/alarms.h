// The alarms of Fanuc-like controls: numbers and texts as 0i to 31i controls have them.
#pragma once

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Codes of diagnostics begin with "fanuc-". Numbers differ by model; the text is the contract.
const AlarmTable& fanucAlarms();

}  // namespace proveout::nc
