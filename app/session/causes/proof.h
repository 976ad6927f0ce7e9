// Causes of deviations that are proven: with the word or datum put otherwise the finding goes.
#pragma once

#include <vector>

#include "app/session/causes/diagnosis.h"
#include "app/session/run/prepared_run.h"

namespace proveout {

/// Tries what could be wrong behind each finding of the comparison, the likeliest first, and puts what makes
/// it go, or most of it, in the place of its causes (Cause::with, Cause::left_mm). Findings for which nothing
/// helps keep theirs. How much is tried depends on the size of the program alone: the result is the same on
/// every machine. `patches`: those of the findings, whose causes are already guessed.
void proveCauses(const Job& job, const RunSources& sources, const Blank& blank, const TriMesh& nominal,
                 const std::vector<PatchFinding>& patches, RunResult& run, Progress& progress);

}  // namespace proveout
