// Passes of G71 and G72 in a plane: levels parallel to one axis down to a contour (section 16). No control.
#pragma once

#include <string>
#include <vector>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/contour/contour_passes.h"

namespace proveout::nc {

struct LevelRules {
  int depth_axis = 1;        ///< coordinate that the levels step along: 1 for G71, 0 for G72
  double side = 1.0;         ///< +1: the tool stands at larger values of it
  Vec2 from = Vec2::Zero();  ///< C: where the passes begin, mm
  double first = 0.0;        ///< coordinate that the levels count from
  double depth = 1.0;        ///< between them, mm, > 0
  double escape = 0.5;       ///< e, mm, >= 0
  bool pockets = false;      ///< type II
};

/// Deepest contours in levels that a cycle cuts at most.
inline constexpr int kMostLevels = 5000;

/// Moves from C over all levels; back at the along-coordinate of C behind each of the outer ones. `contour`:
/// moved by its allowance, without the block that leads to it; not empty, one way along the other axis.
/// Moves to a level are kInfeed, for G0 or G1 of the first block.
std::vector<ContourMove> levelPasses(const PlaneContour& contour, const LevelRules& rules);

}  // namespace proveout::nc
