// Where a level grid edge enters a swept volume.
#pragma once

#include "removal/pass.h"

namespace proveout {

/// Distance from `a` along the level unit direction (dx, dy) to where the edge enters the volume that the pass
/// sweeps, mm. Requires `a` outside (within rounding) and the point at `inside` mm in the volume. Closed form for
/// flat and ball ends along lines, otherwise the root of the exact distance; error below 1e-8 mm. `exact`: the
/// sweep of the pass (of its chord, for curves).
double levelCut(const Pass& pass, const Vec3& a, double dx, double dy, double inside, const Sweep* exact);
/// The same for any sweep and unit direction: a place where the edge goes into the volume, by the root of the
/// exact distance.
double searchCut(const Sweep& sweep, const Vec3& a, const Vec3& direction, double inside);

}  // namespace proveout
