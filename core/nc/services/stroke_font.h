// A font of single strokes for engraving: capitals, small capitals, digits and signs. Its own design; makers
// of controls have others.
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// A line that the tool draws without lifting; two points at least.
using Stroke = std::vector<Vec2>;

/// The strokes of a text that begins at (0, 0) and runs along +u; the capitals are 1 high. Characters that
/// the font does not have are left blank; `unknown` (may be null) gets the first of them.
std::vector<Stroke> strokesOf(std::string_view text, char* unknown = nullptr);

}  // namespace proveout
