// What a leaning wire covers at one height, as polygons. Only for the .cpp files of sections: pulls in
// Clipper.
#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

#include "removal/wire/lean/lean_stretch.h"

namespace proveout::wire_detail {

/// The kerf of all stretches at their height: paths whose windings above 0 are the kerf.
ClipperLib::Paths leanKerf(const std::vector<LevelStretch>& stretches);

}  // namespace proveout::wire_detail
