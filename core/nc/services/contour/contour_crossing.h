// The corner of two blocks of a contour as the intersection of their lines and circles. Rules: NCT milling
// manual 17.3 (digest nct-3, 5.3 and 5.4).
#pragma once

#include <optional>

#include "core/nc/services/plane_curves.h"

namespace proveout {

/// Which of two common points.
enum class CrossingChoice { kFirst, kSecond };

/// The corner between `first` and `second`. Line and circle: first is the one that comes first along the
/// line's direction. Two circles: first is the one that is reached first going clockwise on `first` from
/// `start`. None: the curves have no common point.
std::optional<Vec2> crossingPoint(const PlaneCurve& first, const PlaneCurve& second, const Vec2& start,
                                  CrossingChoice choice);

}  // namespace proveout
