// Five axes: length along the tool, dynamic zero, tilted planes (manual 25.2 to 25.11).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The tool stands along a direction that is nearer to it than this (sine): a ten thousandth of a degree.
inline constexpr double kAlongToolSine = 1.7e-6;

/// Whether the rotary axes turn from where they are to a machine position.
bool turnsRotaryAxes(const IsoContext& c, const AxisPoint& machine);
/// Whether the machine turns tool or part, as the code of that name needs. False: reported.
bool hasFiveAxes(IsoContext& c, const char* name);
/// G69.1, and the end of a definition of a tilted plane that is not whole. False: an error was reported.
bool planTiltState(IsoContext& c, BlockPlan& plan);
/// G43.1, and H while it is in force.
bool planLengthAlongTool(IsoContext& c, BlockPlan& plan);
/// The P of G54.2.
bool planDynamicZero(IsoContext& c, BlockPlan& plan);
/// Whether axes without a word keep their programmed coordinate when the block's frames change: the machine
/// moves there. Else it stands, and its coordinates change.
bool holdsPosition(const IsoContext& c, const BlockPlan& plan);
/// After the axis words: where a rotary axis moves that the coordinates depend on, they are those of its end.
/// Sets chain, start and the axes of `target` without a word.
/// False: an error was reported.
bool followRotaryAxes(IsoContext& c, BlockPlan& plan, AxisPoint& target);
/// After the arc is resolved: where the block's frames have moved its start away from where the machine
/// stands, the arc of the control point (25.2). False: an error was reported.
bool carryArc(IsoContext& c, BlockPlan& plan);
/// A feed with a head that leans while G43 or G44 lays the length along a main axis is warned of.
void warnOfLengthBesideTool(IsoContext& c, const BlockPlan& plan, const AxisPoint& target);

}  // namespace proveout::nc
