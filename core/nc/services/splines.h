// Bezier and NURBS curves of a plane as chords. Lengths mm. Algorithms: de Casteljau; de Boor 1972.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// The points behind the start of chords that stay within `tolerance` (> 0) of the curve; the last one is its
/// end. At most 65536.
void appendBezier(const std::array<Vec2, 4>& control, double tolerance, std::vector<Vec2>& out);

/// Knots of a curve that begins and ends in its end points: `order` times 0, then 1, 2, .. , then `order`
/// times points - order + 1. points >= order >= 2.
std::vector<double> uniformKnots(std::size_t points, int order);

/// The same of a NURBS: points (u, v, weight > 0), knots that do not fall, as many as points and order
/// together. False: knots or order are not so, or there are too few points.
bool appendNurbs(const std::vector<Vec3>& points, const std::vector<double>& knots, int order,
                 double tolerance, std::vector<Vec2>& out);
/// Its point at a value between the knots order - 1 and points.
Vec2 nurbsPoint(const std::vector<Vec3>& points, const std::vector<double>& knots, int order, double t);

}  // namespace proveout
