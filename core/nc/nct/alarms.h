// The alarms of the nct control: the manual's numbers and texts.
#pragma once

#include "core/nc/text/alarms.h"

namespace proveout::nc {

/// What a block of the control can be refused for; texts are the manual's, in English.
const AlarmTable& nctAlarms();

}  // namespace proveout::nc
