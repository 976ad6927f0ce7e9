// Unions of kerf outlines and the regions that are left. Only for the .cpp files of sections: pulls in
// Clipper.
#pragma once

#include <polyclipping/clipper.hpp>
#include <vector>

#include "removal/wire/section/plane_region.h"

namespace proveout::wire_detail {

/// Stretches whose outline is one polygon: its crossings grow with the square of what overlaps.
inline constexpr std::size_t kOutlineStretches = 48;

/// What the paths wind round once or more, counter-clockwise.
ClipperLib::Paths united(const ClipperLib::Paths& paths);
/// All of the parts, each a union by itself, as few paths with windings above 0 inside. Neighbours are united
/// in levels: where the library joins two outlines it walks both, so that many small ones with a long one
/// would take the square of their number.
ClipperLib::Paths unitedInLevels(std::vector<ClipperLib::Paths> parts);

/// A polygon as integers.
ClipperLib::Path pathOf(const std::vector<Vec2>& points);
/// Loops as polygons whose chords leave arcs by no more than `tolerance` mm.
ClipperLib::Paths pathsOf(const std::vector<PlaneLoop>& loops, double tolerance);

/// Twice the area by the length of the border, mm.
double meanThickness(const ClipperLib::Path& path);

/// Loops of one region, its border first, counter-clockwise, then its hollows.
using PathRegion = std::vector<ClipperLib::Path>;
/// `blank` less `kerf`; regions and hollows that are rounding are left out.
std::vector<PathRegion> regionsLeft(const ClipperLib::Paths& blank, const ClipperLib::Paths& kerf);

}  // namespace proveout::wire_detail
