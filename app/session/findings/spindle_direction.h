// Cutters that turn backwards.
#pragma once

#include <vector>

#include "app/session/findings/findings.h"

namespace proveout {

/// Feed motions of a mill's path that cut with the spindle against the hand of their tool: one error for each
/// tool and each block that started the spindle so. Threads and taps are left out: their way back is right.
/// `removed_mm3`: by motion.
void addSpindleDirection(const Toolpath& path, const std::vector<float>& removed_mm3,
                         const std::vector<Tool>& tools, const RecordingSource& texts,
                         std::vector<Finding>& findings);

}  // namespace proveout
