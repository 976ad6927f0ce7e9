// Tolerances of the surface that hold on some faces or regions alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "removal/compare/comparison.h"
#include "removal/compare/measured_sides.h"

namespace proveout {

/// Of each sample the place in CompareOptions::local of the last one that fits, from 1; 0: none does. Faces
/// are those of the nominal, of machined samples that of the nearest one.
struct ToleranceGroups {
  std::vector<std::uint16_t> machined, nominal;
};
ToleranceGroups groupSamples(const BothSides& sides, const CompareOptions& options);

/// The sides with all samples left out that are of another group.
BothSides onlyGroup(const BothSides& sides, const ToleranceGroups& groups, std::uint16_t group);

}  // namespace proveout
