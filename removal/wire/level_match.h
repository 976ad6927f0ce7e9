// Which points of sections at two heights belong together, by the names of their edges.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "removal/wire/level_section.h"

namespace proveout {

/// Loops of two sections that are the same wall, as far as their names say.
struct LoopPairs {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< lower, upper
  std::vector<std::uint32_t> lower_alone, upper_alone;
};
LoopPairs pairLoops(const LevelSection& lower, const LevelSection& upper);

/// A wall between two loops, as a strip of triangles: each rung goes from a point of the lower loop to one of
/// the upper; from a rung to the next, the last to the first, one of both goes to its loop's next point.
struct Ribbon {
  std::uint32_t lower_loop = 0, upper_loop = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rungs;
};
/// Rungs join what has one name; what has none at the other height closes up between. None: the loops have no
/// name in common, or nothing but a point would be left of one of them.
std::optional<Ribbon> ribbonBetween(const LevelSection& lower, std::uint32_t lower_loop,
                                    const LevelSection& upper, std::uint32_t upper_loop);

}  // namespace proveout
