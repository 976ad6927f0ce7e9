// Whether a tool whose axis turns stays clear of what stands around.
#pragma once

#include <optional>
#include <span>

#include "core/path/toolpath.h"
#include "core/tool/tool_solid.h"
#include "removal/grid/blank_field.h"

namespace proveout {

/// Where a way is not shown to be clear.
struct UnclearPlace {
  double share = 0.0;         ///< of the motion, 0 to 1
  Vec3 point = Vec3::Zero();  ///< in or beside the tool, workpiece frame, mm
};

/// Any part of the tool, on a motion along which its axis turns from `axis.from` to `axis.to` at a constant
/// rate, against bodies in the workpiece frame. Safe: none is returned only where no point of the tool comes
/// nearer to a body than a micrometre. A tool that passes within a fifth of a millimetre may be taken for one
/// that touches.
std::optional<UnclearPlace> firstUnclear(const Toolpath& path, const Motion& motion, const AxisSweep& axis,
                                         const ToolSolid& tool, std::span<const BlankField* const> bodies);

}  // namespace proveout
