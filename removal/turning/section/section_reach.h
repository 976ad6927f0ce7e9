// Where a tool may meet the edges of a section. Only for the .cpp files of sections: pulls in Clipper.
#pragma once

#include <optional>
#include <vector>

#include "removal/turning/section/section_chains.h"

namespace proveout::section_detail {

struct Bounds {
  IntPoint low, high;
};

/// A box outside of which nothing of `tool` has anything in common with the area: of the places where edges
/// of the area come near the tool, or of all of the tool where a part of it lies deep in the area. Nothing:
/// the tool stays off the area. `tool`: closed polygons.
std::optional<Bounds> reachOf(const std::vector<ChainLoop>& area, const ClipperLib::Paths& tool);

}  // namespace proveout::section_detail
