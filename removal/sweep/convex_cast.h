// When a moving convex solid of revolution meets a triangle.
#pragma once

#include <array>
#include <optional>

#include "core/geometry/types.h"
#include "core/tool/profile.h"

namespace proveout {

using Triangle = std::array<Vec3, 3>;

/// Point of the solid (axis along +z, origin of its profile at the origin) that is furthest along
/// `direction`.
Vec3 furthestPoint(const ConvexProfile& profile, const Vec3& direction);

/// The least t in 0..1 at which the solid, its origin at from + t (to - from), is within `within` >= 0 of the
/// triangle, mm; nothing: it does not come so near. The solid is within 1e-7 mm of that then, never past it.
std::optional<double> castAgainst(const ConvexProfile& profile, const Vec3& from, const Vec3& to,
                                  const Triangle& triangle, double within = 0.0);

}  // namespace proveout
