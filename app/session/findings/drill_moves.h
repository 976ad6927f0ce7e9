// Drills that are used as mills.
#pragma once

#include <vector>

#include "app/session/findings/findings.h"

namespace proveout {

/// `drill_sideways`: one warning for each drill whose feed motions took material on a way across its axis, at
/// the first of them. `removed_mm3`: by motion.
void addDrillMoves(const Toolpath& path, const std::vector<float>& removed_mm3,
                   const std::vector<Tool>& tools, const RecordingSource& texts,
                   std::vector<Finding>& findings);

}  // namespace proveout
