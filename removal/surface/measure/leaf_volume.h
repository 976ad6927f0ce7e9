// The stock's volume, leaf by leaf from the exact crossings, and with it a first plan of the quads.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/surface/mesh/leaf_quads.h"

namespace proveout {

/// The error of a stock whose crossings do not close to a surface, which no sound one has.
Error gridHole();

/// Errors: cancelled; a hole in the grid (a bug).
Result<StockVolume> measureVolume(const SurfaceGrid& grid, Progress& progress);

struct MeasuredLeaves {
  StockVolume volume;            ///< as measureVolume gives it, bit for bit, whatever is merged
  FacetError facets;             ///< the same whatever is merged
  std::vector<LeafQuads> quads;  ///< one a leaf
};
/// Reads each quad once for both. Errors as above.
Result<MeasuredLeaves> measureLeaves(const SurfaceGrid& grid, const QuadPlanner& planner, Progress& progress);

}  // namespace proveout
