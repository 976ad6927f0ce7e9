// What a run says on the terminal.
#pragma once

#include <string>

#include "app/console.h"
#include "io/report.h"

namespace proveout {

/// A few lines for stdout: verdict, program, times, volumes, deviations, where the files are.
std::string summaryText(const Report& report, const std::string& folder);

/// The control's diagnostics and the findings on stderr, as a compiler prints them; from a certain number on,
/// the rest is only counted.
void printFindings(Console& console, const Report& report, Severity least);

/// What a command ends with: findings on stderr (errors only where `quiet`), then on stdout the report as
/// JSON or, unless `quiet`, the summary. `folder`: where the results are, empty for none.
void printResult(Console& console, const Report& report, bool quiet, bool json, const std::string& folder);

}  // namespace proveout
