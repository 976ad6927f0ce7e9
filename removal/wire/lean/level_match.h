// Which points of sections at two heights belong together, by the names of their edges.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "removal/wire/lean/level_section.h"

namespace proveout {

/// Loops of two sections that are the same wall, as far as their names say.
struct LoopPairs {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< lower, upper
  std::vector<std::uint32_t> lower_alone, upper_alone;
};
LoopPairs pairLoops(const LevelSection& lower, const LevelSection& upper);

/// Points of a loop that follow each other: from point `first` on, `edges` edges; at most all of the loop.
struct LoopSpan {
  std::uint32_t first = 0, edges = 0;
};
/// The point where a span ends.
std::uint32_t endOf(const LevelLoop& loop, const LoopSpan& span);

/// A wall between two loops, or a part of one, as a strip of triangles: each rung goes from a point of the
/// lower loop to one of the upper; from a rung to the next one of both goes to its loop's next point. Of
/// whole loops the last rung is the first.
struct Ribbon {
  std::uint32_t lower_loop = 0, upper_loop = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rungs;
  std::vector<std::size_t> starts;  ///< rungs where edges with a common name begin
};
/// Rungs join what has one name; what has none at the other height closes up between. None: the loops have no
/// name in common, or nothing but a point would be left of one of them.
/// `lower_loop` and `upper_loop` are to be set.
std::optional<Ribbon> ribbonBetween(const LevelLoop& lower, const LevelLoop& upper);
/// The same for spans whose first edges have a common name.
std::optional<Ribbon> ribbonBetween(const LevelLoop& lower, const LoopSpan& lower_span,
                                    const LevelLoop& upper, const LoopSpan& upper_span);

/// Between sections so near in height that walls stand upright as good as: whether all rungs do. Where loops
/// part or join names alone may join what is far off.
bool isUpright(const Ribbon& ribbon, const LevelLoop& lower, const LevelLoop& upper);

}  // namespace proveout
