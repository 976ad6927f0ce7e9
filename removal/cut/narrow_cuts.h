// Cuts so narrow that they pass between the samples of the grid.
#pragma once

#include <vector>

#include "removal/cut/leaf_cutter.h"

namespace proveout {

/// Follows the passes of narrow tools through the stock as it is after the run: where the tool stood in
/// material that the grid still holds whole, and none of the columns around shows the pass, the cut is lost.
/// One entry for each tool, in the order of their numbers. Independent of threads.
std::vector<NarrowCut> findNarrowCuts(const Stock::Impl& impl, const PassTable& table, const Toolpath& path);

}  // namespace proveout
