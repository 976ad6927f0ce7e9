// What plans are made of.
#pragma once

#include "tests/soak/second/dice.h"
#include "tests/soak/second/plan.h"

namespace proveout::soak::second {

using Box = Eigen::AlignedBox3d;

/// A clamping that mills what is in `region`, seen from +Z.
Clamping milledWork(Dice& dice, const Box& region, double grid, Control control);
/// A clamping that turns a bar about Z.
Clamping turnedWork(Dice& dice, const Solid& bar, Control control);
/// Wires through what is in `region`; `taper_deg` 0: upright.
Clamping wireWork(Dice& dice, const Box& region, double taper_deg);

/// Blanks: any that can be milled; upright boxes, cylinders and tubes; bars about Z that end at Z0 or a
/// little above.
Solid milledBlank(Dice& dice, double grid);
Solid uprightBlank(Dice& dice, double grid);
Solid barBlank(Dice& dice, double grid);

/// The table of a milling tool with about this diameter.
std::string milledTool(Dice& dice, int number, double diameter);

}  // namespace proveout::soak::second
