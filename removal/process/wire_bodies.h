// Which of the bodies that a wire leaves is the part.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// The body whose bounds are most like the wanted ones seen from +z; the first where none are wanted.
/// Requires bodies.
std::size_t bodyLike(const std::vector<Box3>& bounds, const std::optional<Box3>& wanted);

}  // namespace proveout
