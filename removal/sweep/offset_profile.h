// Profiles grown on all sides: what comes near to a solid of revolution.
#pragma once

#include "core/tool/profile.h"

namespace proveout {

/// The profile of a convex solid that holds every point no farther than `level` mm beside and `upright` mm
/// above or below a point of the solid of `profile` (their Minkowski sum with a cylinder); of a profile of
/// many elements a cylinder around that. Requires both to be above 0.
ConvexProfile offsetProfile(const ConvexProfile& profile, double level, double upright);

}  // namespace proveout
