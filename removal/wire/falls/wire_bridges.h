// Bridges: what a cut that does not close left between its end and what was cut before, and on which a piece
// still hangs.
#pragma once

#include <vector>

#include "core/path/toolpath.h"
#include "removal/grid/stock.h"
#include "removal/wire/falls/wire_work.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {

/// Where a contour ends or begins: a run of cuts does, or, in a run with an offset, that does; or the program
/// stops on it.
struct CutEnd {
  Vec2 at = Vec2::Zero();       ///< of the wire's middle, mm
  double kerf_mm = 0.0;         ///< half its width
  MotionId motion = kNoMotion;  ///< the cut that ends there, or begins
};
std::vector<CutEnd> cutEnds(const Toolpath& path, const WireWork& work);

/// The bridges between those ends and what is across from them in the bodies that are left, up to 10 mm wide,
/// if cutting them would part a body into pieces that are wider than the bridge. Where several bridges hold a
/// piece its volume is not told. `z`: where they are told to be; heights in mm.
std::vector<UncutBridge> findBridges(const std::vector<PlaneBody>& bodies, const std::vector<CutEnd>& ends,
                                     double height_mm, double z);

}  // namespace proveout
