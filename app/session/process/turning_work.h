// What turning will take, for the prediction: the mesh goes round the profile that the path leaves.
#pragma once

#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"

namespace proveout {

/// Work of a turned job: the grid counts only where one is to be saved.
Workload turningWork(const SetupRun& setup, const Blank& blank);

/// Of a part with threads that goes to the grid: it is round everywhere, hardly a cell is merged.
Workload turnedGridWork(const Blank& blank);

/// Of a turned part that another process goes on with on the grid.
Workload ontoGridWork(const SetupRun& turned, const Blank& blank);

/// How far the facets of a mesh that follows no grid may lie off the part, by `profile_resolution`, mm.
double facetTolerance(const Job& job);

/// The same of a turned part, along the section and around, each; `simplify` may ask for fewer of them.
double turnedFacets(const Job& job);

}  // namespace proveout
