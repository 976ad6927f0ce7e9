// What controls with IsoRules::holds_length, and those that turn planes without moving, keep in HeldWay.
#pragma once

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {

/// After the length of the block is known and its chain is made: axes whose length it changes wait.
void holdLength(IsoContext& c, BlockPlan& plan);
/// After the chain of the block is made: the program counts axes of the plane from `counted` on, program
/// coordinates, wherever the machine is. `in_steps`: see HeldWay.
void holdPlane(BlockPlan& plan, const AxisPoint& counted, bool in_steps);
/// After the axis words of a block: axes that wait go their way, and wait no more.
void goHeldWay(IsoContext& c, BlockPlan& plan, AxisPoint& target, WordsAre words);

/// Before the machine settles at `to`, where it went without a programmed motion: axes that moved wait no
/// more, and cutter compensation has lost its vector.
void endHeldWay(IsoContext& c, BlockPlan& plan, const AxisPoint& to);

}  // namespace proveout::nc
