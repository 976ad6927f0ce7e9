// Figures over both sampled surfaces.
#pragma once

#include <array>
#include <vector>

#include "removal/compare/comparison.h"
#include "removal/compare/measured_sides.h"

namespace proveout {

/// A triangle of surface over which the deviation is linear; or what one point stands for, where all three
/// are the same.
struct DeviationPiece {
  double area_mm2 = 0.0;         ///< >= 0
  std::array<float, 3> at = {};  ///< at its corners, mm; finite
};
using DeviationPieces = std::vector<DeviationPiece>;

/// Integrals over the pieces, without a sum over samples: exact but for the rounding of the deviations.
DeviationFigures figuresOf(const DeviationPieces& pieces);

/// Twenty-four bins over four times the larger tolerance to both sides: what passes is seen in detail. Adds
/// the pieces' areas times `share`; the edges follow from the tolerances and largest deviations of
/// `comparison`.
void addToHistogram(const DeviationPieces& pieces, double share, Comparison& comparison);

/// Fills max_gouge, max_excess, the figures of both sides and the histogram.
void fillStatistics(const BothSides& sides, Comparison& comparison);

}  // namespace proveout
