// The heights at which sections of a leaning wire's cut are made, and the walls between them.
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "removal/wire/lean/crossed_walls.h"
#include "removal/wire/lean/level_match.h"

namespace proveout {

/// Between two levels: the walls that need none between these, and where walls meet or end.
struct LevelSlab {
  std::uint32_t lower = 0, upper = 0;  ///< levels
  std::vector<Ribbon> ribbons;         ///< whole walls and parts of them
  struct Volume {
    std::uint32_t lower_loop = 0;
    double mm3 = 0.0;  ///< what the wall goes round between the levels, below 0 for hollows
  };
  std::vector<Volume> volumes;  ///< of each wall no part of which needs a level between
  /// Loops whose walls end, part or join within the slab, which then is thinner than 0.001 mm.
  std::vector<std::uint32_t> lower_alone, upper_alone;
};

/// A loop through which a wall goes straight on, without points there.
struct PassedLoop {
  std::uint32_t level = 0, loop = 0;
  std::uint32_t other_level = 0, other_loop = 0;  ///< of the same wall; may be passed as well
};

struct LevelPoint {
  std::uint32_t level = 0, loop = 0, point = 0;
};
/// A rung beside which one part of a wall has another level and the other has not: that has its point, too.
struct LevelSplit {
  LevelPoint lower, middle, upper;
};

/// A rung with points of its own, see CurvedRung. Its parts may be split, too.
struct LevelCurve {
  LevelPoint lower, upper;
  Vec2 middle = Vec2::Zero();
  std::uint32_t rows = 1;
  bool between = false;
};

struct LeanLevels {
  std::vector<LevelSection> levels;  ///< from below
  /// Each point of a loop ends one wall and begins one, or is passed.
  std::vector<LevelSlab> slabs;
  std::vector<PassedLoop> passed;
  std::vector<LevelSplit> splits;
  std::vector<LevelCurve> curves;
};

using SectionMaker = std::function<LevelSection(double z, ThinPlaces thin)>;
/// Makes a mesh of levels and tells what of it runs through itself. If nothing does it may take the levels.
using LevelsUse = std::function<Result<std::vector<CrossedTriangle>>(LeanLevels& levels)>;

/// Halves the height of walls, and of parts of them, until their triangles leave the section half way by no
/// more than `tolerance` mm, or are as far from parabolas through it. Where the mesh that is made of it runs
/// through itself sections are made without thin places and heights are halved once more, and another mesh is
/// made, some times. Errors: cancelled, and
/// those of the first mesh.
Status leanLevels(const SectionMaker& section, double low, double high, double tolerance,
                  const LevelsUse& use, Progress& progress);

}  // namespace proveout
