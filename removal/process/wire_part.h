// Which of the bodies that a wire leaves is the part.
#pragma once

#include "removal/process/part_choice.h"
#include "removal/process/workpiece.h"
#include "removal/wire/wire_stock.h"

namespace proveout {

/// The body whose bounds are most like the wanted ones seen from +z. Requires a body.
std::size_t bodyLike(const std::vector<Box3>& bounds, const Box3& wanted);

/// The body that holds options.part_point; without such a point the one whose bounds are most like
/// options.part; without that the largest that a fixture touches (options.held_at), else the largest.
/// Requires a body. Error: the point lies in no body (names what is nearest).
Result<PartChoice> partAmong(const WireStock& stock, const PieceOptions& options);

}  // namespace proveout
