// Curves that are neither lines nor circles: along chords.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Chords stay so near to the curve, mm: beside the tolerance of whoever measures it.
inline constexpr double kCurveToleranceMm = 5e-4;

/// Carries a CurveMove out by feed, to plan.motion.target, axes besides X, Y, Z evenly with t.
bool performCurve(IsoContext& c, BlockPlan& plan);
/// The points of a curve behind its start, program coordinates; the last one is its end.
std::vector<Vec3> chordsOf(const CurveMove& curve);
/// Sends lines by feed through the points to plan.motion.target. False: reported.
bool sendChords(IsoContext& c, BlockPlan& plan, const std::vector<Vec3>& points);

}  // namespace proveout::nc
