// Motions along which a rotary axis turns the tool or the part.
#pragma once

#include "app/session/run/recording_source.h"
#include "core/path/toolpath.h"

namespace proveout {

/// False, with an error in the path's diagnostics (rotary-motion): an axis is not at 0 that the job does not
/// place in the machine.
bool checkRotaryMotions(Toolpath& path, const RecordingSource& source);

}  // namespace proveout
