// The heights at which sections of a leaning wire's cut are made, and the walls between them.
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/wire/level_match.h"

namespace proveout {

/// Between two levels that follow each other.
struct LevelSlab {
  std::uint32_t lower = 0, upper = 0;  ///< levels
  std::vector<Ribbon> ribbons;
  std::vector<double> volumes;  ///< by ribbon: what its loops go round, mm3, below 0 for hollows
  /// Loops whose walls end, part or join within the slab, which then is thinner than 0.001 mm.
  std::vector<std::uint32_t> lower_alone, upper_alone;
};

struct LeanLevels {
  std::vector<LevelSection> levels;  ///< from below
  std::vector<LevelSlab> slabs;      ///< from below, all of the height
};

/// Halves the height until the walls between neighbouring levels leave the section half way by no more than
/// `tolerance` mm. Errors: cancelled.
Result<LeanLevels> leanLevels(const std::function<LevelSection(double z)>& section, double low, double high,
                              double tolerance, Progress& progress);

}  // namespace proveout
