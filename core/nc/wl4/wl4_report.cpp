#include "core/nc/wl4/wl4_report.h"

#include <fmt/core.h>

#include <utility>

namespace proveout::nc {

SourceRef Wl4Report::here() {
  SourceRef at = placeOf(levels_);
  at.origins = recorder_.index();
  return at;
}

Diagnostic Wl4Report::diagnosticAt(Severity severity, std::string code, std::string message,
                                   const SourceRef& at, Columns columns) const {
  const SourceText* const text = levels_.empty() ? nullptr : &programs_.text(at.file);
  Diagnostic d = nc::diagnosticAt(text, at, columns, severity, std::move(code), std::move(message));
  for (std::size_t level = levels_.size(); level-- > 1 && at.line > 0;)
    d.notes.push_back(calledFrom(*levels_[level - 1].program->text, levels_[level - 1].block + 1));
  return d;
}

bool Wl4Report::fail(std::string code, std::string message, Columns at) {
  Diagnostic d = diagnosticAt(Severity::kError, std::move(code), std::move(message), here(), at);
  std::string values;
  for (char letter = 'A'; letter <= 'Z' && !levels_.empty(); ++letter) {
    if (!block_.has(letter)) continue;
    const Columns& c = block_.at(letter);
    const std::string_view text =
        block_.text.substr(static_cast<std::size_t>(c.begin - 1), static_cast<std::size_t>(c.end - c.begin));
    if (text.find_first_of("#(") == std::string_view::npos) continue;
    values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", letter, block_.value(letter));
  }
  if (!values.empty()) d.notes.push_back("values in the block: " + values);
  emitter_.diagnostic(d);
  return false;
}

void Wl4Report::warn(std::string code, std::string message, Columns at, Severity severity) {
  emitter_.diagnostic(diagnosticAt(severity, std::move(code), std::move(message), here(), at));
}

void Wl4Report::warnOnce(const std::string& key, std::string code, std::string message, Columns at) {
  if (told_.insert(key).second) warn(std::move(code), std::move(message), at);
}

bool Wl4Report::contourError(SharedAlarm alarm, std::string_view subject, std::string_view detail,
                             const PathItem& at) {
  static const AlarmTable kTable{
      "wl4",
      {{SharedAlarm::kCorner, 0, "chamfer", "illegal chamfer or rounding"},
       {SharedAlarm::kCornerTooLarge, 0, "chamfer", "chamfer or rounding too large"}}};
  emitter_.diagnostic(diagnosticAt(Severity::kError, kTable.code(alarm),
                                   kTable.message(alarm, subject, detail), at.source, {}));
  return false;
}

void Wl4Report::compError(CompFault fault, const std::string& message, const SourceRef& at) {
  const char* const code = fault == CompFault::kNegativeRadius ? "wl4-negative-radius" : "wl4-compensation";
  emitter_.diagnostic(diagnosticAt(Severity::kError, code, message, at, {}));
}

}  // namespace proveout::nc
