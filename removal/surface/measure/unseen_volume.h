// Volume that no crossing shows: slivers under overhangs, lips over teeth, tips of wedges and walls thinner
// than the grid.
#pragma once

#include "core/base/progress.h"
#include "removal/surface/cell/surface_grid.h"

namespace proveout {

struct UnseenVolume {
  double mm3 = 0.0;           ///< material beyond what is under the surface
  double error_mm3 = 0.0;     ///< about how much it may be off
  std::size_t looked_at = 0;  ///< cells
  /// Cells of which much is missed although they do not count as thin by themselves.
  std::size_t thin_cells = 0;
};

/// About how much the volume may be off, mm3, because only crossings are known of cells in which an edge
/// lies.
double unknownBesideEdges(const SurfaceGrid& grid);

/// Compares the material that is left with what is under the surface: in the cells where a face is trimmed
/// before the vertex, in thin ones if they are few, then in those beside them as long as something is
/// missed. Gives an error alone where it is not known what was cut, and from what, or where this is much
/// work. Empty when cancelled. Does not depend on threads.
UnseenVolume unseenVolume(const SurfaceGrid& grid, Progress& progress);

}  // namespace proveout
