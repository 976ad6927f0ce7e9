// Pieces that come free while a wire cuts, and fall: what comes behind does not cut them.
#pragma once

#include <vector>

#include "removal/grid/stock.h"
#include "removal/wire/falls/wire_holding.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

/// A piece as it fell.
struct FreePiece {
  PlaneBody body;
  CutTime fell;              ///< what was cut by then
  bool passed_over = false;  ///< what is cut behind that would have cut it
  PlanePolygons region;      ///< its loops, where it was passed over
  std::uint32_t closed = 0;  ///< the stretch that closed its cut
};

struct WireFalls {
  std::vector<FreePiece> pieces;  ///< in the order of their fall
  /// All bodies after the last cut, the largest first; those that fell are as they were then.
  std::vector<PlaneBody> bodies;
};

/// `last`: the bodies after all cuts, as if nothing had fallen. Crumbs smaller than the kerf's circle stay as
/// they are, but for those of a piece that fell before. Pieces that came free and were cut away wholly by
/// what followed are not known.
WireFalls findFalls(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
                    std::vector<PlaneBody> last, const WireHolding& holding);

/// The first stretch behind the motion that closed the cut and before `end` that goes through the convex hull
/// of the piece, where it may still lie; `end` if there is no such stretch.
std::uint32_t firstThrough(const FreePiece& piece, const std::vector<WireStretch>& cuts, std::uint32_t end);

}  // namespace proveout
