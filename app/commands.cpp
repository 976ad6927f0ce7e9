#include "app/commands.h"

#include <new>

#include "app/exit_codes.h"
#include "core/base/memory.h"
#include "core/base/printable.h"

namespace proveout {
namespace {

struct Dispatch {
  Console& console;
  ConsoleProgress& progress;
  int operator()(const RunOptions& o) const { return runCommand(o, console, progress); }
  int operator()(const PathOptions& o) const { return pathCommand(o, console, progress); }
  int operator()(const CheckOptions& o) const { return checkCommand(o, console, progress); }
  int operator()(const CompareCommandOptions& o) const { return compareCommand(o, console, progress); }
  int operator()(const RenderCommandOptions& o) const { return renderCommand(o, console, progress); }
  int operator()(const ExplainOptions& o) const { return explainCommand(o, console, progress); }
  int operator()(const TemplateOptions& o) const { return templateCommand(o, console, progress); }
  int operator()(const MachineOptions& o) const { return machineCommand(o, console, progress); }
  int operator()(const CoverageOptions& o) const { return coverageCommand(o, console, progress); }
};

/// Foreign libraries throw; what they throw ends here as a message and an exit code.
int runGuarded(const CommandOptions& command, Console& console, ConsoleProgress& progress) {
  try {
    return std::visit(Dispatch{console, progress}, command);
  } catch (const std::bad_alloc&) {
    progress.clear();
    return printError(console, outOfMemory("not enough memory", "a coarser --resolution needs less"));
  } catch (const std::exception& error) {
    progress.clear();
    return printError(console, {ErrorKind::kInternal, error.what()});
  }
}

}  // namespace

int runCommandLine(const std::vector<std::string>& arguments, Console& console, ConsoleProgress& progress) {
  const CommandLine line = parseCommandLine(arguments);
  console.out << line.output;
  console.err << printableLines(line.errors);
  int code = line.exit_code;
  if (line.command) code = runGuarded(*line.command, console, progress);
  console.out.flush();
  if (!console.out && code != kExitInterrupted) {
    return printError(console, inputError("the results cannot be written to standard output"));
  }
  return code;
}

}  // namespace proveout
