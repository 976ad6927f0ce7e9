// Volume that no crossing shows: slivers under overhangs, lips over teeth, tips of wedges and walls thinner
// than the grid.
#pragma once

#include "core/base/progress.h"
#include "removal/surface/cell/surface_grid.h"

namespace proveout {

struct UnseenVolume {
  double mm3 = 0.0;           ///< material that there is more than under the surface
  double error_mm3 = 0.0;     ///< by how much it may be off, about
  std::size_t looked_at = 0;  ///< cells
  /// Cells which do not count as thin by themselves, but of which much is missed; middle of the first, mm.
  ThinCells thin{};
};

/// By how much the volume may be off, about, because an edge lies somewhere in a cell of which only crossings
/// are known, mm3.
double unknownBesideEdges(const SurfaceGrid& grid);

/// Compares what is left in truth with what is under the surface: in the cells where a face ends before the
/// vertex, in thin ones if they are few, then in those beside them as long as something is missed. Where it
/// is not known what was cut, and from what, or where that is much work, there is an error alone. Empty when
/// cancelled. Does not depend on threads.
UnseenVolume unseenVolume(const SurfaceGrid& grid, Progress& progress);

}  // namespace proveout
