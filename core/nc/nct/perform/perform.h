// Carrying planned blocks out.
#pragma once

#include "core/nc/nct/context/context.h"

namespace proveout::nc {

/// Plans the block in hand: all checks, on a copy of the state. Changes nothing in the control. False: an
/// error was reported.
bool planBlock(NctContext& c, BlockPlan& plan);
/// Carries the plan out and makes its state the control's. False: an error was reported.
bool perform(NctContext& c, BlockPlan& plan);

/// Runs the block's M functions and speed changes of one phase.
bool performFunctions(NctContext& c, BlockPlan& plan, MPhase phase);

/// Perform function of the motion codes: plan.motion.
bool performMove(NctContext& c, BlockPlan& plan);
/// The block as an item of that kind: a motion, or one that stays.
bool pushMotion(NctContext& c, BlockPlan& plan, PathItem::Kind kind);

}  // namespace proveout::nc
