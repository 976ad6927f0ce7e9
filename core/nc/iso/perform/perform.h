// Carrying planned blocks out.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Plans the block in hand: all checks, on the plan's copy of the state. Changes nothing in the control.
/// False: an error was reported.
bool planBlock(IsoContext& c, BlockPlan& plan);
/// The M functions of the block in hand, as planBlock() takes them. False: an error was reported.
bool collectM(IsoContext& c, BlockPlan& plan);
/// Carries the plan out and makes its state the control's. False: an error was reported.
bool perform(IsoContext& c, BlockPlan& plan);

/// Runs the block's M functions and speed changes of one phase.
bool performFunctions(IsoContext& c, BlockPlan& plan, MPhase phase);

/// Perform function of the motion codes: plan.motion.
bool performMove(IsoContext& c, BlockPlan& plan);
/// The dwell of plan.payload. False: an error was reported.
bool performDwell(IsoContext& c, BlockPlan& plan);
/// Links cutter compensation in front of the block's first motion, where the block has it on.
void engageComp(IsoContext& c, const BlockPlan& plan);
/// The block as an item of that kind: a motion, or one that stays.
bool pushMotion(IsoContext& c, BlockPlan& plan, PathItem::Kind kind);

}  // namespace proveout::nc
