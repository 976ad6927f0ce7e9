// The heights at which sections of a leaning wire's cut are made, and the walls between them.
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/wire/level_match.h"

namespace proveout {

/// Between two levels: the walls that need none between these, and where walls meet or end.
struct LevelSlab {
  std::uint32_t lower = 0, upper = 0;  ///< levels
  std::vector<Ribbon> ribbons;
  std::vector<double> volumes;  ///< by ribbon: what its loops go round, mm3, below 0 for hollows
  /// Loops whose walls end, part or join within the slab, which then is thinner than 0.001 mm.
  std::vector<std::uint32_t> lower_alone, upper_alone;
};

/// A loop through which a wall goes straight on, without points there.
struct PassedLoop {
  std::uint32_t level = 0, loop = 0;
  std::uint32_t other_level = 0, other_loop = 0;  ///< of the same wall; may be passed as well
};

struct LeanLevels {
  std::vector<LevelSection> levels;  ///< from below
  std::vector<LevelSlab> slabs;      ///< each loop of a level ends one wall and begins one, or is passed
  std::vector<PassedLoop> passed;
};

/// Halves the height of each wall until its triangles leave the section half way by no more than `tolerance`
/// mm. Errors: cancelled.
Result<LeanLevels> leanLevels(const std::function<LevelSection(double z)>& section, double low, double high,
                              double tolerance, Progress& progress);

}  // namespace proveout
