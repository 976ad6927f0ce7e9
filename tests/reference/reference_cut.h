// One program, cut by the engine and by the reference, and how far they are from each other.
#pragma once

#include <optional>
#include <string>

#include "tests/reference/small_program.h"

namespace proveout::reference {

/// Of volumes relative to what is removed; lengths mm.
struct Comparison {
  double removed_mm3 = 0.0;    ///< by the engine
  double told = 0.0;           ///< by how much it may be off, as the engine tells
  std::size_t thin_cells = 0;  ///< of the engine: where walls are thinner than its grid
  double film_mm2 = 0.0;       ///< of walls that it tells to have lost
  double more = 0.0;           ///< removed by the engine than by the reference
  double unsure = 0.0;         ///< between the reference and one of facets twice as large
  int facets = 0;              ///< of the reference, around a tool
  /// Where edges of the reference are nearer to each other than the grid can tell, nothing is compared. What
  /// is off by more than a vertex may be and beside walls or gaps of the reference that are thin is counted
  /// alone.
  std::size_t vertices = 0, crowded = 0;  ///< compared, and not
  std::size_t beside_thin = 0;            ///< vertices and pieces of edges
  double face_mm = 0.0, edge_mm = 0.0;    ///< vertices off the truth: away from its edges, beside them
  double missed_mm = 0.0;                 ///< edges of the reference off the engine's mesh
  std::string places;                     ///< of the three
};

/// `facets`: around a tool. None: no reference could be made, as booleans of solids that touch may fail.
std::optional<double> removedByReference(const SmallProgram& program, int facets);
/// `aim`: how far the volume should be off at most, relative. Where the engine is farther off than that and
/// what it tells, the facets are halved until they decide.
std::optional<Comparison> compareWithReference(const SmallProgram& program, double grid_mm, int facets,
                                               double aim);

}  // namespace proveout::reference
