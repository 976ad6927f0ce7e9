// One function a command; each returns the exit code.
#pragma once

#include "app/cli_options.h"
#include "app/console.h"

namespace proveout {

int runCommand(const RunOptions& options, Console& console, ConsoleProgress& progress);
int pathCommand(const PathOptions& options, Console& console, ConsoleProgress& progress);
int checkCommand(const CheckOptions& options, Console& console, ConsoleProgress& progress);
int compareCommand(const CompareCommandOptions& options, Console& console, ConsoleProgress& progress);
int renderCommand(const RenderCommandOptions& options, Console& console, ConsoleProgress& progress);
int explainCommand(const ExplainOptions& options, Console& console, ConsoleProgress& progress);
int templateCommand(const TemplateOptions& options, Console& console, ConsoleProgress& progress);
int coverageCommand(const CoverageOptions& options, Console& console, ConsoleProgress& progress);
int machineCommand(const MachineOptions& options, Console& console, ConsoleProgress& progress);

/// The whole program but for signals: parses, runs, flushes; a result that cannot be written to stdout is an
/// error.
int runCommandLine(const std::vector<std::string>& arguments, Console& console, ConsoleProgress& progress);

}  // namespace proveout
