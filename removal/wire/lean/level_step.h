// A level face where walls of a leaning wire's cut meet, part or end.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "removal/wire/lean/level_section.h"

namespace proveout {

/// Between two sections so near in height that what differs is a face: material below it alone looks up,
/// material above it alone looks down. Numbers count `points`.
struct LevelStep {
  double z = 0.0;            ///< mm, half way between the sections
  std::vector<Vec2> points;  ///< mm
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// By loop that ends or begins here, by corner k: the points from there to the next corner, both counted.
  using Chains = std::vector<std::vector<std::uint32_t>>;
  std::vector<Chains> lower, upper;
};

/// For the loops named alone; the others are the same on both. None: rounding left the face open.
std::optional<LevelStep> levelStep(const LevelSection& lower, const std::vector<std::uint32_t>& lower_loops,
                                   const LevelSection& upper, const std::vector<std::uint32_t>& upper_loops);

}  // namespace proveout
