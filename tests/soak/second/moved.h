// The same job said in another way.
#pragma once

#include "tests/soak/second/dice.h"
#include "tests/soak/second/plan.h"

namespace proveout::soak::second {

/// Clamping k written in coordinates that are `move` of what they were; its neighbours stay. Turns but by
/// quarters are for blanks that can be turned (canTurnFreely).
Plan moved(const Plan& plan, std::size_t k, const Move& move);
/// A job of one clamping seen in a mirror: x becomes -x.
Plan mirrored(const Plan& plan);
bool canTurnFreely(const Plan& plan);
/// Every motion that can be parted in two without being another one is.
Plan split(const Plan& plan);
/// With another clamping in front of the k-th one, that cuts nothing; `move` lies between.
Plan withIdle(const Plan& plan, std::size_t k, Control control, const Move& move, Dice& dice);
/// Half the grid, half the facets.
Plan finer(const Plan& plan);

}  // namespace proveout::soak::second
