// Geometry of cutter compensation: what happens between two elements. Internal to the service.
#pragma once

#include <optional>

#include "core/nc/services/cutter_comp.h"
#include "core/nc/services/plane_curves.h"

namespace proveout::comp_detail {

/// mm; displacements below it are none. Far below any control's increment, above rounding noise.
inline constexpr double kTinyLength = 1e-9;
/// mm; compensated motion may run back, and an offset radius fall short, by this much before it is
/// interference. A cutter of exactly the radius of a fillet fits.
inline constexpr double kReverseTolerance = 1e-6;

inline Vec2 planar(const Vec3& p) { return p.head<2>(); }

/// Unit direction of motion at the ends of a line or arc.
Vec2 startTangent(const Element& e);
Vec2 endTangent(const Element& e);

/// Radius of an arc's offset curve at its start and end, mm; negative where the cutter does not fit.
double offsetRadiusAtStart(const Element& e);
double offsetRadiusAtEnd(const Element& e);

/// Corner between `a` and the element after it; `b` is null where look-ahead ends. `from` is where the
/// compensated path of `a` starts.
Corner makeCorner(const Element& a, const Element* b, const Vec2& from, const CutterCompPolicy& policy);

/// Meeting point of the offset curves of two elements, nearest to the end of `a`.
std::optional<Vec2> meetOffsets(const Element& a, const Element& b);
/// Meeting point of the infinite lines through a0, a1 and b0, b1.
std::optional<Vec2> meetLines(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1);

/// Sweep (>= 0 in the arc's own direction) of the compensated arc from `from` to `to`; not reduced to one
/// turn, negative where the compensated arc runs backwards.
double offsetSweep(const Element& arc, const Vec2& from, const Vec2& to);

/// True if the compensated motion from `from` to `to` runs against the programmed element.
bool runsBackwards(const Element& e, const Vec2& from, const Vec2& to);

/// Arc from `from` to `to` with radius and direction of `arc`, of the two the one whose sweep is nearest to
/// the programmed one. Returns false if the points are too far apart.
bool chordArc(const Element& arc, const Vec2& from, const Vec2& to, Vec2& center, double& sweep);

}  // namespace proveout::comp_detail
