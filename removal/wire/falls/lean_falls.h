// Pieces that leaning wires cut free: which of them fall, and when.
#pragma once

#include <vector>

#include "removal/wire/falls/wire_falls.h"
#include "removal/wire/lean/lean_solid.h"
#include "removal/wire/section/prism_blank.h"

namespace proveout {

/// A piece that is free at the bottom, half way and at the top.
struct LeanFall {
  std::vector<std::size_t> bodies;  ///< of the solid: what all cuts have left of it
  CutTime fell;                     ///< what was cut when it was free at all of these heights
  bool passed_over = false;         ///< what is cut behind that would cut it
  bool falls = true;                ///< it can leave downwards past what is held; else it stays where it is
  bool lifts = true;                ///< it can leave upwards
  FreePiece half_way;               ///< its section there, or elsewhere if it has none there
  double volume_mm3 = 0.0;          ///< of the bodies
};

/// Of all that `cuts` leave of the blank, `solid`. In the order in which they come free.
std::vector<LeanFall> leanFalls(const PrismBlank& blank, const std::vector<LeanStretch>& cuts,
                                const LeanSolid& solid);

}  // namespace proveout
