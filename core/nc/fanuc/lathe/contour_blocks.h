// The contour of G70 to G73: blocks ns to nf of the program (section 16).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/nc/iso/context/context.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// Lines of a contour, by index: `first` has N ns, `last` N nf.
struct ContourLines {
  std::size_t first = 0, last = 0;
};
/// By P and Q of the block in hand, the name of whose code is `code`. False: 061, 063, reported.
bool findContour(IsoContext& c, const BlockPlan& plan, const std::string& code, ContourLines& lines);

/// What the blocks of a contour move along, in the plane (z, x), work coordinates, X a radius, mm. The first
/// element leads from where the cycle starts to the contour.
struct BlockContour {
  PlaneContour elements;
  std::vector<SourceRef> sources;         ///< by ContourElement::source
  std::vector<bool> rapids;               ///< the same
  bool names_x = false, names_z = false;  ///< words of the first block
};

/// Reads the contour as if its blocks ran from the place of the tool on; feeds, speeds, tools, compensation
/// and functions are left out. The control is as before then, but for variables. False: 064 to 069, reported.
bool readContour(IsoContext& c, const BlockPlan& plan, const ContourLines& lines, BlockContour& contour);

}  // namespace proveout::nc
