// A contour as a row of lines and arcs in a plane (u, v).
#pragma once

#include <vector>

#include "core/nc/services/contour/contour_corner.h"

namespace proveout {

/// Elements in the order of the way; each begins where the one before ends. Lengths mm.
using PlaneContour = std::vector<ContourElement>;

ContourElement lineElement(const Vec2& from, const Vec2& to);
/// `sweep`: radians, above 0 counter-clockwise, and such that the arc ends at `to`.
ContourElement arcElement(const Vec2& center, const Vec2& from, const Vec2& to, double sweep);
/// The point at the part `t` of the way, 0 to 1.
Vec2 pointOn(const ContourElement& e, double t);
/// Unit vector of the way at the start or at the end.
Vec2 directionOn(const ContourElement& e, bool end);
/// The stretch from the part `t0` of the way to `t1`.
ContourElement partOf(const ContourElement& e, double t0, double t1);
/// Of a point from an element, mm.
double distanceFrom(const ContourElement& e, const Vec2& p);

/// Does the way go one way only along the coordinate `axis` (0: u, 1: v)? The contour is not empty.
bool goesOneWay(const PlaneContour& contour, int axis);

/// Cuts the corner behind the k-th element by a chamfer of `lengths[k]` (see chamferCorner); 0 and what
/// stands behind the last element leave it as it is. A chamfer has the `source` of the element in front of
/// it. Error: it does not fit its elements; the contour is then half done.
CornerError cutChamfers(PlaneContour& contour, const std::vector<double>& lengths);

}  // namespace proveout
