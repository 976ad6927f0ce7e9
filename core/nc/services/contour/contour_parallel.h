// The true parallel of a contour. Everything in a plane (u, v), mm.
#pragma once

#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

/// The points on the left of the contour whose distance from it is `distance` > 0, from beside its begin to
/// beside its end: elements shifted, arcs about outside corners (where these would be
/// shorter than 0.01 mm the elements go on to where they meet), and nothing that comes nearer to any part of
/// the contour. Where the contour goes straight back it is a fin if it went up, v growing, else a slot. What
/// the distance uses up is left out. `source` is that of the element shifted, of arcs about corners that of
/// the element in front of them. Empty: nothing is left, or the contour crosses itself.
PlaneContour parallelContour(const PlaneContour& contour, double distance);

}  // namespace proveout
