// Simple polygons as unions of convex ones: toolholders of lathe inserts.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/geometry/types.h"

namespace proveout {

/// Points that a polygon may have.
inline constexpr std::size_t kMaxHolderPoints = 500;
/// Nothing of a polygon may come nearer to another part of it, mm.
inline constexpr double kHolderClearanceMm = 1e-6;

/// Convex polygons, counter-clockwise, that together cover a simple polygon (either way round) without
/// overlap. The error says why it is none: too few or too many points, a border that meets itself.
Result<std::vector<std::vector<Vec2>>> convexPieces(const std::vector<Vec2>& polygon);

}  // namespace proveout
