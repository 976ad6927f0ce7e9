// One convex solid of a tool on its way along one motion, or along one chord of a curved motion.
#pragma once

#include <cstdint>
#include <vector>

#include "core/path/toolpath.h"
#include "removal/column_sweep.h"
#include "removal/sweep.h"

namespace proveout {

enum class ToolPart : std::uint8_t { kCutter, kShank, kHolder };

struct Pass {
  ColumnSweep columns;
  const ConvexProfile* profile = nullptr;
  MotionId motion = kNoMotion;
  std::int32_t curve = -1;  ///< number of the exact sweep of a curved motion, or -1 for lines
  ToolPart part = ToolPart::kCutter;
  bool watched = false;  ///< contact with stock is a finding
  /// Of a helix about z: how far on in the table the pass over the same place one turn lower is; 0: there is
  /// none, or it does not cover all that this one does below its own top.
  std::int32_t lower = 0;

  /// The solid along this line or chord. Not for level arcs.
  Sweep lineSweep() const;
};

/// A pass that reaches into a block, and the height below which it does not (a lower bound), mm.
struct Reach {
  std::uint32_t pass;
  float low;
};
using ReachList = std::vector<Reach>;

/// Whether a grid edge of length `h` lies in the sweep if both its ends do. All are convex, or bulky enough
/// for that, but arcs that turn around a pillar which is thinner than the grid.
bool holdsEdges(const Pass& pass, double h);
/// Height that the solid nowhere reaches above on its way, mm.
double highestReach(const Pass& pass);
/// Height up to which the columns under the solid are covered all along its way, mm. Requires a level top.
double lowestTop(const Pass& pass);

}  // namespace proveout
