// What a run may take: memory and time, and how far its mesh may leave the surface.
#pragma once

#include "app/session/forecast/prediction.h"
#include "core/base/result.h"
#include "io/job/job.h"
#include "removal/grid/stock.h"

namespace proveout {

/// What the job allows, else what the machine has free, MB.
double memoryLimitMb(const Job& job);

/// Errors: a grid of that spacing would need more memory than the run may have; says which would fit.
Status checkMemory(const Job& job, const Workload& work, double resolution_mm);

/// Refuses what is out of proportion before it is begun: predictions are good to a factor of two.
Status checkTime(const Job& job, const Prediction& prediction);

/// How far the mesh may leave the surface to save triangles, mm: what the job says, else a tenth of the grid,
/// but where the part is compared no more than a tenth of what is tolerated.
double simplification(const Job& job, double resolution_mm);
/// With that, and the job's threads.
SurfaceOptions surfaceOptions(const Job& setup, double resolution_mm);

}  // namespace proveout
