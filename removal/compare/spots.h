// Findings of many spots: what one tool left side by side is told once.
#pragma once

#include <vector>

#include "removal/compare/deviation_patches.h"

namespace proveout {

/// Makes one of patches of the same kind that a motion has a part of both of, or that lie nearer to each
/// other than `options.spot_gap` says of their makers. Patches one of which is more than five times as deep
/// as the other stay apart: they have another cause.
std::vector<FoundPatch> joinSpots(std::vector<FoundPatch> found, const CompareOptions& options);

}  // namespace proveout
