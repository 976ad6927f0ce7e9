// What the variables of axes have in common: their places and units.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Low numbers have room for 20 axes, high ones for 50.
inline constexpr int kLowAxes = 20, kHighAxes = 50;

/// What one unit of a value of that axis is in mm or degrees. Positions and offsets of an axis in diameter
/// are diameters (manual 5.3).
inline double unitOf(const IsoContext& c, int axis) {
  if (axis >= kMainAxes && c.axes.at(axis).rotary()) return 1.0;
  const bool diameter = c.state.axes.diameter[static_cast<std::size_t>(axis)];
  return diameter ? 0.5 * c.state.unitScale() : c.state.unitScale();
}

}  // namespace proveout::nc
