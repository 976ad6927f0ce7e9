// Constant surface speed (G96): the spindle turns faster towards the axis, between two speeds.
#pragma once

namespace proveout::nc {

/// Speeds that the spindle may have, 1/min; 0 <= low <= high, high > 0.
struct SpindleBounds {
  double low = 0.0, high = 0.0;
};

/// `product`: 1/min times mm, > 0; places are the signed radii, or the diameters, that it is told of.
double surfaceRpm(double product, double place, const SpindleBounds& bounds);
/// Speed with which feed per revolution takes as long along a line from one place to another.
double meanSurfaceRpm(double product, double from, double to, const SpindleBounds& bounds);

}  // namespace proveout::nc
