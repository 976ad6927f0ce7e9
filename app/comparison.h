// The part of a run against its nominal: what is compared, and whose fault a deviation is.
#pragma once

#include "app/pipeline.h"

namespace proveout {

/// Fills `comparison` of the run and adds its findings. The surface is measured on the mesh and, where that could be
/// off, on the exact part (removal/exact): blank and swept volumes of all clampings, or the section of a turned part.
/// A stock from a file has none.
Status compareRun(const Job& job, const RunSources& sources, const Blank& blank, const PreparedMesh& nominal,
                  RunResult& run, Progress& progress);

}  // namespace proveout
