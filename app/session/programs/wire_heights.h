// Heights of the workpiece that a wire EDM control counts with, where the job leaves them open.
#pragma once

#include "core/geometry/types.h"
#include "core/nc/control/control_settings.h"
#include "core/path/toolpath.h"
#include "io/job/job.h"

namespace proveout {

/// Gives T and ZB of [control.wedm] the height of the blank and of its bottom, where the job does not name
/// them. `blank`: bounds in the workpiece frame, mm. Settings of another control stay as they are.
void giveWireHeights(const Job& job, const Box3& blank, ControlSettings& settings);

/// Warns of a T or a ZB of the job that is not that of the blank, and, behind another setup, where a wire
/// leans by heights that only the blank tells. `path`: of the setup `k` of the job; takes the warnings.
void noteWireHeights(const Job& setup, std::size_t k, const Box3& blank, Toolpath& path);

}  // namespace proveout
