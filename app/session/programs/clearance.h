// Where the machine stands clear of the stock: at its start and while it changes tools.
#pragma once

#include <vector>

#include "app/session/run/blank.h"
#include "core/base/diagnostics.h"
#include "core/nc/control/control_settings.h"
#include "core/tool/tool.h"
#include "io/job/job.h"

namespace proveout {

/// Distance of a lathe's start from the blank along X and along Z, mm.
inline constexpr double kTurningClearanceMm = 10.0;

/// How far the longest of the tools stands out below the point that the machine counts from, mm, not
/// negative: its gauge length. Where any tool has one, the overall length of a longer tool counts too; where
/// none has, the machine counts from the tips. Of inserts on bars that bore backwards: how far these reach
/// below the touch-off point.
double toolReach(const std::vector<Tool>& tools);

/// Start and tool change, for a blank with these bounds (workpiece frame), where the job does not say: clear
/// above the blank's top with the longest tool. A lathe starts outside of the blank and in front of it, and
/// backs off along Z for a tool change only where tools have gauge lengths: else the program says where its
/// turret turns.
void placeMachine(const Job& job, const Box3& blank, ControlSettings& settings);

/// The place of a tool change that nobody named, in a channel with work offsets of its own.
ToolChangePlace placeInChannel(const ControlSettings& control, const ControlSettings& channel);

/// Refuses a place for tool changes at which a tool of the job would stand in the blank. Only blanks with a
/// closed form are judged.
Status checkToolChange(const Job& job, const Blank& blank);

/// Warns of a place for tool changes that names no X and Y and whose height is too low for the longest tool.
/// `blank`: bounds in the clamping, workpiece frame.
void noteLowToolChange(const Job& job, const Box3& blank, Diagnostics& diagnostics);

}  // namespace proveout
