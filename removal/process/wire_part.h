// Which of the bodies that a wire leaves is the part.
#pragma once

#include <vector>

#include "removal/process/workpiece.h"
#include "removal/wire/wire_stock.h"

namespace proveout {

/// Bounds over the whole height of the blank.
Box3 boundsOf(const PlaneBody& body, const PrismBlank& blank);

/// The body that holds options.part_point; without such a point the one whose bounds are most like
/// options.part; without that the largest that a fixture touches (options.held_at), else the largest.
/// `bodies`: the largest first, at least one. Error: the point lies in no body (names what is nearest).
Result<std::size_t> partAmong(const std::vector<PlaneBody>& bodies, const PrismBlank& blank,
                              const PieceOptions& options);

}  // namespace proveout
