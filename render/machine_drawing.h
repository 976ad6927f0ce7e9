// A machine as a mesh, for a picture of its axes.
#pragma once

#include "core/machine/machine_model.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Linear axes as rods along their travel, rotary ones as rings about their axis with a rod through it, the
/// tool as a cylinder. With all axes at 0, machine frame, mm. Closed bodies, not joined.
TriMesh machineDrawing(const MachineModel& model);

}  // namespace proveout
