// Runs job folders inside this process.
#pragma once

#include <map>
#include <string>

#include "app/session/session.h"
#include "tests/acceptance/program_runner.h"

namespace proveout::soak::second {

using Files = std::map<std::string, std::string>;

/// Errors: the job or a program of it is refused. `saved`: takes the stock that is left, a file.
Result<RunResult> runFolder(const test::Workbench& folder, const Files& files, const std::string& saved = {});

}  // namespace proveout::soak::second
