// Frames of LinuxCNC: machine = G5x + turn by its R of (work + G92) + tool offset.
#pragma once

#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {

/// The id of system 1 to 9 (G54 .. G59.3).
WorkSystemId linuxCncSystem(int number);
/// Makes the frames that the block has planned those of the channel.
void applyLinuxCncFrames(IsoContext& c, const BlockPlan& plan);
/// G10 L2, or with `by_place` L20.
bool planLcnWorkOffset(IsoContext& c, BlockPlan& plan, bool by_place);

/// Is the tool in the table? With an empty table every tool is, told once.
bool linuxCncHasTool(IsoContext& c, int tool);
/// Its offset, mm and degrees.
AxisPoint linuxCncToolOffset(const IsoContext& c, int tool);
/// The tool in the spindle as G codes of the block find it.
int linuxCncToolOf(const IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
