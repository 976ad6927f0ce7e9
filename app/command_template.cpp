// `template`: fills a template or a set in, or lists what there is to fill in.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "core/base/printable.h"
#include "io/atomic_file.h"
#include "io/job/template_files.h"
#include "io/output_guard.h"

namespace proveout {
namespace {

std::string rangeOf(const nc::TemplateParameter& p) {
  if (!p.min && !p.max) return "";
  return (p.min ? fmt::format("{:g}", *p.min) : "") + ".." + (p.max ? fmt::format("{:g}", *p.max) : "");
}

void printParameters(Console& console, const nc::Template& text) {
  console.out << fmt::format("{:<12} {:<10} {:<16} {}\n", "parameter", "default", "range", "meaning");
  for (const nc::TemplateParameter& p : text.parameters) {
    const std::string line =
        fmt::format("{:<12} {:<10} {:<16} {}", "[" + p.name + "]", p.value.value_or("-"),
                    p.min || p.max ? rangeOf(p) : "-", p.meaning.empty() ? "-" : p.meaning);
    console.out << printable(line) << "\n";
  }
}

void printParametersJson(Console& console, const nc::Template& text) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const nc::TemplateParameter& p : text.parameters) {
    nlohmann::ordered_json one = {{"name", p.name}, {"meaning", p.meaning}, {"used", p.used}};
    if (p.value) one["default"] = *p.value;
    if (p.min) one["min"] = *p.min;
    if (p.max) one["max"] = *p.max;
    list.push_back(std::move(one));
  }
  const nlohmann::ordered_json root = {
      {"schema", "proveout.template/1"}, {"template", text.name}, {"parameters", std::move(list)}};
  console.out << jsonPrintable(root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)) << "\n";
}

/// "D=40" of the command line. False after an error.
bool readValues(const TemplateOptions& options, TemplateUse& use, Diagnostics& diagnostics) {
  for (const std::string& pair : options.values) {
    const std::size_t equals = pair.find('=');
    Diagnostic d;
    d.code = "usage";
    if (equals == std::string::npos || equals == 0) {
      d.message = fmt::format("--set takes NAME=VALUE, not '{}'", pair);
    } else if (!use.values.emplace(pair.substr(0, equals), pair.substr(equals + 1)).second) {
      d.message = fmt::format("--set gives [{}] two values", pair.substr(0, equals));
    } else {
      continue;
    }
    diagnostics.add(std::move(d));
  }
  return !diagnostics.hasErrors();
}

int list(const TemplateOptions& options, const TemplateUse& use, Console& console) {
  const Result<std::string> bytes = readWholeFile(options.input, nc::kMaxTemplateBytes);
  if (!bytes) return printError(console, bytes.error());
  Diagnostics diagnostics;
  const std::string name = std::filesystem::path(options.input).filename().string();
  const auto text = nc::readTemplate({name, options.input, *bytes}, use.encoding, diagnostics);
  printDiagnostics(console, diagnostics.all());
  if (!text) return kExitInput;
  if (options.json)
    printParametersJson(console, *text);
  else
    printParameters(console, *text);
  return kExitOk;
}

int write(const std::string& path, const nc::FilledProgram& filled, Console& console) {
  OutputGuard guard;
  for (const ProgramText& file : filled.files) guard.protect("template", file.path);
  if (const Status apart = guard.check(path); !apart) return printError(console, apart.error());
  if (const Status written = writeFileAtomically(path, filled.text()); !written)
    return printError(console, written.error());
  return kExitOk;
}

}  // namespace

int templateCommand(const TemplateOptions& options, Console& console, ConsoleProgress&) {
  TemplateUse use;
  use.encoding = *encodingNamed(options.encoding);
  Diagnostics diagnostics;
  if (options.json && !options.list) return printError(console, inputError("--json goes with --list"));
  if (options.list && (!options.values.empty() || options.output))
    return printError(console, inputError("--list takes no --set and no --output"));
  if (!readValues(options, use, diagnostics)) {
    printDiagnostics(console, diagnostics.all());
    return kExitInput;
  }
  if (options.list) return list(options, use, console);
  const auto filled = fillFile(options.input, use, diagnostics);
  printDiagnostics(console, diagnostics.all());
  if (!filled) return kExitInput;
  if (options.output) return write(*options.output, *filled, console);
  console.out << filled->text();
  return kExitOk;
}

}  // namespace proveout
