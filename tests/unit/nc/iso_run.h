// Programs of a control of the ISO family as lines of motions, for tests.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout::test {

/// The tool starts at (0, 0, 0).
inline ControlSettings runAtZero(std::map<std::string, double> parameters = {}) {
  ControlSettings settings;
  settings.start = Vec3::Zero();
  settings.parameters = std::move(parameters);
  return settings;
}

/// A run of one text; the tool starts at (0, 0, 0) unless the settings say otherwise. Rapids of Fanuc-like
/// mills are straight unless the settings name "rapid"; with -1 it is as if they had not named it.
struct IsoRun {
  Toolpath path;
  InterpretSummary summary;

  IsoRun(ControlId control, const std::string& text, const ControlSettings& settings = runAtZero(),
         const std::map<std::string, std::string>& others = {}, const ControlHost& host = {}) {
    MemoryProgramSource source("main.nc", text);
    for (const auto& [name, program] : others) source.add(name, program);
    ToolpathBuilder sink(path);
    ControlSettings straight = settings;
    if (control == ControlId::kFanucMill) straight.parameters.emplace("rapid", 1.0);
    if (straight.parameters.contains("rapid") && straight.parameters.at("rapid") < 0.0)
      straight.parameters.erase("rapid");
    summary = interpret(control, source, straight, sink, nullptr, host);
  }
  /// "R 10 10 0", "F 30 10 0", "A 40 -15 0 c 40 -5 0 -90": kind, end, and of an arc its centre and sweep in
  /// degrees; up to four decimals, in workpiece coordinates. Kinds: R rapid, F feed, A arc by feed, T thread,
  /// Q arc by rapid.
  std::vector<std::string> motions() const {
    std::vector<std::string> all;
    for (const Motion& m : path.motions) {
      std::string line = fmt::format("{} {}", letterOf(m), shown(m.to));
      if (m.arc >= 0) {
        const ArcGeometry& arc = path.arcs[static_cast<std::size_t>(m.arc)];
        line += fmt::format(" c {} {}", shown(arc.center), number(arc.sweep_rad * 180.0 / M_PI));
      }
      all.push_back(line);
    }
    return all;
  }
  Vec3 end() const { return path.motions.empty() ? Vec3::Zero() : path.motions.back().to; }
  /// Of the first error; empty: there is none.
  std::string error() const { return first(Severity::kError).code; }
  std::string message() const { return first(Severity::kError).message; }
  /// Whether a diagnostic below an error has that code.
  bool tells(const std::string& code) const {
    for (const Diagnostic& d : path.diagnostics.all())
      if (d.code == code && d.severity != Severity::kError) return true;
    return false;
  }
  Diagnostic first(Severity severity) const {
    for (const Diagnostic& d : path.diagnostics.all())
      if (d.severity == severity) return d;
    return {};
  }

  static std::string number(double x) {
    std::string text = fmt::format("{:.4f}", x);
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
  }
  static std::string shown(const Vec3& p) {
    return fmt::format("{} {} {}", number(p.x()), number(p.y()), number(p.z()));
  }

 private:
  static char letterOf(const Motion& m) {
    if (m.kind == MotionKind::kThread) return 'T';
    if (m.kind == MotionKind::kRapid) return m.arc >= 0 ? 'Q' : 'R';
    return m.arc >= 0 ? 'A' : 'F';
  }
};

}  // namespace proveout::test
