// The part of a run against its nominal: what is compared, and whose fault a deviation is.
#pragma once

#include <memory>
#include <string>

#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"
#include "removal/compare/exact_part.h"

namespace proveout {

/// The machined part without a grid. Null where the blank's faces are not known (a stock from a file).
Result<std::unique_ptr<ExactPart>> makeExactPart(const StockShape& blank, const RunResult& run);

/// Brings the nominal to the part, where the job asks for it: fills `alignment` of the run. Else, where that
/// could not be done, a sentence that says why: then a comparison would tell nothing.
Result<std::string> alignRun(const Job& job, const Blank& blank, PreparedMesh& nominal, RunResult& run,
                             Progress& progress);

/// Names who made the surface that a finding is about. Where the maker is not told: a motion that reached
/// within `within_mm` of the place.
void blameMaker(const SurfaceMaker& maker, const Vec3& where, double within_mm, const RunSources& sources,
                RunResult& run, Finding& finding);

/// Fills `comparison` of the run and adds its findings. The surface is measured on the mesh and, where that
/// could be off, on the exact part (removal/exact): blank and swept volumes of all clampings, or the section
/// of a turned part. A stock from a file has none.
Status compareRun(const Job& job, const RunSources& sources, const Blank& blank, const PreparedMesh& nominal,
                  RunResult& run, Progress& progress);

}  // namespace proveout
