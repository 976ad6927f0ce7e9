// Cuts of a wire whose middle follows the contour: the program has no offset there.
#pragma once

#include <optional>
#include <vector>

#include "core/path/toolpath.h"
#include "core/tool/tool.h"

namespace proveout {

/// Radius of the wire and spark gap, mm; none: the motion is no cut of a wire.
std::optional<double> halfKerf(const Toolpath& path, const std::vector<Tool>& tools, MotionId motion);

/// Whether a motion cuts without an offset, and what it left is off the nominal by about half of the kerf.
/// `off_mm`: by how much, >= 0.
bool followsContour(const Toolpath& path, const std::vector<Tool>& tools, MotionId motion, double off_mm);

}  // namespace proveout
