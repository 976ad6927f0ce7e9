// Lines and arcs shifted to one side, and cut to other ends.
#pragma once

#include <optional>

#include "core/nc/services/contour/contour_corner.h"
#include "core/nc/services/plane_curves.h"

namespace proveout {

/// The curve that the element lies on, shifted to the left by `offset` (mm). Nothing: an arc with a radius
/// below 0.
std::optional<PlaneCurve> shiftedCurve(const ContourElement& element, double offset);
/// The element shifted by `offset` and cut to these ends, which lie on its shifted curve. Arcs keep the sense
/// of `element`: a sweep of the other sign says that nothing is left.
ContourElement cutTo(const ContourElement& element, const Vec2& from, const Vec2& to);
/// Whether nothing of the element is left: its part `cut` (of `cutTo`) goes the other way.
bool runsBack(const ContourElement& element, const ContourElement& cut);
/// Rounds the corner between `a` and `b`, which end and begin at `arc` then; no arc where they are tangent.
/// With an error they stay as they are.
CornerError roundBetween(ContourElement& a, ContourElement& b, double radius,
                         std::optional<ContourElement>& arc);
/// Common point of two curves that is nearest to `near`.
std::optional<Vec2> nearestMeeting(const PlaneCurve& a, const PlaneCurve& b, const Vec2& near);
/// Signed turn from `t1` to `t2`, radians, -pi to pi, above 0 to the left.
double turnOf(const Vec2& t1, const Vec2& t2);

}  // namespace proveout
