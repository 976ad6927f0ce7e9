// Places of a section that are thinner than a mesh can hold. Only for the .cpp files of sections: pulls in
// Clipper.
#pragma once

#include <vector>

#include "removal/wire/lean/level_section.h"
#include "removal/wire/section/kerf_union.h"

namespace proveout::wire_detail {

/// Least distance between walls of a section, mm: some steps of a mesh at its outermost corner.
double leastWidth(const std::vector<LevelLoop>& loops);

/// Whether edges come nearer to each other than this, mm, but for those that follow each other.
bool hasThinPlaces(const std::vector<LevelLoop>& loops, double width);

/// The section without material and gaps that are thinner than `width` mm. What is thicker stays, except that
/// sharp corners become blunt, as wide as that.
std::vector<PathRegion> withoutThinPlaces(const std::vector<PathRegion>& regions, double width);

}  // namespace proveout::wire_detail
