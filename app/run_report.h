// The report of a run, from what it made.
#pragma once

#include "app/session/findings/accounting.h"
#include "app/session/run/run_result.h"
#include "io/report.h"

namespace proveout {

/// Everything but `outputs` and wall time. Error: an input that could be read before cannot be hashed now.
Result<Report> makeReport(const Job& job, const RunResult& run, const RunSources& sources);

/// Paths and removed volumes of all clampings, in their order. Point into `run`.
std::vector<CutPath> cutPaths(const RunResult& run);

ReportComparison reportComparison(const Comparison& comparison, const NominalSpec& nominal);

/// Largest resident size of this process so far, MB.
double peakMemoryMb();

/// The program's version.
std::string versionText();

}  // namespace proveout
