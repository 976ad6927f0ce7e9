// Contours with an allowance: what lies off a contour by a distance, a shift or both, and the layers in
// between. Everything in a plane (u, v), mm.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

/// The path of the centre of a circle of radius |offset| that rolls along the contour, on its left with
/// offset > 0: arcs about corners outside, intersections inside, elements that do not fit left out. `fits`
/// becomes false where that happens, and where the path comes nearer to the contour all the same. Error: the
/// circle does not fit at all.
Result<PlaneContour> offsetContour(const PlaneContour& contour, double offset, bool& fits);
void shiftContour(PlaneContour& contour, const Vec2& by);

/// What stays on a contour.
struct ContourAllowance {
  double offset = 0.0;        ///< across the contour, the same everywhere, >= 0
  Vec2 shift = Vec2::Zero();  ///< of the contour as a whole
};
/// What is to be cut from one allowance to another: the difference of their offsets, or, where they have the
/// same, the way between their shifts. Not above 0: there is nothing to cut.
double allowanceDepth(const ContourAllowance& stock, const ContourAllowance& finish);
/// The allowances behind each cut of `depth` > 0, the last one `finish`; at least one. Their number is the
/// depth of the allowance by that of a cut: for the caller to limit.
std::vector<ContourAllowance> contourLayers(const ContourAllowance& stock, const ContourAllowance& finish,
                                            double depth);

}  // namespace proveout
