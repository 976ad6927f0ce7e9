// Units of values that variables tell.
#pragma once

#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// What one unit of a value of that axis is in mm or degrees.
inline double unitOf(const NctContext& c, int axis) {
  return axis >= kMainAxes && c.axes.at(axis).rotary() ? 1.0 : c.state.unitScale();
}

}  // namespace proveout::nc
