// What the person at the machine needs for each clamping: blank, fixtures, zero points, tools, pictures.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"
#include "io/report/setup_sheet.h"

namespace proveout {

/// One sheet a clamping. With pictures where the job draws any; what cannot be drawn (a blank that is a saved
/// grid) has none. Tools in the order of their first use with the offsets that the program called for them.
std::vector<SetupSheet> setupSheets(const Job& job, const RunResult& run, Progress& progress);

}  // namespace proveout
