#include "core/nc/wedm/wedm_report.h"

#include <utility>

namespace proveout::nc {

SourceRef WedmReport::here() {
  SourceRef at;
  if (levels_.empty()) return at;
  at.line = program_.place(levels_.back().block).line + 1;
  at.block = levels_.back().number;
  at.depth = static_cast<decltype(at.depth)>(levels_.size() - 1);
  at.origins = recorder_.index();
  return at;
}

Columns WedmReport::blockColumns() const {
  if (levels_.empty()) return {};
  const WedmProgram::Place& place = program_.place(levels_.back().block);
  const std::string_view line = program_.line(levels_.back().block);
  std::size_t begin = line.find_first_not_of(" \t", place.begin);
  if (begin == std::string_view::npos || begin > place.end) begin = place.begin;
  return {static_cast<int>(begin) + 1, static_cast<int>(place.end) + 1};
}

void WedmReport::tell(Severity severity, const SourceRef& at, Columns columns, std::string code,
                      std::string message) {
  const SourceText* const text = levels_.empty() ? nullptr : &program_.text();
  Diagnostic d = diagnosticAt(text, at, columns, severity, std::move(code), std::move(message));
  for (std::size_t level = levels_.size(); level-- > 1 && at.line > 0;)
    d.notes.push_back(calledFrom(*text, program_.place(levels_[level - 1].block).line + 1));
  if (severity == Severity::kError) ++summary_.errors;
  if (severity == Severity::kWarning) ++summary_.warnings;
  sink_.diagnostic(d);
}

bool WedmReport::fail(std::string code, std::string message, Columns at) {
  tell(Severity::kError, here(), at.begin > 0 ? at : blockColumns(), std::move(code), std::move(message));
  return false;
}

bool WedmReport::failAt(const SourceRef& at, Columns columns, std::string code, std::string message) {
  tell(Severity::kError, at, columns, std::move(code), std::move(message));
  return false;
}

void WedmReport::warn(std::string code, std::string message, Columns at) {
  tell(Severity::kWarning, here(), at.begin > 0 ? at : blockColumns(), std::move(code), std::move(message));
}

void WedmReport::warnOnce(std::string code, std::string message, Columns at) {
  if (told_.insert(code).second) warn(std::move(code), std::move(message), at);
}

}  // namespace proveout::nc
