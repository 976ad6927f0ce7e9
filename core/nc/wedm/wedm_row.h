// The wire EDM control in the list of controls.
#pragma once

#include "core/nc/control/control_row.h"

namespace proveout::nc {

const ControlRow& wedmRow();

}  // namespace proveout::nc
