// LinuxCNC in the list of controls.
#pragma once

#include "core/nc/control/control_row.h"

namespace proveout::nc {

const ControlRow& linuxCncRow();

}  // namespace proveout::nc
