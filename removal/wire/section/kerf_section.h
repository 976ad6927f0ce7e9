// A section less what a wire takes of it.
#pragma once

#include <vector>

#include "removal/wire/section/plane_region.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

/// Regions thinner than this all over, and gaps between them, are rounding and left out, mm.
inline constexpr double kThinRegionMm = 2e-4;

/// The blank less the kerfs of all stretches, in connected regions, the largest first. Edges are exact lines
/// and arcs; an edge belongs to the motion whose wire came nearest to it, of several to the first. Regions
/// that touch in a point are parted or not as rounding to nanometres falls. `blank`: outer borders and
/// hollows that do not cross.
std::vector<PlaneBody> cutSection(const std::vector<PlaneLoop>& blank,
                                  const std::vector<WireStretch>& stretches);

/// What a rectangle holds of the blank less the kerfs, without exact arcs: connected regions, each its border
/// first, then its hollows. Heights of `window` do not count.
std::vector<std::vector<std::vector<Vec2>>> regionsInside(const Box3& window,
                                                          const std::vector<PlaneLoop>& blank,
                                                          const std::vector<WireStretch>& stretches);

/// What `stretch` meets of the blank less the kerfs of `earlier`, without exact arcs: regions of `thickness`
/// or more.
std::vector<std::vector<Vec2>> metBy(const WireStretch& stretch, const std::vector<PlaneLoop>& blank,
                                     const std::vector<WireStretch>& earlier, double thickness_mm);

}  // namespace proveout
