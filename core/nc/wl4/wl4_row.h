// The WL4 control, milling and turning, in the list of controls.
#pragma once

#include "core/nc/control/control_row.h"

namespace proveout::nc {

const ControlRow& wl4MillRow();
const ControlRow& wl4LatheRow();

}  // namespace proveout::nc
