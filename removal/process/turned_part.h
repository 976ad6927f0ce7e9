// Which of the bodies that turning leaves is the part.
#pragma once

#include "removal/process/part_choice.h"
#include "removal/process/workpiece.h"

namespace proveout {

/// What holds options.part_point; without a point what is most like options.part, along Z and in its radius;
/// without that the largest piece that a programmed parting cut off in front of what the chuck holds; else
/// the larger one. Pieces that a parting leaves of less than 0.1 % of what is held are splinters. Requires a
/// body; those of TurnedStock::shape(), what is held first. Error: the point lies in no body.
Result<PartChoice> partAmong(const std::vector<SectionBody>& bodies, const PieceOptions& options);

}  // namespace proveout
