// Carrying planned blocks out.
#pragma once

#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// Plans the block in hand: all checks, on a copy of the state. Changes nothing in the control. False: an
/// error was reported.
bool planBlock(NctContext& c, BlockPlan& plan);
/// Carries the plan out and makes its state the control's. False: an error was reported.
bool perform(NctContext& c, BlockPlan& plan);

/// Runs the block's M functions and speed changes of one phase.
bool performFunctions(NctContext& c, BlockPlan& plan, MPhase phase);
/// An action in its turn: now, or behind what cutter compensation still holds. `state` is the one in force.
bool act(NctContext& c, Action action, const NctState& state);
/// An action at once.
void runAction(NctContext& c, Action& action);
/// Kind, speed and name of a spindle action; the direction is the one in force.
void setSpindleAction(NctContext& c, Action& action, double rpm);

/// Perform function of the motion codes: plan.motion.
bool performMove(NctContext& c, BlockPlan& plan);
/// The planned motion to c.machine, at once, past cutter compensation.
void emitMove(NctContext& c, const PlannedMotion& motion);
/// The machine stands at `machine` by other means than a programmed motion.
void settle(NctContext& c, const AxisPoint& machine);

// Cutter compensation.
bool engageComp(NctContext& c, const BlockPlan& plan);
bool pushComp(NctContext& c, const CompBlock& block, Action action);
bool flushComp(NctContext& c);
void rebaseComp(NctContext& c);
/// The programmed position in the plane (u, v, w), mm.
Vec3 workPlanePosition(const NctContext& c);

}  // namespace proveout::nc
