// The deviation from nominal as files for other programs: the part's mesh with deviation, block and tool of
// each vertex (PLY, GLB), and the points over tolerance (CSV).
#pragma once

#include <string>
#include <vector>

#include "app/outputs.h"
#include "app/session/run/run_result.h"
#include "core/base/progress.h"

namespace proveout {

/// "bear-deviation.ply", "bear-deviation.glb", "points.csv". `part`: name of job or part.
std::string deviationFileName(const std::string& part, DeviationOutput output);

/// Writes what the job asks for where the part was compared, and records it in the report. Nothing once
/// `progress` is cancelled.
void writeRunDeviation(const Job& job, const RunResult& run, const RunSources& sources, Progress& progress,
                       StagingFolder& staging, Report& report, OutputFailures& failures);

/// The same of two meshes that were compared: no block is known.
void writePairDeviation(const std::string& part, const TriMesh& machined, const Comparison& comparison,
                        const std::vector<DeviationOutput>& outputs, Progress& progress,
                        StagingFolder& staging, Report& report, OutputFailures& failures);

}  // namespace proveout
