// Paths of a control for tests: run a text, look at what it made.
#pragma once

#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout::test {

struct ControlPath {
  Toolpath path;
  InterpretSummary summary;

  ControlPath(ControlId control, const std::string& text, const ControlSettings& settings) {
    ToolpathBuilder builder(path);
    summary = interpret(control, MemoryProgramSource("main.nc", text), settings, builder);
  }
  std::size_t count() const { return path.motions.size(); }
  /// The first diagnostic of that severity, or an empty one.
  Diagnostic first(Severity severity) const {
    for (const Diagnostic& d : path.diagnostics.all()) {
      if (d.severity == severity) return d;
    }
    return {};
  }
  std::string error() const { return first(Severity::kError).code; }
  bool tells(const std::string& code, Severity severity) const {
    for (const Diagnostic& d : path.diagnostics.all()) {
      if (d.severity == severity && d.code == code) return true;
    }
    return false;
  }
  bool warns(const std::string& code) const { return tells(code, Severity::kWarning); }
};

}  // namespace proveout::test
