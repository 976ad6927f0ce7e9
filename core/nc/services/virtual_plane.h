// Planes with a rotary axis that stands for a linear one: where the machine's axes are for a point of the
// plane, and how far the rotary axis turns on the way. Lengths mm, angles rad, signed counter-clockwise from
// the linear to the virtual axis.
#pragma once

#include <functional>

#include "core/geometry/types.h"

namespace proveout {

/// Angle that a line from `from` to `to` subtends at the origin, in (-pi, pi]; through the origin: pi.
double turnOfLine(const Vec2& from, const Vec2& to);

/// Angle that an arc about `center` from `from`, swept by `sweep`, its radius going linearly to that of `to`,
/// subtends at the origin; whole turns count.
double turnOfArc(const Vec2& from, const Vec2& to, const Vec2& center, double sweep);

/// Point of that arc at t in 0..1.
Vec2 pointOfArc(const Vec2& from, const Vec2& to, const Vec2& center, double sweep, double t);

/// Duration in minutes of a line from `from` to `to` at feed `feed` (mm/min) where an axis that turns about
/// the origin has a largest speed `turn_rate` (rad/min): near the origin the feed drops so that the axis
/// keeps to it; on its way through the origin it waits for half a turn. Closed form. turn_rate <= 0: no
/// limit.
double polarLineMinutes(const Vec2& from, const Vec2& to, double feed, double turn_rate);

/// Curves that are neither lines nor arcs go along chords that stay so near to them, mm; before the tolerance
/// divides them further their parts bend at most by this angle.
inline constexpr double kCurveChordMm = 1e-4;
inline constexpr double kCurvePieceRad = 10.0 * kPi / 180.0;

/// Divides 0..1 so that between neighbours the curve `at` stays within `tolerance` of its chord. The curve
/// must be smooth, and bend no more than a few times within one of `pieces` equal parts. Values of the inner
/// ends and 1 are told in order; at most 65,536 for each piece.
void divideCurve(const std::function<Vec3(double)>& at, int pieces, double tolerance,
                 const std::function<void(double)>& tell);

}  // namespace proveout
