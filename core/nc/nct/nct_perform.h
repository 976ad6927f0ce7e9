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
/// A function of the block in hand, for the pipe: where it runs, its source, the compensation of `state`.
PathItem functionItem(const NctContext& c, PathItem::Kind kind, const NctState& state);
/// An event of the path in its turn, and the time that it takes.
bool sendEvent(NctContext& c, EventKind what, double time_s = 0.0);
/// The spindle from here on; the direction in force becomes `direction`.
bool sendSpindle(NctContext& c, int direction, double rpm);
/// The spindle stops oriented.
bool sendOriented(NctContext& c);
/// The spindle stops and its position loop closes where it stands.
bool sendPositionLoop(NctContext& c);

/// Perform function of the motion codes: plan.motion.
bool performMove(NctContext& c, BlockPlan& plan);
/// The block as an item of that kind: a motion, or one that stays.
bool pushMotion(NctContext& c, BlockPlan& plan, PathItem::Kind kind);
/// A rapid to a point of the machine, as an item of its own. The caller settles there.
bool sendMachineRapid(NctContext& c, const AxisPoint& to);
/// The machine stands at `machine` by other means than a programmed motion.
void settle(NctContext& c, const AxisPoint& machine);
/// Lets go what the pipe holds; what comes then starts anew from where the machine is. False: an error was
/// reported.
bool flushPipe(NctContext& c);
/// Tells the pipe that the machine or its frames have changed.
void rebasePipe(NctContext& c);
/// Behind an error of a stage: forgets what waits and goes on from where the tool is.
void recover(NctContext& c);

}  // namespace proveout::nc
