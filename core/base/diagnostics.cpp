#include "core/base/diagnostics.h"

#include <algorithm>
#include <utility>

namespace proveout {

std::string_view severityName(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "error";
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::kError) ++errors_;
  all_.push_back(std::move(diagnostic));
}

namespace {

bool isUtf8Continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Blanks up to `column` (tabs stay tabs, so that the caret stands right in any tab width), then the
/// caret and a tilde for every further character of the range.
std::string caretLine(const std::string& line, int column, int column_end) {
  std::string text;
  const int size = static_cast<int>(line.size());
  for (int i = 0; i < std::min(column - 1, size); ++i) {
    if (!isUtf8Continuation(line[i])) text += line[i] == '\t' ? '\t' : ' ';
  }
  text += '^';
  for (int i = column; i < std::min(column_end - 1, size); ++i) {
    if (!isUtf8Continuation(line[i])) text += '~';
  }
  return text;
}

}  // namespace

std::string formatDiagnostic(const Diagnostic& d) {
  std::string out;
  if (!d.where.file.empty()) out += d.where.file + ":";
  if (d.where.line > 0) {
    out += std::to_string(d.where.line) + ":";
    if (d.where.column > 0) out += std::to_string(d.where.column) + ":";
  }
  if (!out.empty()) out += ' ';
  out += severityName(d.severity);
  if (!d.code.empty()) out += "[" + d.code + "]";
  out += ": " + d.message + "\n";
  if (!d.source_line.empty() && d.where.line > 0) {
    out += "    " + d.source_line + "\n";
    if (d.where.column > 0) out += "    " + caretLine(d.source_line, d.where.column, d.where.column_end) + "\n";
  }
  for (const std::string& note : d.notes) out += "    note: " + note + "\n";
  return out;
}

}  // namespace proveout
