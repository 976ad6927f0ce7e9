// Which block of which program made each place of the part.
#pragma once

#include "app/session/run/run_result.h"
#include "io/exchange/deviation_mesh.h"
#include "removal/compare/sample_mesh.h"

namespace proveout {

/// Fills blocks, files and setups of the mesh. Where surfaces of several motions meet, a vertex belongs to
/// the one with the largest triangle there, and rather to any than to the blank. What a clamping before the
/// last left is found on the surface as it was then. The block is the one that findings name: of a cycle's
/// own lines the one that called it.
void addBlocks(const SampleMesh& sample, const RunResult& run, const RunSources& sources,
               DeviationMesh& mesh);

}  // namespace proveout
