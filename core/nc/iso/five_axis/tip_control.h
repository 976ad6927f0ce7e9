// Tool centre point control: G43.4 and G43.5, with and without shank control (manual 25.14, 25.16).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Whether a code of the length group is one of them.
constexpr bool holdsTip(std::int32_t length_code10) {
  return length_code10 == gcode::kTipByAngles || length_code10 == gcode::kTipByVector;
}
/// G43.4, G43.5, their H and the vector I, J, K while they are in force. False: an error was reported.
bool planTipControl(IsoContext& c, BlockPlan& plan);
/// G49 while they are in force. False: an error was reported.
bool leavesTipControl(IsoContext& c, const BlockPlan& plan);
/// Whether the block has a motion: axis words, or a direction.
bool namesMotion(const IsoContext& c, const BlockPlan& plan);
/// After the axis words of a block under G43.5: the rotary axes where the tool has the programmed direction.
/// False: an error was reported.
bool takeToolVector(IsoContext& c, BlockPlan& plan, AxisPoint& target);
/// Of the two positions for a direction (workpiece frame, tables at 0) the one that the control takes
/// (25.11). None: reported.
std::optional<RotaryAngles> chooseAngles(IsoContext& c, const Vec3& tool_vector);
/// Whether the block turns a rotary axis while the tip is held on its way.
bool turnsAboutTip(const IsoContext& c, const BlockPlan& plan);
/// Sends the motion of such a block.
bool performTipMove(IsoContext& c, BlockPlan& plan);

}  // namespace proveout::nc
