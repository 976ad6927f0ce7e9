// Moves in machine coordinates: what is known of machine zero.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Carries a MachineMove out at rapid and leaves the control there.
bool performMachineMove(IsoContext& c, BlockPlan& plan);
/// The reference point that nobody named: where the machine starts, no lower than where it changes tools.
/// Machine coordinates, mm.
Vec3 homeOf(const IsoContext& c);
/// Whether the job or the program says where machine zero lies from the workpiece.
bool machineZeroKnown(const IsoContext& c);

}  // namespace proveout::nc
