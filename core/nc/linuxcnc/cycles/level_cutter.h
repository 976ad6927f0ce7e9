// Levels of G71 and G72 over a contour, and the ways along it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// A move of a cycle, from where the one before ended.
struct LevelMove {
  bool rapid = false;
  ContourElement element;
};

/// What of the pockets of a contour is cut: stretches that fall behind others that rise.
enum class Pockets {
  kAll,   ///< roughed in levels, each one when the way along the contour has come to it
  kNone,  ///< passed over on the level of their first edge
  kOnly   ///< the first fall is not roughed: the tool follows it, and goes on with the pockets
};

struct LevelRules {
  double step = 1.0;     ///< between levels, mm, > 0
  double retract = 0.5;  ///< off the contour at the end of a level, along both axes, mm, >= 0
  Pockets pockets = Pockets::kAll;
};

/// Most moves that a caller gets.
inline constexpr std::size_t kMostLevelMoves = 1'000'000;

/// Contour in (u, v), mm: u goes on all the way, v is the height over the material. Its first element leads
/// from the tool to the begin of the contour, and its last one up to the height of the tool at least. Levels
/// count from there. Empty: more than kMostLevelMoves.
std::vector<LevelMove> cutLevels(const PlaneContour& contour, const LevelRules& rules);

}  // namespace proveout::nc
