// The alarms of Fanuc-like controls: numbers and texts as 0i to 31i controls have them.
#pragma once

#include <vector>

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// Codes of diagnostics begin with "fanuc-". Numbers differ by model; the text is the contract.
const AlarmTable& fanucAlarms();
/// The numbers of all alarms that these controls raise, rising; those that a program raises by #3000 are not
/// among them.
std::vector<int> fanucAlarmNumbers();

}  // namespace proveout::nc
