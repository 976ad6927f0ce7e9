// Colours of the deviation map.
#pragma once

#include <array>
#include <vector>

namespace proveout {

using Rgb = std::array<float, 3>;  ///< sRGB, 0..1

/// Diverging scale, mm: blue below -gouge (too much removed), light grey within tolerance, red above excess.
/// Blue to red over a neutral middle stays apart for the common kinds of colour blindness.
struct DeviationScale {
  double gouge = 0.02;   ///< > 0: tolerance below nominal
  double excess = 0.05;  ///< > 0: tolerance above nominal
  double limit = 0.2;    ///< where the colours saturate, on both sides; above both tolerances
};

/// Colour of a signed deviation (positive: material left). Not finite: the "not measured" grey.
Rgb deviationColor(const DeviationScale& scale, double deviation_mm);

/// Round numbers for a legend: both limits, both tolerances, zero; ascending.
std::vector<double> deviationTicks(const DeviationScale& scale);

/// Scale whose limit takes in the deviations found, but is at least three times the larger tolerance and is
/// rounded up to 1, 2 or 5 times a power of ten.
DeviationScale deviationScaleFor(double gouge_tolerance, double excess_tolerance, double max_abs_deviation);

}  // namespace proveout
