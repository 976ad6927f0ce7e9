// Roughing and finishing passes over a contour. Everything in a plane (u, v), mm; nothing fails, whatever the
// contour. Rules: WL4 manual 11.8 to 11.12 (digest wl4, 10). A control whose passes differ (other retracts,
// steps that stay) makes them of ContourProfile.
#pragma once

#include <vector>

#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

/// One move of a cycle. Moves hang together: each begins where the one before ends.
struct ContourMove {
  /// kInfeed: towards the contour without cutting on the way, at rapid or feed as the cycle says.
  enum class Speed { kRapid, kInfeed, kFeed } speed = Speed::kFeed;
  ContourElement element;  ///< its source: that of the contour's element, -1 for moves that are not on it
};

struct RoughingRules {
  int depth_axis = 1;        ///< coordinate that the passes step along: 0: u, 1: v
  Vec2 from = Vec2::Zero();  ///< where the tool is before and after
  double depth = 0.0;        ///< of a pass, > 0
};
/// Passes that a caller should ask for at most: each is a level of recursion.
inline constexpr int kMostRoughingPasses = 5000;

/// Passes parallel to the other axis from the level of `from` down to the contour (not empty), closed zones
/// one after the other; no steps stay.
std::vector<ContourMove> roughingPasses(const PlaneContour& contour, const RoughingRules& rules);
/// One pass along the contour (not empty) from and back to `from`, across the depth axis first.
std::vector<ContourMove> finishingPass(const PlaneContour& contour, int depth_axis, const Vec2& from);
/// One pass straight to the contour (not empty), along it, and back to `from` along the axes, the one with
/// the longer way first.
void addApproachPass(const PlaneContour& contour, const Vec2& from, std::vector<ContourMove>& moves);

}  // namespace proveout
