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

}  // namespace proveout
