// The contour of G70, G71, G72: the lines of a subroutine.
#pragma once

#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// A contour in (Z, X), radii, mm, program coordinates.
struct LinuxCncProfile {
  Vec2 begin = Vec2::Zero();
  PlaneContour contour;  ///< from `begin` on
};

/// The motions of `o<number> sub` of the program in hand; `from`: where the tool stands, (Z, X). False:
/// reported.
bool readLinuxCncProfile(IsoContext& c, const BlockPlan& plan, std::int64_t number, const Vec2& from,
                         LinuxCncProfile& out);

}  // namespace proveout::nc
