// The grid of a run whose job does not give one.
#pragma once

#include "app/session/forecast/prediction.h"
#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"

namespace proveout {

/// Whether the grid waits for the program: a milled part that is compared with a nominal, no grid in the job,
/// and a blank that has none of its own.
bool choosesGrid(const Job& job, const Blank& blank);

/// Spacing, mm, from the tolerance, the tools that cut and what it costs. Verdict and depths do not depend on
/// it (removal/exact); it decides how small a detail the mesh and the samples hold, and how far facets leave
/// round walls: by no more than half of the smaller tolerance, with at least five cells to the width of each
/// tool. Starts from defaultResolution and goes finer in steps of 1, 2, 5 as long as less than half of the
/// memory and half a minute are predicted, and at most to a tenth. `blank.resolution_mm`: what the blank's
/// thickness asks for.
double chooseResolution(const Job& job, const RunResult& run, const Blank& blank, const Workload& work,
                        double memory_mb);

/// Of a turned part whose job gives none, mm: `h`, or finer, so that the shortest lead of its threads is held
/// by five samples; at most to a tenth.
double threadResolution(const RunResult& run, double h);

}  // namespace proveout
