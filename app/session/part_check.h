// The characteristics of the part as a whole that a job asks for.
#pragma once

#include <vector>

#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"

namespace proveout {

/// Measures them, into RunResult::part_features, and adds a finding for each that the part does not keep or
/// that cannot be measured on it. Errors: interrupted, and those of makeExactPart.
Status checkPart(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                 Progress& progress);

/// The rows of the report.
std::vector<ReportCharacteristic> partCharacteristics(const Job& job, const RunResult& run);

}  // namespace proveout
