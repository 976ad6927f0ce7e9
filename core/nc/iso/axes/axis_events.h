// What M codes of the machine builder do to the axes, and axes with two drives (manual 20.2 to 20.8).
//
// Zeros are places of the machine: each offset stays with its axis, under whatever name that moves. Lengths
// stay with their axis when names are exchanged, and lie along the programmed directions. G53, G28 and G30
// name machine positions: reversed axes go to them all the same.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Checks the events, drives and directions of the settings, and couples what never parts. False: an error
/// was reported.
bool checkMachineAxes(IsoContext& c);
/// Axes with two drives: slaves are where their masters are. Before any motion.
void levelDrives(IsoContext& c);

/// Carries an event out; the pipe lets go what it holds. False: an error was reported.
bool performAxisEvent(IsoContext& c, const MachineEvent& event);
/// Slaves are where the block has taken their masters.
void followMasters(IsoContext& c);

/// Whether what the block leaves in force goes together with exchanged, reversed, coupled and parked axes.
/// False: an error was reported.
bool checkAxisModes(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
