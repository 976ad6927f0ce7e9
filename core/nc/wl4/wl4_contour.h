// Geometry of the WL4 contour cycles G76, G77 and G78: allowances and passes (digest wl4, 10). Everything in
// a plane (u, v), mm.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/services/contour_corner.h"

namespace proveout::nc {

using Wl4Contour = std::vector<ContourElement>;

/// One move of a cycle.
struct Wl4Pass {
  enum class Speed { kRapid, kInfeed, kFeed } speed = Speed::kFeed;  ///< kInfeed: as the cycle's block says
  ContourElement element;
};

/// The path of the centre of a circle of radius |offset| that rolls along the contour, on its left with
/// offset > 0: arcs about corners outside, intersections inside, blocks that do not fit left out. `fits`
/// becomes false where that happens, and where the path comes nearer to the contour all the same. Error: the
/// circle does not fit at all.
Result<Wl4Contour> offsetContour(const Wl4Contour& contour, double offset, bool& fits);
void shiftContour(Wl4Contour& contour, const Vec2& by);

struct Wl4RoughingRules {
  int depth_axis = 1;        ///< coordinate that the passes step along: 1 for G77 (v = X), 0 for G78 (u = Z)
  Vec2 from = Vec2::Zero();  ///< A, where the tool is before and after
  double depth = 0.0;        ///< of a pass, > 0
};
/// Passes parallel to the other axis down to the contour, closed zones one after the other; no steps stay.
std::vector<Wl4Pass> roughingPasses(const Wl4Contour& contour, const Wl4RoughingRules& rules);
/// One pass along the contour from and back to `from`; G77 (depth axis 1) moves along Z first.
std::vector<Wl4Pass> finishingPass(const Wl4Contour& contour, int depth_axis, const Vec2& from);
/// One pass of G76: straight to the contour, along it, and back along the axes, the longer way first.
void addApproachPass(const Wl4Contour& contour, const Vec2& from, std::vector<Wl4Pass>& moves);
/// Whether the contour goes one way only along the axis across the depth.
bool isMonotone(const Wl4Contour& contour, int depth_axis);

}  // namespace proveout::nc
