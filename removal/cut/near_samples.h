// Material beside a part of a tool: where what passes between the samples is looked for.
#pragma once

#include <cstdint>
#include <vector>

#include "removal/cut/pass.h"

namespace proveout {

/// A sample of the material that a watched part comes near to.
struct NearSample {
  std::uint32_t pass;  ///< of the part
  Vec3 where;
};

/// How far from the part material is looked for, in grid steps: a corner of the material has a sample within
/// a step along each axis.
inline constexpr double kNearLevel = 1.5, kNearUpright = 1.05;

/// Adds samples of a quarter of a leaf that stand nearest to pass `number` of `table`, one for each side on
/// which there are any; none where the part goes through one, as that is found without. `leaf.covered`: what
/// the part's envelope covers.
void addNearSamples(const PassTable& table, std::uint32_t number, const LeafColumns& leaf, int quarter,
                    std::vector<NearSample>& out);

}  // namespace proveout
