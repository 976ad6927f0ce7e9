// A pocket of any outline: lanes to and fro inside of it, then along its wall. Knows of no control; plane
// coordinates (u, v), mm.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/services/circular_pocket.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout {

struct OutlinePocket {
  PlaneContour outline;       ///< closed, either way round
  Vec2 start = Vec2::Zero();  ///< where the tool goes down; inside
  double tool_radius = 0.0;   ///< > 0
  double allowance = 0.0;     ///< that the lanes and their pass along the wall leave, >= 0
  double step = 0.0;          ///< from lane to lane, > 0
  bool along_v = false;       ///< lanes along v; false: along u
};

/// The ways of the tool's centre at one depth. The tool is never nearer to the outline than its radius.
struct OutlinePocketWays {
  std::vector<PocketMove> rough;   ///< from the start: lanes, then along the wall with the allowance
  std::vector<PocketMove> finish;  ///< from where `rough` ended: along the wall; empty without allowance
  bool all_reached = true;         ///< no corner of the outline is too narrow for the tool
};

/// Whether a contour turns counter-clockwise: its inside is on the left.
bool turnsLeft(const PlaneContour& closed);

/// Error: the outline is not closed or cuts itself where the tool goes, the tool does not fit, the start is
/// nearer to the wall than its radius, or the lanes are too many.
Result<OutlinePocketWays> outlinePocketWays(const OutlinePocket& pocket);

}  // namespace proveout
